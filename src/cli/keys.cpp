#include <string>

#include <fmt/format.h>

#include "answers/all_answers.h"
#include "case/case_keys.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

struct KeysRequest {
  std::string section;
  Output output;
};

void run_keys(const KeysRequest& request) {
  Json all = Json::array();
  std::string text, section;
  for (const CaseKey& key : case_keys()) {
    const std::string full = fmt::format("{}.{}", key.section, key.name);
    const bool is_asked = key.section == request.section || key.name == request.section || full == request.section;
    if (!request.section.empty() && !is_asked) continue;
    all.push_back(key_fields()(key, {}));
    if (key.section != section) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key.section);
    section = key.section;
    text += fmt::format("  {:<20} {}\n{:23}{}{}\n", key.name, key.meaning, "", what_holds(key),
                        key.example.empty() ? "" : fmt::format("; {} = {}", key.name, key.example));
  }
  if (all.empty())
    throw InputError({.field = "WHAT",
                      .problem = fmt::format("{} is neither a section ({}) nor a key", in_quotes(request.section),
                                             in_words(case_sections(), "or"))});
  write_words(
      request.output, [&] { return all; }, [&] { return text; });
}

}  // namespace

void add_keys_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "keys", "Every key of a case file: what it holds and what it means", run_keys);
  add_option(command, "section WHAT", request.section, "Show only this section or key, such as rig or rig.stiffness");
  add_output_options(command, request.output);
  command.footer(
      "The option --set of other commands changes any key.\n\n"
      "Examples:\n"
      "  flexslip keys rig\n"
      "  flexslip simulate case.toml --set rig.stiffness=\"200 N/m\" --set friction.mu0=0.4");
}

}  // namespace flexslip
