#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "case/mechanics.h"
#include "case/preparing.h"
#include "data/no_readings.h"
#include "io/input_error.h"

// The signs of the columns and the zero of the force.
namespace flexslip {
namespace {

// The force, or a proportional quantity, in any unit.
std::vector<double> force_or_difference(const Readings& readings) {
  if (readings.has(Reading::force)) return readings.of(Reading::force);
  std::vector<double> difference = readings.of(Reading::stage);
  const std::vector<double>& deflection = readings.of(Reading::deflection);
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= deflection[i];
  return difference;
}

Record record_of(const Readings& readings, double stiffness) {
  const auto of = [&](Reading reading) { return readings.of(reading); };
  if (!readings.has(Reading::force))
    return record_from_stage_and_deflection(of(Reading::stage), of(Reading::deflection), stiffness);
  return readings.has(Reading::stage)
             ? record_from_stage_and_force(of(Reading::stage), of(Reading::force), stiffness)
             : record_from_deflection_and_force(of(Reading::deflection), of(Reading::force), stiffness);
}

// From the rows of the table between stated rows.
Signs signs_of(const Preparing& at) {
  const SignRule rule = at.input().record->sign;
  if (rule == SignRule::reverse) return {-1, -1};
  if (rule != SignRule::find) return {1, 1};
  const std::size_t rows = at.result.rows;
  const std::size_t last = at.table().rows_before(row_or(at.input().record->until, rows, rows));
  const std::size_t first = std::min(at.table().rows_before(row_or(at.input().record->first, rows, 1) - 1), last);
  const std::vector<double> all = force_or_difference(at.readings);
  const auto force = std::span(all).subspan(first, last - first);
  const std::size_t points = points_before_wrap(force);
  const Signs signs = find_signs(std::span(at.readings.displacement()).subspan(first, points), force.first(points));
  // Without a force column, the sign of the force follows from the displacements.
  return !at.readings.has(Reading::force) && signs.force != signs.displacement ? Signs{1, 1} : signs;
}

void require_finite(const Record& record, const Table& table) {
  constexpr double max_force = 1e12, max_stage = 1e6;  // [N], [m] a DAQ writes 9.9E37 for an overload
  const RecordCheck check = check_record(record);
  std::size_t index = check.fault == RecordFault::not_finite ? check.index : record.force.size();
  for (std::size_t i = 0; i < index; ++i)
    if (std::abs(record.force[i]) > max_force || std::abs(record.stage[i]) > max_stage) index = i;
  if (index == record.force.size()) return;
  throw InputError({.file = table.source,
                    .line = table.lines[index],
                    .problem = "The readings are too large for a bending test",
                    .remedy = "check the units"});
}

// The values of a table at the rows of its file; NaN at rows without a number.
std::vector<double> of_file_rows(const std::vector<double>& values, const Table& table) {
  std::vector<double> all(table.rows_of_file(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < values.size(); ++row) all[table.file_row(row)] = values[row];
  return all;
}

}  // namespace

Done count_the_right_way(Preparing& at) {
  Readings& readings = at.readings;
  const Signs signs = signs_of(at);
  for (std::size_t i = 0; i < readings.columns.size(); ++i)
    if (const Reading is = readings.columns[i];
        is != Reading::length && (is == Reading::force ? signs.force : signs.displacement) < 0)
      for (double& value : readings.table.columns[i].values) value = -value;
  at.all = record_of(readings, at.stiffness);
  require_finite(at.all, at.table());
  if (readings.has(Reading::length)) at.result.pulled_in = of_file_rows(readings.of(Reading::length), at.table());
  const bool is_found = at.input().record->sign == SignRule::find;
  const bool changed = signs.displacement < 0 || signs.force < 0;
  std::string words = signs.displacement < 0 && signs.force < 0 ? "displacement and force are reversed"
                      : signs.displacement < 0                  ? "the displacement is reversed"
                      : signs.force < 0                         ? "the force is reversed"
                                                                : "displacement and force keep their signs";
  words += !is_found ? ", as stated" : changed ? ", as compression is negative in the file" : ", positive in loading";
  return PreparationStep{.changed = changed,
                         .done = std::move(words),
                         .otherwise = switch_to("sign", !is_found ? "find"
                                                        : changed ? "keep"
                                                                  : "reverse")};
}

Record first_rise(const Record& record) {
  const std::vector<Leg> legs = find_legs(record.stage);
  const std::size_t points = legs.empty() ? record.force.size() : legs.front().last;
  const auto greatest =
      std::max_element(record.force.begin(), record.force.begin() + static_cast<std::ptrdiff_t>(points));
  return first_points(record, static_cast<std::size_t>(greatest - record.force.begin()) + 1);
}

namespace {

ForceZero zero_of(const Record& rise) {
  if (rise.force.size() < least_noise_points) return {ForceZeroStatus::no_free_rows, 0, 0, 0};
  return find_force_zero(rise.stage, rise.force, force_noise(rise));
}

Record with_force_zero(const Preparing& at, const Baseline& zero) {
  const Record& record = at.all;
  const bool stage_is_read = at.readings.has(Reading::stage);
  std::vector<double> force = record.force;
  const std::vector<double>& displacement = stage_is_read ? record.stage : record.deflection;
  for (std::size_t i = 0; i < force.size(); ++i) force[i] -= zero.at(displacement[i]);
  return stage_is_read ? record_from_stage_and_force(record.stage, force, at.stiffness)
                       : record_from_deflection_and_force(record.deflection, force, at.stiffness);
}

// Fails:      InputError for a stage that never moves.
void require_moving(const Preparing& at, const Record& record) {
  const auto [least, most] = std::minmax_element(record.stage.begin(), record.stage.end());
  if (*least < *most) return;
  throw InputError({.file = at.table().source,
                    .line = at.table().lines[0],
                    .field = "the stage",
                    .problem = fmt::format("The displacement stays at {} in all {} rows",
                                           readable_length(at.input(), *least == 0 ? 0 : *least), record.stage.size()),
                    .remedy = "check the column of the displacement"});
}

PreparationStep take_off_stated_zero(Preparing& at, double stated) {
  at.all = with_force_zero(at, {.level = stated});
  return {.changed = stated != 0,
          .done = "the force is counted from the zero stated",
          .value = value_in(at.input(), stated, {}, kind::force),
          .otherwise = switch_to("zero", "keep")};
}

PreparationStep take_off_baseline(Preparing& at) {
  const Baseline& baseline = at.result.baseline;
  at.all = with_force_zero(at, baseline);
  return {.changed = true,
          .done = fmt::format("the force that {} before contact is extrapolated and subtracted",
                              baseline.settles_by != 0 ? "settles" : "drifts"),
          .value = value_in(at.input(), baseline.change, baseline.error, kind::force),
          .rows = RowRange{1, rows_of_points(at.sampling(), baseline.points)},
          .otherwise = switch_to("zero", "find")};
}

PreparationStep take_off_mean_before_contact(Preparing& at, const Record& rise) {
  const ForceZero zero = zero_of(rise);
  if (zero.status != ForceZeroStatus::found)
    return {
        .done = "the record has no rows before contact that show the zero of the force: the file's own zero is kept",
        .otherwise = switch_to("zero", "…")};
  const bool changed = is_significant(zero);
  if (changed) at.all = with_force_zero(at, {.level = zero.offset});
  return {.changed = changed,
          .done = changed ? "the mean force before contact is subtracted"
                          : "the mean force before contact is zero within four standard errors and is not subtracted",
          .value = value_in(at.input(), zero.offset, zero.error, kind::force),
          .rows = RowRange{1, rows_of_points(at.sampling(), zero.points)},
          .otherwise = switch_to("zero", "keep")};
}

}  // namespace

Done count_force_from_zero(Preparing& at) {
  const Record asked_for = at.last_row ? first_points(at.all, points_before(*at.last_row, at.sampling())) : at.all;
  require_points(at, asked_for);  // no row may be left after omissions
  require_moving(at, asked_for);
  const Record rise = first_rise(asked_for);
  Baseline& baseline = at.result.baseline;
  if (rise.force.size() >= least_noise_points)
    baseline = find_baseline(at.readings.has(Reading::stage) ? rise.stage : rise.deflection, rise.force);
  const ForceZeroRule& rule = at.input().record->zero;
  at.result.baseline_is_off = rule == ForceZeroRule{ZeroWord::slope} && baseline.points > 0;
  if (rule == ForceZeroRule{ZeroWord::keep})
    return PreparationStep{.done = "the force is counted from the file's own zero, as stated",
                           .otherwise = switch_to("zero", "find")};
  if (const auto* stated = std::get_if<double>(&rule)) return take_off_stated_zero(at, *stated);
  if (at.result.baseline_is_off) return take_off_baseline(at);
  return take_off_mean_before_contact(at, rise);
}

Done say_compliance(Preparing& at) {
  const Test& input = at.input();
  const bool is_stiff = std::isinf(at.stiffness);
  const bool is_stated = input.rig && input.rig->stiffness;
  const std::string_view of =
      support_compliance_of(input) > 0 ? "the stiffness of load train and supports" : "load-train stiffness";
  std::string words;
  if (!at.readings.has(Reading::force))
    words = fmt::format("the force is {} times the difference between stage displacement and deflection", of);
  else if (at.readings.has(Reading::stage))
    words = is_stiff ? "the deflection equals the stage displacement, as the load train is stated to be rigid"
                     : fmt::format("the deflection is the stage displacement minus force over {}", of);
  else
    words = !is_stated ? "the stage displacement is taken to equal the deflection, as no load-train stiffness is stated"
            : is_stiff ? "the stage displacement equals the deflection, as the load train is stated to be rigid"
                       : fmt::format("the stage displacement is the deflection plus force over {}", of);
  PreparationStep step{.changed = !is_stiff,
                       .done = std::move(words),
                       .otherwise = KeyChange{"rig", "stiffness", is_stiff ? "\"…\"" : "\"inf\""}};
  if (!is_stiff) step.value = value_in(input, at.stiffness, {}, kind::stiffness);
  return step;
}

}  // namespace flexslip
