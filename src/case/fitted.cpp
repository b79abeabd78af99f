#include "case/fitted.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/mechanics.h"
#include "data/names.h"
#include "io/input_error.h"
#include "io/sha256.h"
#include "io/text_file.h"
#include "numerics/elementary.h"
#include "numerics/progress.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::array models{ProfileModel::roughness, ProfileModel::constant, ProfileModel::drift,
                            ProfileModel::sinusoid, ProfileModel::sinusoids};

InputFile input_file(const std::string& name) {
  if (name == "-" || name == "standard input") return {"standard input", ""};  // the name that read_case uses
  if (!std::filesystem::is_regular_file(name)) return {name, ""};              // a pipe can be read only once
  const auto digest = digest_of(*open_to_read(name));
  return {name, digest.sha256};
}

DropsElsewhere drops_in_other_loadings(const Measurement& measurement) {
  if (!measurement.cycles) return {};
  DropsElsewhere all;
  std::size_t loading = 0, most = 0;
  for (const Leg& leg : find_legs(measurement.cycles->stage)) {
    if (leg.direction != Direction::loading || ++loading == measurement.loading.number) continue;
    if (leg.last - leg.first < min_fitted_points) continue;
    Record record = points_between(*measurement.cycles, leg.first, leg.last);
    record.stage = advancing(record.stage);
    const DropOptions options{.halts = measurement.sampling.halts_between(leg.first, leg.last)};
    const std::size_t drops = find_drops(record, options).drops.size();
    all.drops += drops;
    if (drops <= most) continue;
    most = drops;
    all.rows_of_most = {cyclic_file_row(measurement, leg.first), cyclic_file_row(measurement, leg.last - 1)};
  }
  return all;
}

// The drops of all loadings of a record, by its rows.
std::vector<Drop> drops_of_loadings(const Measurement& measurement) {
  std::vector<Drop> all;
  for (const Leg& leg : find_legs(measurement.cycles->stage)) {
    if (leg.direction != Direction::loading || leg.last - leg.first < min_fitted_points) continue;
    Record record = points_between(*measurement.cycles, leg.first, leg.last);
    record.stage = advancing(record.stage);
    for (Drop drop : find_drops(record, {.halts = measurement.sampling.halts_between(leg.first, leg.last)}).drops) {
      drop.before += leg.first;
      drop.after += leg.first;
      all.push_back(drop);
    }
  }
  return all;
}

// The joint fit of all passes; empty for a record of one pass.
std::optional<PassesFit> fit_all_passes(const Measurement& measurement, const TestDescription& description,
                                        const Scales& scales) {
  if (!measurement.cycles) return std::nullopt;
  const ReducedRecord reduced = to_reduced(*measurement.cycles, scales);
  if (find_legs(reduced.stage).size() < 2) return std::nullopt;
  constexpr double of_slope = 0.2;  // a slope changed by friction, seating or large deflection
  PassesProblem problem{
      .record = reduced,
      .rig = {scales.reduced_stiffness(description.load_train_stiffness), description.fibre},
      .errors = {.force = 0,
                 .bending_stiffness = states_stiffness(measurement.test)
                                          ? description.bending_stiffness_error
                                          : std::max(of_slope, description.bending_stiffness_error),
                 .contact = description.contact_error ? scales.reduced_length(*description.contact_error)
                                                      : default_contact_error},
      .rig_errors = description.rig_errors,
      .first = measurement.first,
      .last = measurement.first + measurement.record.force.size(),
      .drops = drops_of_loadings(measurement)};
  return fit_passes(problem);
}

TestDescription description_of(const Measurement& measurement, const BendingStiffnessUsed& stiffness) {
  const Test& input = measurement.test;
  return {.span = span_of(input),
          .load_train_stiffness = rig_stiffness_of(input),
          .bending_stiffness = stiffness.value,
          .bending_stiffness_error = stiffness.relative_error,
          .contact_error = measurement.contact_error,
          .fibre = fibre_of(input, Scales(span_of(input), 1)),
          .nose = input.rig->nose,
          .snaps = input.rig->snaps,
          .rig_errors = rig_errors_of(measurement)};
}

