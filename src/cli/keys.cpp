#include <memory>
#include <string>

#include <fmt/format.h>

#include "answers/all_answers.h"
#include "case/case_keys.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "result/table.h"

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
    throw InputError(
        {.field = "WHAT",
         .expected = "a section (specimen, specimen.cracks, rig, friction, stage, record or sweep), or a key",
         .found = in_quotes(request.section)});
  if (request.output.json)
    write_json(request.output.path, all);
  else
    write_text(request.output.path, text);
}

}  // namespace

void add_keys_command(CLI::App& app) {
  const auto request = std::make_shared<KeysRequest>();
  CLI::App* command = app.add_subcommand("keys", "Every key of a case file: what it holds and what it means");
  command->add_option("section", request->section, "Show only this section or key, such as rig or rig.stiffness")
      ->type_name("WHAT");
  add_output_options(*command, request->output);
  command->get_option("--json")->description("Write JSON instead of text");
  command->footer(
      "The option --set of other commands changes any key.\n\n"
      "Examples:\n"
      "  flexslip keys rig\n"
      "  flexslip simulate case.toml --set rig.stiffness=\"200 N/m\" --set friction.mu0=0.4");
  command->callback([request] { run_keys(*request); });
}

}  // namespace flexslip
