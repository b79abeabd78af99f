// Flags that several commands have: of a test beside its data file, each of which says what a key of a case file says; of an analysis.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "case/case_file.h"
#include "case/case_keys.h"
#include "case/fitted.h"
#include "fibre/supported_state.h"
#include "io/input_error.h"

namespace flexslip {

struct CaseFlag {
  const CaseKey* key;
  std::optional<std::string> value{};
};

// The test that a call describes: a case file, or a data file with flags.
struct CaseRequest {
  std::string file;
  std::vector<CaseFlag> flags{};  // of every key that has one, with the values given
  std::vector<std::string> changes{};
};

// Gives a command --set, which changes keys of its case.
void add_set_option(CLI::App& command, std::vector<std::string>& changes);

// Gives a command the argument FILE, the flags and --set.
void add_case_options(CLI::App& command, CaseRequest& request);

// Is it a case file that the call names? "-" is one if there are no flags.
bool names_case_file(const CaseRequest& request);

// The case named or described, made by the reader of case files, which knows what is allowed.
// Fails:      InputError as read_case; for flags beside a case file.
Test case_of(const CaseRequest& request);

// A complaint about a case in the words of the call.
InputError in_words_of_call(const CaseRequest& request, const InputError& error);

// Supports in spans, as --roller-radius and --thickness state them, if they leave a span and beam theory holds between them.
// Fails:      InputError, naming the flag, where they do not: as a case is refused (case/mechanics.h).
const Supports& within_limits(const Supports& stated);

// Gives a command the options --model, --false-alarms, --suspect-limit and --check-stability.
void add_analysis_options(CLI::App& command, AnalysisChoice& choice);

}  // namespace flexslip
