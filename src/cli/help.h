// The two lengths of help: -h shows the options that people use, --help all of them.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace flexslip {

// Thrown when -h is given; main() prints it.
struct ShortHelp {
  std::string text;
};

// What --help says of the program, or of one of its commands.
std::string whole_help(const CLI::App& command);

// Gives the program, or one of its commands, the flag -h.
void add_short_help(CLI::App& command);

// `flexslip help [COMMAND]`: what --help says.
void add_help_command(CLI::App& app);

}  // namespace flexslip
