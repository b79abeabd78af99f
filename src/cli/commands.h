// The commands of the program, one file each.
//
// A command reads its arguments in its callback. It throws InputError for bad input. It throws
// CalculationFailed for an incomplete result, after writing the part that could be computed. main()
// turns both into messages and exit codes.
#pragma once

#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

namespace flexslip {

// Exit code 1.
struct CalculationFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Exit code 130.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void add_state_command(CLI::App& app);
void add_invert_command(CLI::App& app);
void add_equilibrium_command(CLI::App& app);
void add_simulate_command(CLI::App& app);
void add_design_command(CLI::App& app);
void add_fit_command(CLI::App& app);
void add_read_command(CLI::App& app);
void add_campaign_command(CLI::App& app);
void add_sweep_command(CLI::App& app);
void add_modulus_command(CLI::App& app);
void add_studio_command(CLI::App& app);
void add_keys_command(CLI::App& app);
void add_results_command(CLI::App& app);
void add_completions_command(CLI::App& app);

// ---- short and long help (help.cpp): -h shows the common options, --help all of them

// `flexslip help [COMMAND]`, the same as --help.
void add_help_command(CLI::App& app);

// The long help of the program or of one of its commands.
std::string whole_help(const CLI::App& command);

// Gives the program or a command the flag -h, which throws ShortHelp; main() prints the short help.
struct ShortHelp {
  std::string text;
};
void add_short_help(CLI::App& command);

}  // namespace flexslip
