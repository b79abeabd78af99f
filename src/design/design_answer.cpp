#include "design/design_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "case/mechanics.h"
#include "data/small_deflection.h"
#include "numerics/elementary.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

constexpr double close = 1e-4;  // [1] precision of a change

struct PowerInBendingStiffness {
  std::string_view parameter;
  int power;
  bool is_depth;
};
constexpr std::array powers_in_bending_stiffness{
    PowerInBendingStiffness{"diameter", 4, true}, PowerInBendingStiffness{"height", 3, true},
    PowerInBendingStiffness{"width", 1, false}, PowerInBendingStiffness{"modulus", 1, false}};

// Empty if there is no such design.
std::optional<DesignOutcome> outcome_with(Test input, std::string_view parameter, double value) {
  if (!is_within(design_parameter(parameter), value)) return std::nullopt;
  set(input, parameter, value);
  return result_of(input).outcome;
}

std::optional<bool> snaps_with(Test input, std::string_view parameter, double value) try {
  set(input, parameter, value);
  return snaps(design_of(input).design);
} catch (const InputError&) {
  return std::nullopt;
} catch (const std::invalid_argument&) {  // a value is too extreme
  return std::nullopt;
}

// The value nearest to `as_now` that reverses the answer, between two values; one of them snaps.
double nearest_between(const Test& input, std::string_view parameter, double as_now, double otherwise, bool now) {
  const auto is_close = [](const Bracket& values) { return !(std::abs(values.width()) > close * values.high); };
  const auto is_otherwise = [&](double value) { return snaps_with(input, parameter, value) == !now; };
  return halved_until(is_close, {as_now, otherwise}, is_otherwise).high;
}

struct Way {
  double factor;  // of each step
  double last;    // the last value that does not reverse the answer
  bool goes_on;
};

// The nearest values that reverse the answer, one larger and one smaller, the nearer first; at most
// `wanted`.
std::vector<double> nearest_changes(const Test& input, std::string_view parameter, bool now, std::size_t wanted) {
  constexpr double step = 1.1;
  constexpr int steps = 36;  // up to a factor of 30
  const double from = value_of(input, parameter).value();
  const bool is_nothing = from == 0;
  const double start = is_nothing ? design_parameter(parameter).most * std::pow(step, -2 * steps) : from;
  std::vector<double> found;
  if (!std::isfinite(start)) return found;
  std::array<Way, 2> ways{{{step, from, true}, {1 / step, from, !is_nothing}}};
  for (int n = 1; n <= (is_nothing ? 2 * steps : steps); ++n)
    for (Way& way : ways) {
      if (!way.goes_on || found.size() == wanted) continue;
      const double value = start * std::pow(way.factor, n);
      const auto there = snaps_with(input, parameter, value);
      if (there == !now) found.push_back(nearest_between(input, parameter, way.last, value, now));
      way.goes_on = there == now;
      way.last = value;
    }
  return found;
}

// Changes of the combined stiffness of load train and supports, in units of the case.
std::vector<double> stiffness_changes(const Test& input, double own, bool now, double critical) {
  const double just_below = critical * (1 - close);
  if (!now && critical <= own) return critical > 0 ? std::vector{just_below} : std::vector<double>{};
  auto values = nearest_changes(input, "stiffness", now, 2);
  for (double& value : values) value = with_supports(value, support_compliance_of(input));
  if (!std::isfinite(critical)) return values;
  const auto stiffer = std::find_if(values.begin(), values.end(), [&](double value) { return value > own; });
  if (now && stiffer != values.end()) values.erase(stiffer);
  if (now) values.insert(values.begin(), critical);
  if (!now && stiffer == values.end()) values.push_back(just_below);
  return values;
}

// `to` rounded away from the current value, to the fewest digits (three or more) that still reverse
// the answer.
double as_printed(const Test& input, std::string_view parameter, double to, bool now) {
  constexpr int min_digits = 3;
  constexpr int max_digits = 9;
  const bool more = to > value_of(input, parameter).value();
  for (int digits = min_digits; digits <= max_digits; ++digits) {
    const double step = std::pow(10, std::floor(std::log10(to)) - (digits - 1));
    const double rounded = step * (more ? std::ceil(to / step) : std::floor(to / step));
    const double decimal = std::stod(fmt::format("{:.{}e}", rounded, digits - 1));
    if (snaps_with(input, parameter, decimal) == !now) return decimal;
  }
  return to;
}

// The travel of the first snap. The range grows until a snap is found or the specimen passes
// between its supports.
std::optional<double> travel_change(const Test& input, const DesignAnswer& answer) {
  constexpr double farther = 2, much_farther = 30, deepest = 1;  // [1], [1], [L]
  // an excess that survives rounding of units
  constexpr double hair = 1e-6;
  if (answer.outcome.first_snap) return answer.scales.physical_length(answer.outcome.first_snap->stage) * (1 - hair);
  for (double factor = farther; factor < farther * much_farther; factor *= farther) {
    const auto there =
        outcome_with(input, "travel", std::min(factor, much_farther) * value_of(input, "travel").value());
    if (!there || (!there->first_snap && there->w_reached > deepest)) break;
    if (there->first_snap) return answer.scales.physical_length(there->first_snap->stage) * (1 + hair);
  }
  return std::nullopt;
}

