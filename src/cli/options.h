// Commands and their options as their help shows them, and those that several commands have: of a test, its case or its data file; of an analysis; of
// what is written.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "case/case_file.h"
#include "case/case_keys.h"
#include "case/fitted.h"
#include "cli/output.h"
#include "fibre/supported_state.h"
#include "instruments/export.h"
#include "io/call_files.h"
#include "io/input_error.h"

namespace flexslip {

// A command, and what its options fill in.
template <class Request>
struct NewCommand {
  CLI::App& command;
  Request& request;
};
template <class Request>
NewCommand<Request> add_command(CLI::App& app, const std::string& name, const std::string& meaning,
                                void (*run)(const Request&)) {
  const auto request = std::make_shared<Request>();
  CLI::App* command = app.add_subcommand(name, meaning);
  command->callback([request, run] { run(*request); });
  return {*command, *request};
}

// An option, or an argument, with what it takes: "-j,--jobs NUMBER", "file FILE".
template <class Value>
CLI::Option* add_option(CLI::App& command, std::string_view option, Value& value, const std::string& meaning) {
  const std::size_t space = option.find(' ');
  return command.add_option(std::string(option.substr(0, space)), value, meaning)
      ->type_name(std::string(option.substr(space + 1)));
}
// One that may be repeated.
template <class Value>
CLI::Option* add_repeated(CLI::App& command, std::string_view option, std::vector<Value>& values,
                          const std::string& meaning) {
  return add_option(command, option, values, meaning)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// What numbers options take, beyond what CLI11 checks: NaN lies in each of its ranges, and -1 is a whole number without a sign.
CLI::Validator number_between(double low, double high);
CLI::Validator whole_number();
// A whole number in a range of which the help says nothing.
inline CLI::Validator count_between(std::size_t least, std::size_t most) {
  return CLI::Range(static_cast<int>(least), static_cast<int>(most)).description("");
}

// ---- The test that a command is about

// A case file, and what is changed of it.
struct CaseRequest {
  std::string file;
  std::vector<std::string> changes{};  // of keys: --set

  Test read() const { return read_case(file, changes); }
};

// Gives a command the argument CASE, and --set; and --set alone.
void add_case(CLI::App& command, CaseRequest& request, const std::string& meaning = "Case file; - is standard input");
void add_set_option(CLI::App& command, std::vector<std::string>& changes);

struct CaseFlag {
  const CaseKey* key;
  std::optional<std::string> value{};
};

// A case file, or a data file with flags, each of which says what a key of a case file says.
struct TestRequest : CaseRequest {
  std::vector<CaseFlag> flags{};  // of every key that has one, with the values given
};

// Gives a command the argument FILE, the flags and --set.
void add_test(CLI::App& command, TestRequest& request);

// What comes of the test, made by the reader of case files, which knows what is allowed. A complaint about it is in the words of the call.
// Fails:      InputError as read_case and `use`; for flags beside a case file.
Test test_of(const TestRequest& request);
InputError in_words_of_call(const TestRequest& request, const InputError& error);
template <class Use>
auto with_test(const TestRequest& request, Use use) {
  try {
    return use(test_of(request));
  } catch (const InputError& error) {
    throw in_words_of_call(request, error);
  }
}

// Supports in spans, as --roller-radius and --thickness state them, if they leave a span and beam theory holds between them.
// Fails:      InputError, naming the flag, where they do not: as a case is refused (case/mechanics.h).
const Supports& within_limits(const Supports& stated);

// Gives a command the options --model, --false-alarms and --suspect-limit.
void add_analysis_options(CLI::App& command, AnalysisChoice& choice);

// ---- How a file of readings or of heights is read

struct ReadingFlag {
  const char *name, *meaning;  // "sheet SHEET"
};

// Those of any file.
inline constexpr std::array flags_of_files{
    ReadingFlag{"sheet SHEET", "Sheet of a workbook (.xlsx), by name or number"},
    ReadingFlag{"encoding NAME", "Encoding of the text: utf-8, utf-16le, utf-16be, cp1252 or shift-jis"},
    ReadingFlag{"separator MARK", "Separator between cells: , ; tab or space"},
    ReadingFlag{"decimal MARK", "Decimal mark: . or ,"},
    ReadingFlag{"thousands MARK", "Thousands separator: . , space ' or none"}};

// Gives a command flags whose words are kept by their names. The words must stay where they are.
void add_reading_flags(CLI::App& command, ReadingWords& words, std::span<const ReadingFlag> flags,
                       const std::string& group);

// ---- What is written

// Gives a command an option that names a file to write, and announces the file (CallFiles) before the command reads any.
CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& path,
                             const std::string& meaning);
void add_output_option(CLI::App& command, std::string& path);

// Gives a command the option --quiet; with --json, of this meaning; and with --output, where without --json it writes `otherwise`.
void add_quiet_flag(CLI::App& command, Output& output);
void add_output_flags(CLI::App& command, Output& output, const std::string& json);
void add_output_options(CLI::App& command, Output& output, std::string_view otherwise = "text");

// Gives a command the option --figure; --report, whose files are announced so; and a number of threads, as many as there are cores.
void add_figure_option(CLI::App& command, std::string& path);
void add_report_option(CLI::App& command, std::string& folder, const std::string& meaning,
                       void (*announce)(CallFiles&, const std::string& folder, const std::string& option));
void add_threads_option(CLI::App& command, std::string_view option, unsigned& threads, const std::string& meaning);

}  // namespace flexslip
