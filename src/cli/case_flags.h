// Flags that describe a test beside its data file: each says what a key of a case file says.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "cases/case_file.h"
#include "io/input_error.h"

namespace flexslip {

struct CaseFlag {
  std::string_view section, key, flag;
  std::string_view help;
  std::string_view type;
  std::optional<std::string> value{};
};

// The test that a call describes: a case file, or a data file with flags.
struct CaseRequest {
  std::string file;
  std::vector<CaseFlag> flags;  // as all_case_flags, with the values given
};

std::vector<CaseFlag> all_case_flags();

// Gives a command the argument FILE and the flags.
void add_case_options(CLI::App& command, CaseRequest& request);

// Is it a case file that the call names? "-" is one if there are no flags.
bool names_case_file(const CaseRequest& request);

// The case named or described, made by the reader of case files, which knows what is allowed.
// Fails:      InputError as read_case; for flags beside a case file.
Case case_of(const CaseRequest& request);

// A complaint about a case in the words of the call.
InputError in_words_of_call(const CaseRequest& request, const InputError& error);

}  // namespace flexslip
