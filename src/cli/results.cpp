#include <string>

#include <fmt/format.h>

#include "answers/all_answers.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

struct ResultsRequest {
  std::string command;
  Output output;
};

std::string text_of(const AnswerDescription& answer) {
  std::string text = fmt::format("{}: {}\n", answer.command, answer.what);
  for (const ResultLine& line : lines_of(answer))
    text += fmt::format("  {:<44} {}{}\n", line.key, line.meaning,
                        line.unit.empty() || line.unit == "1" ? "" : fmt::format(" [{}]", line.unit));
  return text;
}

void run_results(const ResultsRequest& request) {
  Json all = Json::array();
  std::string text;
  for (const AnswerDescription& answer : all_answers()) {
    if (!request.command.empty() && answer.command.substr(0, answer.command.find_first_of(" :,")) != request.command)
      continue;
    Json lines = Json::array();
    for (const ResultLine& line : lines_of(answer)) lines.push_back(line_fields()(line, {}));
    all.push_back({{"command", answer.command}, {"what", answer.what}, {"table", answer.is_table}, {"lines", lines}});
    text += (text.empty() ? "" : "\n") + text_of(answer);
  }
  if (all.empty())
    throw InputError({.field = "COMMAND",
                      .problem = fmt::format("{} is not a command that writes numbers, such as fit or simulate",
                                             in_quotes(request.command))});
  write_words(
      request.output, [&] { return all; }, [&] { return text; });
}

}  // namespace

void add_results_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "results", "Every key and column that the commands write: its unit and what it means", run_results);
  add_option(command, "command COMMAND", request.command, "Show only this command, such as fit");
  add_output_options(command, request.output);
  command.footer(
      "In JSON an estimate holds value, standard_error, interval95 and unit; [] is an item of a list, * is\n"
      "any name. In tables an estimate has four columns: NAME, NAME_standard_error, NAME_low and NAME_high.\n\n"
      "Examples:\n"
      "  flexslip results fit\n"
      "  flexslip results simulate --json");
}

}  // namespace flexslip