// A bending stiffness far from the initial slope has a wrong unit or exponent and prevents any
// calculation. A doubtful one is fitted and reported (finding wrong_stiffness).
void require_same_world(const Test& input, const Record& record, double bending_stiffness) {
  constexpr double farthest = 1e15;  // a span in another unit gives 1e9
  const StiffnessFromSlope slope = stiffness_from_slope(record, span_of(input));
  if (!slope.found) return;
  const double ratio = bending_stiffness / slope.value;
  if (ratio < farthest && ratio > 1 / farthest) return;
  const bool has_modulus = !input.specimen->bending_stiffness;
  throw wrong_value(
      input, has_modulus ? "specimen.modulus" : "specimen.bending_stiffness",
      fmt::format("The bending stiffness is {:.1e} times as much as the {} from the record's initial slope", ratio,
                  readable(slope.value, kind_in(input, kind::bending_stiffness))),
      "check its unit, the section, and the units of the record");
}

std::optional<Materials> materials_of(const Test& input) {
  if (!input.specimen || !input.specimen->material || !input.rig || !input.rig->support_material) return std::nullopt;
  return Materials{*input.specimen->material, *input.rig->support_material};
}

}  // namespace

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  names.reserve(models.size());
  for (const auto model : models) names.emplace_back(name_of(model));
  return names;
}

AnalysisOptions options_for(const Test& input, const AnalysisChoice& choice) {
  AnalysisOptions options = choice.options;
  if (const auto limit = pin_limit_of(input)) options.max_friction = *limit;
  std::string asked = choice.model;
  if (asked.empty() && input.friction && input.friction->model && !input.friction->has_parameters()) {
    asked = words_of(*case_key("friction", "model")).at(static_cast<std::size_t>(*input.friction->model));
    const auto names = model_names();
    if (std::find(names.begin(), names.end(), asked) == names.end())
      throw wrong_value(
          input, "friction.model",
          fmt::format("{} is not a model to fit: roughness, constant, drift, sinusoid or sinusoids", in_quotes(asked)));
  }
  for (const auto model : models)
    if (name_of(model) == asked) options.fit.model = model;
  return options;
}

Fields<AnalysisOptions> analysis_fields() {
  using O = const AnalysisOptions&;
  return Fields<AnalysisOptions>()
      .words("model", "friction model", [](O options) { return name_of(options.fit.model); })
      .number("false_alarms", "number of drops expected in a test without slips",
              [](O options) { return options.drops.false_alarms_per_test; })
      .number("suspect_limit", "limit above which friction is implausible", &AnalysisOptions::suspect_limit);
}

std::string name_of_test(const std::string& file) {
  if (file == "-") return "standard input";
  const std::filesystem::path path = std::filesystem::absolute(file).lexically_normal();
  const std::string folder = path.parent_path().filename().string();
  return path.stem() == "case" && !folder.empty() ? folder : path.stem().string();
}

DescribedTest describe(const Measurement& measurement, const AnalysisOptions& options) {
  const Test& input = measurement.test;
  const BendingStiffnessUsed stiffness = bending_stiffness_of(input, measurement);
  TestDescription description = description_of(measurement, stiffness);
  const Scales scales = scales_of(input, stiffness);  // refuses thick specimens
  if (states_stiffness(input)) require_same_world(input, measurement.record, stiffness.value);
  description.passes = fit_all_passes(measurement, description, scales);
  DescribedTest described{stiffness, std::move(description), options};
  described.options.drops.halts =
      measurement.sampling.halts_between(measurement.first, measurement.first + measurement.record.force.size());
  return described;
}

