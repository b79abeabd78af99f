#include "design/reload_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "case/fitted.h"
#include "case/measurement.h"
#include "case/simulated_test.h"
#include "design/design_result.h"
#include "inference/analysis.h"
#include "inference/causes.h"
#include "inference/judgement.h"
#include "io/parallel.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::array travels{0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};  // [travel]
// [force at which outward sliding begins]
constexpr std::array forces{0.8, 0.6, 0.4, 0.2, 0.05};

// A plan before it is evaluated. Units: as in the case.
struct Programme {
  double travel, unload_to, force;
};

Test with_programme(Test test, std::vector<double> positions) {
  test.stage->program = std::move(positions);
  return test;
}

std::vector<SimulatedPoint> path_of(const Test& test, const ReloadOptions& options) {
  return simulate(test, {.noise = options.noise.value_or(0), .seed = options.seed}).simulation.path;
}

// The programmes to a stage position, the deepest unloading last. Forces are shares of the force at
// which outward sliding begins, or, if friction prevents it, of the force at the reversal.
std::vector<Programme> programmes_to(const Test& loading, double travel) {
  const auto path = path_of(with_programme(loading, {0, travel, 0}), {});
  const auto turn = std::max_element(path.begin(), path.end(),
                                     [](const auto& one, const auto& other) { return one.stage < other.stage; });
  const auto slides = std::find_if(turn, path.end(), [](const auto& point) { return point.motion == "slip_out"; });
  const double greatest = (slides == path.end() ? turn : slides)->force;
  std::vector<Programme> all;
  for (const double share : forces) {
    const auto there =
        std::find_if(turn, path.end() - 1, [&](const auto& point) { return point.force <= share * greatest; });
    all.push_back({travel, there->stage, there->force});
  }
  return all;
}

// The simulated test as a measured one.
Test as_measured(Test test, const std::vector<SimulatedPoint>& path) {
  Table table{.source = "the plan", .columns = {{"stage", {}}, {"force", {}}}, .lines = {}};
  for (const SimulatedPoint& point : path) {
    table.columns[0].values.push_back(point.stage);
    table.columns[1].values.push_back(point.force);
    table.lines.push_back(table.lines.size() + 2);
  }
  RecordInput record{.file = table.source, .stage = "stage", .force = "force"};
  record.sign = SignRule::keep;
  record.failure = FailureRule::none;
  if (test.record) {
    record.gain_error = test.record->gain_error;
    record.preload_error = test.record->preload_error;
    record.slow_force_error = test.record->slow_force_error;
  }
  record.given = std::make_shared<const Table>(std::move(table));
  test.record = std::move(record);
  return test;
}

Measurement measured(const Test& loading, std::vector<double> positions, const ReloadOptions& options) {
  const auto path = path_of(with_programme(loading, std::move(positions)), options);
  return read_measurement(as_measured(loading, path), {.points = min_fitted_points, .span = true});
}

// The result of one loading alone, and its number of drops.
struct LoadingAlone {
  std::size_t drops;
  Causes causes;
};

LoadingAlone alone(const Measurement& measurement) {
  const DescribedTest described = describe(measurement);
  const TestAnalysis analysis = analyse_drops(measurement.record, described.description, described.options);
  const DropFeatures& features = analysis.drop_features;
  return {analysis.drops.drops.size(), features.drops > 0 ? causes_of(features, analysis.rig.stiffness) : Causes{}};
}

bool has_enough_readings(const Test& loading, double travel) {
  return travel > static_cast<double>(min_fitted_points) * *loading.stage->step;
}

// True if the stage moves back far enough for an unloading to be recognised.
bool is_unloaded(const Programme& programme) {
  constexpr double clearly = 1.5;
  return programme.travel - programme.unload_to > clearly * LegOptions{}.min_travel * programme.travel;
}

ReloadPlan tried(const Test& loading, const Programme& programme, const ReloadOptions& options) {
  ReloadPlan plan{.travel = programme.travel,
                  .unload_to = programme.unload_to,
                  .force = programme.force,
                  .drops = 0,
                  .loss_needed = not_a_number,
                  .loss_error = not_a_number,
                  .chances = {0, 0}};
  if (!has_enough_readings(loading, programme.travel)) return plan;
  const Measurement loaded = measured(loading, {0, programme.travel}, options);
  const LoadingAlone by_one_loading = alone(loaded);
  plan.drops = by_one_loading.drops;
  if (plan.drops == 0 || !is_unloaded(programme)) return plan;
  const auto passes =
      fit_passes_of(measured(loading, {0, programme.travel, programme.unload_to, programme.travel}, options));
  if (!passes || !passes->is_followed || !(passes->loss_needed > 0)) return plan;
  const double error = log_loss_error(*passes);
  plan.loss_needed = passes->loss_needed;
  plan.loss_error = error * (1 - passes->loss.value);
  plan.chances = chances_of_causes(-elementary::log(1 - passes->loss_needed), error, by_one_loading.causes,
                                   passes->drops_again > 0);
  return plan;
}

