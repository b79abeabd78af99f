#include "case/measurement.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "case/case_keys.h"
#include "case/mechanics.h"
#include "case/preparing.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

struct Step {
  std::string_view name;
  Done (*take)(Preparing& at);
};

constexpr Step steps[] = {{"sign", count_the_right_way},
                          {"first", begin_where_stated},
                          {"overload", end_before_overload},
                          {"repeated", leave_out_repeated},
                          {"held", say_held},
                          {"interpolated", say_interpolated},
                          {"unloaded", say_unloaded},
                          {"thinning", say_thinning},
                          {"stray", leave_out_stray_positions},
                          {"holds", leave_out_holds},
                          {"way_back", leave_out_way_back},
                          {"spikes", leave_out_spikes},
                          {"zero", count_force_from_zero},
                          {"compliance", say_compliance},
                          {"end", end_where_stated},
                          {"loading", choose_loading},
                          {"end", end_before_failure},
                          {"stage", hold_stage},
                          {"contact", count_from_contact}};

static_assert(std::all_of(std::begin(steps), std::end(steps), [](const Step& step) {
  return std::find(preparation_steps.begin(), preparation_steps.end(), step.name) != preparation_steps.end();
}));

double stiffness_for(const Readings& readings) {
  const Test& input = readings.test;
  if (input.rig && input.rig->stiffness) return rig_stiffness_of(input);
  // A measured deflection with its force needs no stiffness, because the stage is not used.
  if (!readings.has(Reading::stage)) return infinity;
  if (!readings.has(Reading::deflection))
    throw wrong_value(input, "rig.stiffness",
                      fmt::format("The displacement '{}' was measured at the stage, so the stiffness of the load "
                                  "train is needed",
                                  readings.table.columns.front().name),
                      instruction_to_set(input, KeyChange{"rig", "stiffness", "\"… N/m\""}) +
                          "; \"inf\" if it was measured at the specimen's midpoint or is already corrected");
  throw missing(input, input.rig ? "rig.stiffness" : "rig");
}

}  // namespace

Measurement read_measurement(const Test& asked, const Needs& needs) {
  if (needs.points < least_noise_points)
    throw std::invalid_argument(fmt::format("the noise of {} points cannot be estimated", needs.points));
  if (!asked.record) throw missing(asked, "record");
  Readings readings = read_readings(asked, needs);
  const double stiffness = stiffness_for(readings);
  Measurement result{.test = std::move(readings.test),
                     .preparation = std::move(readings.found_by),
                     .file = readings.table.source,
                     .rows = readings.table.rows_of_file(),
                     .missing = readings.table.missing_rows.size(),
                     .contradictions = std::move(readings.contradictions)};
  result.is_derived = readings.has(Reading::stage) && !readings.has(Reading::deflection);
  Preparing at{.result = std::move(result), .readings = std::move(readings), .needs = needs, .stiffness = stiffness};
  for (const Step& step : steps)
    if (Done done = step.take(at)) {
      done->name = step.name;
      at.result.preparation.push_back(std::move(*done));
    }
  at.result.relaxation = relaxation_of(at);
  return std::move(at.result);
}

RowRange rows_of_first_curve(const Measurement& measurement, std::size_t first, std::size_t last) {
  const std::vector<std::size_t>& points = measurement.first_curve.points;
  return {cyclic_file_row(measurement, points[first]), rows_of_points(measurement.sampling, points[last - 1] + 1)};
}

std::size_t file_row(const Measurement& measurement, std::size_t point) {
  return cyclic_file_row(measurement, measurement.first + point);
}

std::size_t cyclic_file_row(const Measurement& measurement, std::size_t point) {
  return measurement.sampling.rows[point] + 1;
}

std::size_t last_file_row(const Measurement& measurement, std::size_t point) {
  return rows_of_points(measurement.sampling, measurement.first + point + 1);
}

}  // namespace flexslip