namespace {

FittedTest fit_measured(Measurement measurement, const AnalysisOptions& options) {
  Stages stages;
  const Test input = measurement.test;  // completed from the file
  const auto [stiffness, description, of_record] = describe(measurement, options);
  const BeamGeometry geometry = geometry_of(input);
  const SmallDeflection standard = small_deflection_of(measurement);
  stages.enter("", 0.95);
  TestAnalysis analysis = analyse(measurement.record, description, of_record);
  std::optional<PassesFit> passes = analysis.passes;  // they may not explain the evaluated loading
  stages.enter("verdict", 0.05);
  Judgement judgement = judge(analysis);
  if (!judgement.determines_friction) {  // cracks took part of the work
    analysis.energy.friction_share = analysis.energy.friction_share_error = not_a_number;
    analysis.work_share_sensitivities.reset();
  }
  const DropsElsewhere drops_elsewhere = drops_in_other_loadings(measurement);
  std::optional<ImagedLength> imaged;
  if (analysis.status == AnalysisStatus::ok && !measurement.pulled_in.empty()) {
    std::vector<double> pulled_in;
    for (std::size_t point = 0; point < measurement.record.force.size(); ++point)
      pulled_in.push_back(analysis.scales.reduced_length(measurement.pulled_in[file_row(measurement, point) - 1]));
    imaged = compare_with_images(analysis.profile_at_fit, pulled_in);
  }
  std::optional<SurfaceStrain> surface;
  if (analysis.status == AnalysisStatus::ok && geometry.section)
    surface.emplace(*geometry.section, Scales(analysis.scales.span(), analysis.scales.bending_stiffness() *
                                                                          analysis.fit.bending_stiffness.value));
  std::optional<double> strain_at_break = input.specimen ? input.specimen->strain_at_break : std::nullopt;
  if (surface && input.specimen->strength)
    strain_at_break = surface->strain(surface->curvature_at_stress(*input.specimen->strength));
  const double nose_curvature = nose_curvature_of(input, analysis.scales);
  const std::string& data = input.record.value().file;
  const std::string file = input.source.empty() ? data : input.source;
  Provenance provenance{FLEXSLIP_VERSION, {}, to_toml(input), options};
  if (!input.source.empty()) provenance.inputs.push_back(input_file(input.source));
  provenance.inputs.push_back(input.record->given ? InputFile{data, ""} : input_file(data));
  return {.name = name_of_test(file),
          .reduced = input.reduced,
          .measurement = std::move(measurement),
          .stiffness = stiffness.source,
          .section_moment = geometry.section ? std::optional(second_moment(*geometry.section)) : std::nullopt,
          .materials = materials_of(input),
          .geometry = geometry,
          .small_deflection = standard,
          .analysis = std::move(analysis),
          .passes = std::move(passes),
          .drops_elsewhere = drops_elsewhere,
          .imaged = std::move(imaged),
          .judgement = std::move(judgement),
          .surface = surface,
          .strain_at_break = strain_at_break,
          .nose_curvature = nose_curvature,
          .provenance = std::move(provenance)};
}

}  // namespace

std::optional<PassesFit> fit_passes_of(const Measurement& measurement) {
  const BendingStiffnessUsed stiffness = bending_stiffness_of(measurement.test, measurement);
  return fit_all_passes(measurement, description_of(measurement, stiffness), scales_of(measurement.test, stiffness));
}

FittedTest fit_test(const Test& asked, const AnalysisOptions& options) {
  Stages stages;
  stages.enter("reading", 0.02);
  const Measurement measurement =
      read_measurement(asked, {.points = min_fitted_points, .span = true, .load_train = true});
  const std::optional<double> radius = standard_roller_radius(geometry_of(measurement.test));
  stages.enter("", radius ? 0.49 : 0.98);
  FittedTest test = fit_measured(measurement, options);
  if (!is_fitted(test) || !radius) return test;
  stages.enter("on rollers", 0.49);
  Measurement on_rollers = measurement;
  on_rollers.test.rig->roller_radius = radius;
  test.on_rollers = std::make_shared<const FittedTest>(fit_measured(std::move(on_rollers), options));
  return test;
}

std::size_t file_row(const FittedTest& test, std::size_t point) { return file_row(test.measurement, point); }

std::size_t last_row(const FittedTest& test) {
  return last_file_row(test.measurement, test.measurement.record.force.size() - 1);
}

const FrictionProfile& profile_of(const FittedTest& test) {
  return is_fitted(test) ? test.analysis.profile_at_fit : test.analysis.profile;
}

Record record_of(const FittedTest& test, const PassFriction& pass) {
  return points_between(*test.measurement.cycles, pass.rows.first - std::min<std::size_t>(1, pass.rows.first),
                        pass.rows.last);
}

std::string_view status_of(const FittedTest& test) {
  return name_in_order<AnalysisStatus::not_explained>(test.analysis.status, {"ok", "too_few_points", "not_explained"});
}

std::string_view name_of(SawtoothCategory category) {
  return name_in_order<SawtoothCategory::none>(category, {"clear", "nominal", "none"});
}

}  // namespace flexslip