// [N] The maximum force.
double greatest_force(const Test& loading, double travel) {
  const auto path = path_of(with_programme(loading, {0, travel}), {});
  return std::max_element(path.begin(), path.end(),
                          [](const auto& one, const auto& other) { return one.force < other.force; })
      ->force;
}

// The travel, or slightly less than the stage position at which the loading ends early.
double travel_of(const Test& loading) {
  constexpr double before_end = 0.95;
  const PlannedDesign planned = design_of(loading);
  const DesignOutcome outcome = outcome_of(planned.design);
  const bool ends = outcome.status != DesignStatus::ok;
  return ends ? before_end * planned.units.scales.physical_length(outcome.stage_reached)
              : loading.stage->program.back();
}

// The changes, each alone, that make a plan with its deepest unloading sufficient.
std::vector<ReloadChange> changes_that_suffice(const Test& loading, const ReloadStudy& study,
                                               const ReloadOptions& options) {
  constexpr double farther = 1.25, softer = 0.5, finer = 1.0 / 3;
  const double travel = loading.stage->program.back();
  std::vector<ReloadChange> all;
  const auto add = [&](std::string_view parameter, double from, double to, const Test& test,
                       const ReloadOptions& with) {
    if (!std::isfinite(from) || result_of(test).status != ResultStatus::ok) return;
    const ReloadPlan plan = tried(test, programmes_to(test, test.stage->program.back()).back(), with);
    if (study.suffices(plan)) all.push_back({parameter, from, to, plan});
  };
  const auto add_parameter = [&](std::string_view parameter, double factor) {
    const double from = value_of(loading, parameter).value();
    Test test = loading;
    set(test, parameter, factor * from);
    add(parameter, from, factor * from, test, options);
  };
  if (travel_of(loading) == travel) add_parameter("travel", farther);
  add_parameter("stiffness", softer);
  add_parameter("step", softer);
  ReloadOptions of_finer_cell = options;
  of_finer_cell.noise = finer * *options.noise;
  add("noise", *options.noise, *of_finer_cell.noise, loading, of_finer_cell);
  return all;
}

}  // namespace

const ReloadPlan& ReloadStudy::of_travel() const {
  const auto first = plans.end() - static_cast<std::ptrdiff_t>(forces.size());
  const auto found = std::find_if(first, plans.end(), [&](const ReloadPlan& plan) { return suffices(plan); });
  if (found != plans.end()) return *found;
  return *std::max_element(first, plans.end(), [](const ReloadPlan& one, const ReloadPlan& other) {
    return one.chances.least() < other.chances.least();
  });
}

std::optional<ReloadPlan> ReloadStudy::least() const {
  const auto found = std::find_if(plans.begin(), plans.end(), [&](const ReloadPlan& plan) { return suffices(plan); });
  return found == plans.end() ? std::nullopt : std::optional(*found);
}

ReloadStudy reload_study(const Test& given, const ReloadOptions& asked) {
  if (!(asked.noise.value_or(1) > 0) || !(asked.required_chance > 0 && asked.required_chance < 1))
    throw std::invalid_argument("a noise of 0 or less, or a chance that is none");
  constexpr double readings = 300;  // per loading, if the case has no step
  Test loading = given;
  const double travel = travel_of(loading);
  if (*loading.stage->step == 0) loading.stage->step = travel / readings;
  ReloadOptions options = asked;
  if (!asked.noise) options.noise = usual_noise * greatest_force(loading, travel);
  ReloadStudy study{.noise = *options.noise,
                    .noise_is_usual = !asked.noise,
                    .step = *loading.stage->step,
                    .required_chance = options.required_chance,
                    .drops = 0,
                    .plans = {},
                    .changes = {}};
  if (has_enough_readings(loading, travel))
    study.drops = find_drops(measured(loading, {0, travel}, options).record).drops.size();
  if (study.drops == 0) return study;
  std::vector<Programme> programmes;
  for (const double share : travels)
    for (const Programme& each : programmes_to(loading, share * travel)) programmes.push_back(each);
  study.plans.resize(programmes.size());
  for_each_index(programmes.size(), options.threads,
                 [&](std::size_t i) { study.plans[i] = tried(loading, programmes[i], options); });
  if (!study.least()) study.changes = changes_that_suffice(loading, study, options);
  return study;
}

}  // namespace flexslip
