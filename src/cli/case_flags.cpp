#include "cli/case_flags.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "case/mechanics.h"
#include "case/toml.h"
#include "cli/numbers.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

// What a flag takes, as its help shows it.
std::string type_of(const CaseKey& key) {
  switch (key.holds) {
    case Holds::title:
      return "COLUMN";
    case Holds::whole_number:
      return "NUMBER";
    case Holds::place:
      return "ROW or LENGTH";
    case Holds::word:
      return std::string(key.words);
    case Holds::quantity:
    case Holds::estimate: {
      std::string name(key.kind->name.substr(key.kind->name.rfind(' ') + 1));  // "a length"
      std::transform(name.begin(), name.end(), name.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
      return key.words.empty() ? name : fmt::format("{}|{}", name, key.words);
    }
    default:
      return "TEXT";
  }
}

std::string capitalised(std::string_view phrase) {
  std::string text(phrase);
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

bool is_whole(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool has_flags(const CaseRequest& request) {
  return std::any_of(request.flags.begin(), request.flags.end(),
                     [](const CaseFlag& flag) { return flag.value.has_value(); });
}

Test case_of_flags(const CaseRequest& request) {
  std::string text;
  for (const std::string_view section : {"specimen", "rig", "record"}) {
    std::string body;
    for (const auto& [key, value] : request.flags)
      if (key->section == section && value) {
        const bool is_number = key->holds == Holds::whole_number || (key->holds == Holds::place && is_whole(*value));
        body += fmt::format("{} = {}\n", key->name, is_number ? *value : toml_text(*value));
      }
    if (section == "record") body += fmt::format("file = {}\n", toml_text(request.file));
    if (!body.empty()) text += fmt::format("[{}]\n{}", section, body);
  }
  return read_case(text, "", request.changes);
}

}  // namespace

void add_set_option(CLI::App& command, std::vector<std::string>& changes) {
  command
      .add_option(
          "--set", changes,
          "Change a key of the case, as in rig.stiffness=\"90 N/m\"; may be repeated. flexslip keys lists all keys")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_case_options(CLI::App& command, CaseRequest& request) {
  for (const CaseKey& key : case_keys())
    if (!key.flag.empty()) request.flags.push_back({&key});
  command
      .add_option("file", request.file,
                  "Case file (.toml), or a data file that the flags below describe; - is standard input")
      ->type_name("FILE")
      ->required();
  add_set_option(command, request.changes);
  for (auto& [key, value] : request.flags) {
    CLI::Option* option = command.add_option(std::string(key->flag), value, capitalised(key->meaning))
                              ->type_name(type_of(*key))
                              ->group("A data file instead of a case");
    if (key->holds == Holds::whole_number) option->check(CLI::TypeValidator<unsigned>(""));
  }
}

bool names_case_file(const CaseRequest& request) {
  return request.file.ends_with(".toml") || (request.file == "-" && !has_flags(request));
}

Test case_of(const CaseRequest& request) {
  if (!names_case_file(request)) return case_of_flags(request);
  if (has_flags(request))
    throw InputError({.file = request.file,
                      .expected = "a data file, as flags describe the test",
                      .found = "a case file, which describes the test itself",
                      .remedy = "write the change into the case file, or pass it as --set"});
  return read_case(request.file, request.changes);
}

InputError in_words_of_call(const CaseRequest& request, const InputError& error) {
  if (names_case_file(request)) return error;
  InputFault fault = error.fault;
  if (fault.key == "rig") fault.key = "rig.span";
  for (const auto& [key, value] : request.flags) {
    if (fault.key != fmt::format("{}.{}", key->section, key->name)) continue;
    fault.field = key->flag;
    if (fault.kind == FaultKind::missing) {
      fault.remedy = fmt::format("add {} {}, or describe the test in a case file (.toml)", key->flag, type_of(*key));
    }
  }
  if (fault.file.empty()) fault.line = 0;
  return InputError(fault);
}

const Supports& within_limits(const Supports& stated) {
  if (!(stated.half_depth >= 0 && 2 * stated.half_depth < thickest))
    throw InputError({.field = "--thickness",
                      .expected = fmt::format("0 or more, and less than {:g} spans, for beam theory to hold", thickest),
                      .found = fmt::format("{:g} spans", 2 * stated.half_depth),
                      .remedy = "check its unit, and the span"});
  if (!(stated.radius >= 0 && stated.radius + stated.half_depth < widest_supports))
    throw InputError(
        {.field = "--roller-radius",
         .expected = fmt::format("0 or more, and with half the thickness less than {:g} spans", widest_supports),
         .found = fmt::format("{:g} and {:g} spans", stated.radius, stated.half_depth),
         .remedy = "check the units of both, and the span"});
  return stated;
}

void add_analysis_options(CLI::App& command, AnalysisChoice& choice) {
  command.add_option("--model", choice.model, "Friction model to fit: roughness, the default, or one of the paper's")
      ->type_name("NAME")
      ->check(CLI::IsMember(model_names()));
  command
      .add_option("--false-alarms", choice.options.drops.false_alarms_per_test,
                  "Average number of drops expected in a test of this length without slips")
      ->type_name("NUMBER")
      ->check(number_between(1e-6, 1e3))
      ->capture_default_str();
  command.add_option("--suspect-limit", choice.options.suspect_limit, "Limit above which friction is implausible")
      ->type_name("NUMBER")
      ->check(number_between(0.01, 100))
      ->capture_default_str();
  command.add_flag("--check-stability", choice.options.check_stability,
                   "Fit again with the force changed in its ninth digit, and check that the answer stays the same");
}

}  // namespace flexslip
