#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/version.h"
#include "io/call_files.h"
#include "io/input_error.h"
#include "io/text.h"
#include "platform/terminal.h"

namespace flexslip {
namespace {

constexpr int exit_not_calculated = 1;
constexpr int exit_wrong_input = 2;

int complain(std::string_view message, int exit_code) {
  std::cerr << "flexslip: ";
  for (std::size_t begin = 0; begin <= message.size();) {
    const std::size_t end = std::min(message.find('\n', begin), message.size());
    std::cerr << printable(message.substr(begin, end - begin)) << '\n';
    begin = end + 1;
  }
  return exit_code;
}

// The command on the command line.
const CLI::App& innermost(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  return given.empty() ? app : innermost(*given.front());
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string with_guess(const std::string& message, std::string_view word, const std::vector<std::string>& names) {
  const std::string guess = did_you_mean(word, names);
  return guess.empty() ? message : fmt::format("{}; {}", message, guess);
}

// The error of the call, and the remedy.
std::string explained(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = innermost(app);
  const bool is_program = &command == &app;
  const std::string program = is_program ? "flexslip" : fmt::format("flexslip {}", command.get_name());
  const std::string help = fmt::format(" ({} --help shows how)", program);

  const std::vector<std::string> unknown = app.remaining(true);
  if (!unknown.empty()) {
    const std::string word = unknown.front().substr(0, unknown.front().find('='));
    if (word.starts_with('-'))
      return with_guess(fmt::format("{} has no option {}", program, in_quotes(word)), word, option_names(command)) +
             help;
    if (is_program)
      return with_guess(fmt::format("unknown command {}", in_quotes(word)), word, command_names(app)) + help;
    return fmt::format("{} takes no further argument, but was given {}", program, in_quotes(word)) + help;
  }
  if (is_program && command.get_subcommands().empty())
    return fmt::format("No command is given; the commands are {}", listed(command_names(app))) + help;
  std::string message = error.what();
  if (const std::string_view unread = "Could not convert: "; message.starts_with(unread))
    message = fmt::format("{} is not a number that this option takes", message.substr(unread.size()));
  for (char& c : message)
    if (c == '\n') c = ' ';
  return fmt::format("{}: {}", command.get_name(), message) + help;
}

int run(int argc, char** argv) {
  CLI::App app(
      "What a sawtooth in a three-point bending test means: friction at the supports, determined from the force curve");
  app.name("flexslip");
  app.set_help_flag("--help", "Print all options and exit");
  app.set_version_flag("--version", version_in_words());
  app.require_subcommand(1);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->column_width(28);
  app.footer(
      "flexslip COMMAND -h shows the usual options of a command, flexslip COMMAND --help all of them.\n\n"
      "Examples:\n"
      "  flexslip fit examples/simulated/case.toml --report report\n"
      "                            fits the shipped example and writes report/report.html\n"
      "  flexslip simulate case.toml --output test.csv\n"
      "                            computes what a test would measure\n\n"
      "Exit status:\n"
      "  0  done\n"
      "  1  the calculation did not succeed, or the verdict is CHECK INPUT or NO ANSWER; what could\n"
      "     be calculated is written\n"
      "  2  the input or the call was wrong\n"
      "  130  interrupted");
  for (const auto add_command :
       {add_fit_command, add_campaign_command, add_read_command, add_modulus_command, add_invert_command,
        add_design_command, add_simulate_command, add_equilibrium_command, add_sweep_command, add_state_command,
        add_studio_command, add_keys_command, add_results_command, add_completions_command, add_help_command})
    add_command(app);
  add_short_help(app);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->group("Commands");
    add_short_help(*command);
    command->parse_complete_callback(require_folders_of_outputs);
  }

  for (const char* const word : std::span(argv, static_cast<std::size_t>(argc)))
    if (printable(word).find("\uFFFD") != std::string::npos)
      return complain(fmt::format("{}: This name is not in UTF-8. Rename the file.", in_quotes(printable(word))),
                      exit_wrong_input);

  // A shell can write it to a file.
  std::error_code elsewhere;
  if (const auto file = std::filesystem::canonical("/dev/stdout", elsewhere); !elsewhere)
    files_of_this_call().writes(file, "standard output");
  try {
    app.parse(argc, argv);
    return EXIT_SUCCESS;
  } catch (const ShortHelp& help) {
    std::cout << help.text;
    return EXIT_SUCCESS;
  } catch (const CLI::CallForHelp&) {
    std::cout << whole_help(innermost(app));
    return EXIT_SUCCESS;
  } catch (const CLI::Success& version) {
    return app.exit(version);
  } catch (const CLI::ParseError& error) {
    return complain(explained(app, error), exit_wrong_input);
  } catch (const CalculationFailed& error) {
    return complain(error.what(), exit_not_calculated);
  } catch (const Interrupted& error) {
    return complain(error.what(), exit_interrupted);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), exit_wrong_input);
  } catch (const InputError& error) {
    for (const std::string& line : error.lines()) complain(line, exit_wrong_input);
    return exit_wrong_input;
  } catch (const OutputClash& error) {
    return complain(error.what(), exit_wrong_input);
  }
}

}  // namespace
}  // namespace flexslip

int main(int argc, char** argv) {
  flexslip::end_with_reader();
  try {
    return flexslip::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return flexslip::complain("this computer has not enough memory for that", flexslip::exit_not_calculated);
  } catch (const std::exception& error) {
    return flexslip::complain(error.what(), flexslip::exit_not_calculated);
  }
}