std::optional<PhaseStudy> phases_of(Test input) {
  constexpr int phases = 24;
  constexpr double finest = 1e-5;  // [L] a finer wave's phase moves nothing by 1e-5 of the span
  if (input.other) return std::nullopt;
  if (!value_of(input, "phase") || value_of(input, "amplitude").value() == 0) return std::nullopt;
  if (design_of(input).units.scales.reduced_length(value_of(input, "wavelength").value()) < finest) return std::nullopt;
  PhaseStudy study{0, 0, infinity, 0, 0};
  const double first = value_of(input, "phase").value();
  for (int i = 0; i < phases; ++i) {
    set(input, "phase", first + 2 * std::numbers::pi * i / phases);
    const auto outcome = result_of(input).outcome;
    if (!outcome) continue;
    ++study.phases;
    if (outcome->snaps > 0) ++study.snapping;
    study.min_drop = std::min(study.min_drop, outcome->largest_drop);
    study.largest_drop = std::max(study.largest_drop, outcome->largest_drop);
    study.critical = std::max(study.critical, critical_stiffness(design_of(input).design));
  }
  return study;
}

}  // namespace

DesignAnswer answer_of(const Test& input) {
  const auto [design, units] = design_of(input);
  const Scales& scales = units.scales;
  DesignAnswer answer{.input = input,
                      .design = design,
                      .scales = scales,
                      .surface = units.surface,
                      .wraps_nose = false,
                      .outcome = outcome_of(design),
                      .critical = critical_stiffness(design),
                      .changes = {},
                      .phases = phases_of(input)};
  answer.wraps_nose = answer.outcome.greatest_curvature > nose_curvature_of(input, scales);
  const bool now = answer.outcome.snaps > 0;
  const auto add = [&](std::string_view parameter, double to, bool and_beyond) {
    if (parameter == "modulus" && !input.reduced && to > max_material_modulus) return;
    const auto outcome = outcome_with(input, parameter, to);
    if (outcome && (outcome->snaps > 0) != now)
      answer.changes.push_back({parameter, value_of(input, parameter).value(), to,
                                as_printed(input, parameter, to, now), and_beyond, *outcome});
  };
  const auto is_listed = [&](std::string_view parameter) {
    return std::any_of(answer.changes.begin(), answer.changes.end(),
                       [&](const DesignChange& change) { return change.parameter == parameter; });
  };
  const double supports = support_compliance_of(input);
  const double own = with_supports(value_of(input, "stiffness").value(), supports);
  const double critical = scales.physical_stiffness(answer.critical);
  // The depth has other effects if the axis is above the supports by half of it, or if the specimen
  // may break.
  const bool depth_is_more = design.rig.fibre.supports().half_depth > 0 || std::isfinite(design.breaking_curvature);
  for (const double stiffness : stiffness_changes(input, own, now, critical)) {
    const bool and_beyond = now && stiffness == critical;
    const double load_train = without_supports(stiffness, supports);
    if (std::isfinite(load_train) || std::isinf(stiffness)) add("stiffness", load_train, and_beyond);
    if (!std::isfinite(own)) continue;
    // k L^3/EI is decisive: a gain in stiffness is equivalent to a loss in the specimen.
    for (const auto& [parameter, power, is_depth] : powers_in_bending_stiffness)
      if (value_of(input, parameter) && !(is_depth && depth_is_more))
        add(parameter, value_of(input, parameter).value() * std::pow(own / stiffness, 1.0 / power), and_beyond);
  }
  std::vector<std::string_view> others{"span"};
  // If the supports differ, the case varies only one of them.
  if (!input.other) others.insert(others.end(), {"mu0", "amplitude", "wavelength", "pin_friction"});
  if (depth_is_more) others.insert(others.begin(), {"diameter", "height"});
  for (const auto parameter : others)
    if (value_of(input, parameter) && !is_listed(parameter))
      for (const double to : nearest_changes(input, parameter, now, 1)) add(parameter, to, false);
  if (const auto travel = travel_change(input, answer)) add("travel", *travel, true);
  return answer;
}

DesignAnswer answer_of(const PlannedCase& planned, unsigned threads) {
  DesignAnswer answer = answer_of(planned.loading);
  if (!planned.open.empty()) answer.open = open_study(planned.loading, planned.open, threads);
  return answer;
}

std::vector<RecordedForce> record_of(const DesignAnswer& answer) {
  const Design& design = answer.design;
  const bool breaks = answer.outcome.status == DesignStatus::breaks;
  return record_of({design.friction, design.rig}, breaks ? answer.outcome.stage_reached : design.travel, design.step);
}

std::vector<FoldPoint> folds_of(const DesignAnswer& answer) {
  return folds_up_to(answer.design.friction, answer.design.travel, answer.design.rig.fibre);
}

}  // namespace flexslip
