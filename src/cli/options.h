// Commands and their options in the help, and options of several commands: tests, analyses, files,
// output.
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

// A command and the request that its options fill in.
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

// An option or argument with its value: "-j,--jobs NUMBER", "file FILE".
template <class Value>
CLI::Option* add_option(CLI::App& command, std::string_view option, Value& value, const std::string& meaning) {
  const std::size_t space = option.find(' ');
  return command.add_option(std::string(option.substr(0, space)), value, meaning)
      ->type_name(std::string(option.substr(space + 1)));
}
// A repeatable option.
template <class Value>
CLI::Option* add_repeated(CLI::App& command, std::string_view option, std::vector<Value>& values,
                          const std::string& meaning) {
  return add_option(command, option, values, meaning)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// Checks of numbers that CLI11 lacks: it accepts NaN in any range, and -1 as an unsigned number.
CLI::Validator number_between(double low, double high);
CLI::Validator whole_number();
// A whole number in a range that the help does not show.
inline CLI::Validator count_between(std::size_t least, std::size_t most) {
  return CLI::Range(static_cast<int>(least), static_cast<int>(most)).description("");
}

// ---- the test of a command

// A case file, and changes to it.
struct CaseRequest {
  std::string file;
  std::vector<std::string> changes{};  // values of --set

  Test read() const { return read_case(file, changes); }
};

// Add the argument CASE and --set; or --set only.
void add_case(CLI::App& command, CaseRequest& request, const std::string& meaning = "Case file; - is standard input");
void add_set_option(CLI::App& command, std::vector<std::string>& changes);

struct CaseFlag {
  const CaseKey* key;
  std::optional<std::string> value{};
};

// A case file, or a data file with a flag for each key of its case.
struct TestRequest : CaseRequest {
  std::vector<CaseFlag> flags{};  // every key with a flag, and the values given
};

// Adds the argument FILE, the flags and --set.
void add_test(CLI::App& command, TestRequest& request);

// The test, read by the reader of case files. Errors name the flags of the call.
// Fails:      InputError as read_case and `use`; for flags in addition to a case file.
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

// The supports in spans from --roller-radius and --thickness.
// Fails:      InputError, naming the flag, if no span remains or beam theory does not hold (as in
//             case/mechanics.h).
const Supports& within_limits(const Supports& stated);

// Adds --model, --false-alarms and --suspect-limit.
void add_analysis_options(CLI::App& command, AnalysisChoice& choice);

// ---- reading options of files

struct ReadingFlag {
  const char *name, *meaning;  // "sheet SHEET"
};

// The flags for any file.
inline constexpr std::array flags_of_files{
    ReadingFlag{"sheet SHEET", "Sheet of a workbook (.xlsx), by name or number"},
    ReadingFlag{"encoding NAME", "Encoding of the text: utf-8, utf-16le, utf-16be, cp1252 or shift-jis"},
    ReadingFlag{"separator MARK", "Separator between cells: , ; tab or space"},
    ReadingFlag{"decimal MARK", "Decimal mark: . or ,"},
    ReadingFlag{"thousands MARK", "Thousands separator: . , space ' or none"}};

// Adds flags whose values are stored under their names. `words` must not move.
void add_reading_flags(CLI::App& command, ReadingWords& words, std::span<const ReadingFlag> flags,
                       const std::string& group);

// ---- output

// Fails:      InputError for an output file in a folder that does not exist.
void require_folders_of_outputs();

// Adds an option for an output file, and announces the file (CallFiles) before the command reads
// any input.
CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& path,
                             const std::string& meaning);
void add_output_option(CLI::App& command, std::string& path);

// Add --quiet; --json with a meaning; --output for JSON or `otherwise`.
void add_quiet_flag(CLI::App& command, Output& output);
void add_output_flags(CLI::App& command, Output& output, const std::string& json);
void add_output_options(CLI::App& command, Output& output, std::string_view otherwise = "text");
// Adds --csv-decimal, for commands that write CSV.
void add_csv_option(CLI::App& command, Output& output);

// Add --figure; --figure-width [cm]; --report, and announce its files; --jobs, by default the number
// of cores.
void add_figure_option(CLI::App& command, std::string& path);
void add_figure_width_option(CLI::App& command, double& width);
void add_report_option(CLI::App& command, std::string& folder, const std::string& meaning,
                       void (*announce)(CallFiles&, const std::string& folder, const std::string& option));
void add_threads_option(CLI::App& command, std::string_view option, unsigned& threads, const std::string& meaning);

}  // namespace flexslip
