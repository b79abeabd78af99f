// Commands that a page does not offer: sweeps, which need time and threads, and the list of results.
// They exist and report this.
#include <string>

#include <fmt/format.h>

#include "cli/commands.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

void add(CLI::App& app, const std::string& name, const std::string& description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->allow_extras();
  command->callback([name] {
    throw InputError({.problem = fmt::format("The studio cannot run {}", in_quotes(name)),
                      .remedy = "run the same command with the program flexslip, outside the studio"});
  });
}

}  // namespace

void add_sweep_command(CLI::App& app) { add(app, "sweep", "Many designs (outside the studio)"); }
void add_results_command(CLI::App& app) { add(app, "results", "What every number means (outside the studio)"); }

}  // namespace flexslip
