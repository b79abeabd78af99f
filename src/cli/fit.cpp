#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cases/fitted_test.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "report/fit_json.h"
#include "report/fit_text.h"
#include "report/report.h"

namespace flexslip {
namespace {

// A flag that says what a key of a case file says.
struct CaseFlag {
  std::string_view section, key, flag;
  std::string_view help;
  std::string_view type;
  std::optional<std::string> value{};
};

std::vector<CaseFlag> case_flags() {
  return {
      {"specimen", "diameter", "--diameter", "Of a round specimen", "LENGTH"},
      {"specimen", "width", "--width", "Of a rectangular specimen, with --height", "LENGTH"},
      {"specimen", "height", "--height", "In the direction of bending", "LENGTH"},
      {"specimen", "modulus", "--modulus", "Young's modulus; not given: from the initial slope", "PRESSURE"},
      {"specimen", "bending_stiffness", "--bending-stiffness",
       "EI, instead of section and modulus; fit: from the initial slope", "STIFFNESS"},
      {"rig", "span", "--span", "Distance of the supports", "LENGTH"},
      {"rig", "stiffness", "--stiffness", "Of whatever carries the load cell; inf for displacement control",
       "STIFFNESS"},
      {"record", "stage", "--stage", "Column of the stage (crosshead) displacement, \"w_s [mm]\"", "COLUMN"},
      {"record", "deflection", "--deflection", "Column of the deflection at midspan", "COLUMN"},
      {"record", "force", "--force", "Column of the force, \"F [N]\"", "COLUMN"},
      {"record", "contact", "--contact",
       "Displacement at first contact; not given: found if the record begins before it", "LENGTH"},
      {"record", "decimal", "--decimal", "Decimal mark of the file, . or ,", "CHARACTER"},
  };
}

struct FitRequest {
  std::string file;
  std::vector<CaseFlag> flags = case_flags();
  std::optional<unsigned> until;
  std::vector<std::string> models;
  double false_alarms = DropOptions{}.false_alarms_per_test;
  double suspect_limit = AnalysisOptions{}.suspect_limit;
  std::string profile, curves, report;
  Output output;
};

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += byte < 0x20 || byte == 0x7f ? fmt::format("\\u{:04x}", byte) : std::string(1, c);
  }
  return quoted + '"';
}

bool has_flags(const FitRequest& request) {
  for (const auto& flag : request.flags)
    if (flag.value) return true;
  return request.until.has_value();
}

// The case that the flags describe, made by the reader of case files, which knows what is allowed.
Case case_of_flags(const FitRequest& request) {
  std::string text;
  for (const std::string_view section : {"specimen", "rig", "record"}) {
    std::string body;
    for (const auto& flag : request.flags)
      if (flag.section == section && flag.value) body += fmt::format("{} = {}\n", flag.key, toml_string(*flag.value));
    if (section == "record") {
      body += fmt::format("file = {}\n", toml_string(request.file));
      if (request.until) body += fmt::format("until = {}\n", *request.until);
    }
    if (!body.empty()) text += fmt::format("[{}]\n{}", section, body);
  }
  return read_case(text, "");
}

// A complaint about a case in the words of the call.
InputError in_flags(const InputError& error) {
  InputFault fault = error.fault;
  for (const auto& flag : case_flags()) {
    if (fault.field != fmt::format("[{}] {}", flag.section, flag.key)) continue;
    fault.field = flag.flag;
    if (fault.expected == "it in the file") {
      fault.expected = "this flag, as the file is no case";
      fault.remedy = fmt::format("add {} {}, or describe the test in a case file (.toml)", flag.flag, flag.type);
    }
  }
  if (fault.file.empty()) fault.line = 0;
  return InputError(fault);
}

const ProfileModel* model_named(std::string_view name) {
  static constexpr ProfileModel all[] = {ProfileModel::constant, ProfileModel::drift, ProfileModel::sinusoid,
                                         ProfileModel::sinusoids};
  for (const auto& model : all)
    if (name_of(model) == name) return &model;
  return nullptr;
}

// The models of the call, or those of a case that lists them without parameters: with parameters it says how to simulate.
std::vector<ProfileModel> models_of(const FitRequest& request, const Case& input) {
  std::vector<ProfileModel> models;
  const auto add = [&](ProfileModel model) {
    for (const auto known : models)
      if (known == model) return;
    models.push_back(model);
  };
  for (const auto& name : request.models) add(*model_named(name));
  if (!models.empty() || !input.friction) return models;
  if (input.friction->profile) {
    note(request.output, "the parameters in [friction] are for simulating; the fit considers all models");
    return models;
  }
  for (const auto model : input.friction->models) switch (model) {
      case FrictionModel::constant:
        add(ProfileModel::constant);
        break;
      case FrictionModel::drift:
        add(ProfileModel::drift);
        break;
      case FrictionModel::sinusoid:
        add(ProfileModel::sinusoid);
        break;
      case FrictionModel::sinusoids:
        add(ProfileModel::sinusoids);
        break;
      case FrictionModel::table:
      case FrictionModel::rough:
        throw wrong_value(input, "friction.model", "models to fit: constant, drift, sinusoid, sinusoids",
                          model == FrictionModel::table ? "'table'" : "'rough'");
    }
  return models;
}

