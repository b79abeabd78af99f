#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "report/document.h"

namespace flexslip {
namespace {

// The options in the short help of commands with many options. Other commands show all.
struct Everyday {
  std::string_view command;
  std::vector<std::string_view> options;
};

const std::vector<Everyday>& everyday() {
  static const std::vector<Everyday> commands{
      {"fit",
       {"--report", "--full", "--json", "--set", "--span", "--stiffness", "--diameter", "--modulus", "--stage",
        "--force"}},
      {"campaign", {"--common", "--report", "--full", "--set", "--jobs", "--json"}},
      {"read",
       {"--output", "--full", "--json", "--specimen", "--sheet", "--crosshead", "--deflection", "--force",
        "--decimal"}},
      {"modulus",
       {"--full", "--json", "--set", "--span", "--stiffness", "--diameter", "--width", "--height", "--stage", "--force",
        "--displacement"}},
      {"invert", {"--output", "--json", "--set", "--roller-radius", "--thickness"}},
      {"design", {"--over", "--figure", "--set", "--output", "--json"}},
      {"simulate", {"--output", "--noise", "--seed", "--figure", "--set", "--json"}},
      {"state", {"--S", "--w", "--q", "--roller-radius", "--thickness", "--output", "--json"}}};
  return commands;
}

std::string name_in_usage(const CLI::App& command) {
  return command.get_parent() ? "flexslip " + command.get_name() : command.get_name();
}

// Wraps descriptions and aligns their lines; the footer keeps its line breaks.
std::string in_lines(std::string_view help, std::string_view footer, std::size_t column) {
  std::string out;
  const std::size_t end = footer.empty() ? help.size() : help.rfind(footer);
  for (std::size_t at = 0; at < end;) {
    const std::string_view line = help.substr(at, std::min(help.find('\n', at), end) - at);
    const std::size_t begin = line.starts_with("  ") ? std::min(column, line.size()) : 0;
    out += line.size() > begin ? wrapped(line.substr(begin), std::string(begin, ' '), line.substr(0, begin))
                               : fmt::format("{}\n", line);
    at += line.size() + 1;
  }
  return out + std::string(help.substr(end));
}

// Changes the command, which does not run afterwards: other options leave their groups, and the
// footer is reduced to the examples.
std::string short_help(CLI::App& command) {
  const auto known = std::find_if(everyday().begin(), everyday().end(),
                                  [&](const Everyday& each) { return each.command == command.get_name(); });
  if (known != everyday().end()) {
    std::vector<const CLI::Option*> shown{command.get_help_ptr()};
    for (const std::string_view name : known->options) shown.push_back(command.get_option(std::string(name)));
    for (CLI::Option* option : command.get_options())
      if (!option->get_positional() && std::find(shown.begin(), shown.end(), option) == shown.end()) option->group("");
  }
  const std::string footer = command.get_footer();
  const std::size_t begin = std::min(footer.find("Examples:"), footer.size());
  const std::string examples = footer.substr(begin, footer.find("\n\n", begin) - begin);
  command.footer(fmt::format("{}{}{} --help explains {}.", examples, examples.empty() ? "" : "\n\n",
                             name_in_usage(command), known != everyday().end() ? "all options" : "more"));
  return whole_help(command);
}

struct HelpRequest {
  const CLI::App* app;
  std::string command;
};

void run_help(const HelpRequest& request) {
  if (request.command.empty()) return write_text("-", whole_help(*request.app));
  std::vector<std::string> names;
  for (const CLI::App* each : request.app->get_subcommands([](const CLI::App*) { return true; })) {
    if (each->get_name() == request.command) return write_text("-", whole_help(*each));
    names.push_back(each->get_name());
  }
  throw InputError(
      {.field = "COMMAND",
       .problem = fmt::format("{} is not one of the commands {}", in_quotes(request.command), listed(names)),
       .remedy = did_you_mean(request.command, names)});
}

}  // namespace

std::string whole_help(const CLI::App& command) {
  const auto formatter = command.get_formatter();
  return in_lines(formatter->make_help(&command, name_in_usage(command), CLI::AppFormatMode::Normal),
                  command.get_footer(), formatter->get_column_width());
}

void add_short_help(CLI::App& command) {
  command.add_flag_function(
      "-h", [&command](std::int64_t /*times*/) { throw ShortHelp{short_help(command)}; },
      "Print the options that people use, and exit");
}

void add_help_command(CLI::App& app) {
  const auto [command, request] = add_command(app, "help", "Explain a command, as its --help does", run_help);
  request.app = &app;
  add_option(command, "command COMMAND", request.command, "Command to explain; without it, the whole program");
  command.footer(
      "Examples:\n"
      "  flexslip help\n"
      "  flexslip help fit");
}

}  // namespace flexslip