std::string what_failed(const FittedTest& test, const std::string& status) {
  if (status == "too_few_points")
    return fmt::format("{}: fewer than 20 rows with a deflection beyond a twentieth of the span: they tell no friction",
                       test.measurement.file);
  if (status == "no_initial_slope")
    return fmt::format(
        "{}: the force does not rise where the record begins, so it tells no bending stiffness: state it",
        test.measurement.file);
  if (status == "not_found")
    return fmt::format(
        "{}: no wave fits often enough into the length drawn in; allow the model 'drift' or 'constant' too",
        test.measurement.file);
  return fmt::format(
      "{}: the fit of the model '{}' did not converge: its values are those reached, its errors too small",
      test.measurement.file, name_of(chosen_model(test).model));
}

void run_fit(const FitRequest& request) {
  const bool is_case = request.file.ends_with(".toml") || (request.file == "-" && !has_flags(request));
  if (is_case && has_flags(request))
    throw InputError({.file = request.file,
                      .expected = "a data file beside flags that describe the test",
                      .found = "a case file, which describes it",
                      .remedy = "write the change into the case file"});
  FittedTest test = [&] {
    try {
      const Case input = is_case ? read_case(request.file) : case_of_flags(request);
      AnalysisOptions options;
      options.drops.false_alarms_per_test = request.false_alarms;
      options.suspect_limit = request.suspect_limit;
      if (auto models = models_of(request, input); !models.empty()) options.fit.models = std::move(models);
      return fit_test(input, options);
    } catch (const InputError& error) {
      if (is_case) throw;
      throw in_flags(error);
    }
  }();

  if (!request.profile.empty()) write_profile(request.profile, test);
  if (!request.curves.empty()) write_curves(request.curves, test);
  if (!request.report.empty() && write_report(request.report, test) == DrawStatus::no_gnuplot)
    note(request.output, "gnuplot is not installed: the report has no pictures, but their scripts and data");
  if (request.output.json)
    write_json(request.output.path, fit_json(test));
  else
    write_text(request.output.path, fit_text(test));
  const std::string status = status_of(test);
  if (status != "ok") throw CalculationFailed(what_failed(test, status));
}

}  // namespace

void add_fit_command(CLI::App& app) {
  const auto request = std::make_shared<FitRequest>();
  CLI::App* command =
      app.add_subcommand("fit", "What friction a measured test shows, where along the specimen, how certainly");
  command
      ->add_option("file", request->file,
                   "Case file (.toml), or a data file described by the flags below; - is standard input")
      ->type_name("FILE")
      ->required();
  for (auto& flag : request->flags)
    command->add_option(std::string(flag.flag), flag.value, std::string(flag.help))
        ->type_name(std::string(flag.type))
        ->group("A data file instead of a case");
  command->add_option("--until", request->until, "Last row before failure, counted from 1; not given: found")
      ->type_name("ROW")
      ->group("A data file instead of a case");
  command->add_option("--model", request->models, "Consider only this friction model; may be repeated")
      ->type_name("NAME")
      ->check(CLI::IsMember({"constant", "drift", "sinusoid", "sinusoids"}));
  command
      ->add_option("--false-alarms", request->false_alarms,
                   "Drops to be expected in a test of this length without slips")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--suspect-limit", request->suspect_limit, "Friction above it is implausible")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--profile", request->profile, "Write the friction along the specimen to this CSV file")
      ->type_name("FILE");
  command
      ->add_option("--curves", request->curves,
                   "Write measured, model and replayed force point by point to this CSV file")
      ->type_name("FILE");
  command->add_option("--report", request->report, "Write report.html and figures/ into this folder")
      ->type_name("FOLDER");
  add_output_options(*command, request->output);
  command->get_option("--json")->description("Write JSON instead of text");
  command->footer(
      "Writes the answer, the parameters with their uncertainties, the slips, the energy account and what was\n"
      "assumed. Rows are those of the file, counted from 1 without its header. Without gnuplot the report has\n"
      "no pictures, but their scripts and data; the exit code is 0. It is 1 if the record tells no friction, or\n"
      "the fit did not converge: what was reached is written.\n\n"
      "Examples:\n"
      "  flexslip fit examples/simulated/case.toml --report report\n"
      "  flexslip fit test.csv --span \"1278 um\" --stiffness \"90.6 N/m\" --diameter \"34.8 um\" \\\n"
      "    --modulus \"29.6 GPa\" --stage \"w_s [um]\" --force \"F [mN]\" --json");
  command->callback([request] { run_fit(*request); });
}

}  // namespace flexslip
