#include "cases/design_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace flexslip {
namespace {

constexpr double close = 1e-4;  // to where a change is reached

// None if there is no such design.
std::optional<DesignOutcome> outcome_with(DesignCase input, DesignParameter parameter, double value) {
  if (!is_within(described(parameter), value)) return std::nullopt;
  input.set(parameter, value);
  return result_of(input).outcome;
}

std::optional<bool> snaps_with(const DesignCase& input, DesignParameter parameter, double value) {
  const auto outcome = outcome_with(input, parameter, value);
  return outcome ? std::optional(outcome->snaps > 0) : std::nullopt;
}

// Between two values, of which the one snaps and the other does not: the one nearest to the first that is as the other.
double nearest_between(const DesignCase& input, DesignParameter parameter, double as_now, double otherwise, bool now) {
  while (std::abs(otherwise - as_now) > close * otherwise) {
    const double middle = 0.5 * (as_now + otherwise);
    (snaps_with(input, parameter, middle) == !now ? otherwise : as_now) = middle;
  }
  return otherwise;
}

struct Way {
  double factor;  // of a step
  double last;    // value that is as now
  bool goes_on;
};

std::optional<double> nearest_change(const DesignCase& input, DesignParameter parameter, bool now) {
  constexpr double step = 1.1;
  constexpr int steps = 36;  // to 30 times as much
  const double from = input.value(parameter);
  const bool is_nothing = from == 0;
  const double start = is_nothing ? described(parameter).most * std::pow(step, -2 * steps) : from;
  if (!std::isfinite(start)) return std::nullopt;
  std::array<Way, 2> ways{{{step, from, true}, {1 / step, from, !is_nothing}}};
  for (int n = 1; n <= (is_nothing ? 2 * steps : steps); ++n)
    for (Way& way : ways) {
      if (!way.goes_on) continue;
      const double value = start * std::pow(way.factor, n);
      const auto there = snaps_with(input, parameter, value);
      if (there == !now) return nearest_between(input, parameter, way.last, value, now);
      way.goes_on = there.has_value();
      way.last = value;
    }
  return std::nullopt;
}

// The critical stiffness in the units of the case.
std::optional<double> stiffness_change(const DesignCase& input, bool now, double critical) {
  if (now && std::isfinite(critical)) return critical;
  if (!now && critical < input.value(DesignParameter::stiffness))
    return critical > 0 ? std::optional(critical * (1 - close)) : std::nullopt;
  return nearest_change(input, DesignParameter::stiffness, now);
}

std::optional<double> travel_change(const DesignCase& input, const DesignAnswer& answer) {
  constexpr double much_farther = 30;
  if (answer.outcome.first_snap) return answer.scales.physical_length(answer.outcome.first_snap->stage);
  const auto farther =
      outcome_with(input, DesignParameter::travel, much_farther * input.value(DesignParameter::travel));
  if (!farther || !farther->first_snap) return std::nullopt;
  return answer.scales.physical_length(farther->first_snap->stage) * (1 + 1e-6);  // beyond it, to have snapped
}

std::optional<PhaseStudy> phases_of(DesignCase input) {
  constexpr int phases = 24;
  if (!input.has(DesignParameter::phase) || input.value(DesignParameter::amplitude) == 0) return std::nullopt;
  PhaseStudy study{0, 0, std::numeric_limits<double>::infinity(), 0, 0};
  const double first = input.value(DesignParameter::phase);
  for (int i = 0; i < phases; ++i) {
    input.set(DesignParameter::phase, first + 2 * std::numbers::pi * i / phases);
    const auto [status, planned, outcome] = result_of(input);
    if (!outcome) continue;
    ++study.phases;
    if (outcome->snaps > 0) ++study.snapping;
    study.least_drop = std::min(study.least_drop, outcome->largest_drop);
    study.largest_drop = std::max(study.largest_drop, outcome->largest_drop);
    study.critical = std::max(study.critical, critical_stiffness(planned->design));
  }
  return study;
}

}  // namespace

DesignAnswer answer_of(const DesignCase& input) {
  const auto [design, scales] = input.planned();
  DesignAnswer answer{input, design, scales, outcome_of(design), critical_stiffness(design), {}, phases_of(input)};
  const bool now = answer.outcome.snaps > 0;
  const auto add = [&](DesignParameter parameter, std::optional<double> to) {
    const auto outcome = to ? outcome_with(input, parameter, *to) : std::nullopt;
    if (outcome && (outcome->snaps > 0) != now)
      answer.changes.push_back({parameter, input.value(parameter), *to, *outcome});
  };
  const auto stiffness = stiffness_change(input, now, scales.physical_stiffness(answer.critical));
  add(DesignParameter::stiffness, stiffness);
  const double own = input.value(DesignParameter::stiffness);
  if (stiffness && std::isfinite(own)) {
    // k L^3/EI decides: what the stiffness must gain, the specimen may lose.
    const double softer = own / *stiffness;
    if (input.has(DesignParameter::diameter))
      add(DesignParameter::diameter, input.value(DesignParameter::diameter) * std::pow(softer, 0.25));
    if (input.has(DesignParameter::modulus))
      add(DesignParameter::modulus, input.value(DesignParameter::modulus) * softer);
  }
  for (const auto parameter :
       {DesignParameter::span, DesignParameter::mu0, DesignParameter::amplitude, DesignParameter::wavelength})
    if (input.has(parameter)) add(parameter, nearest_change(input, parameter, now));
  add(DesignParameter::travel, travel_change(input, answer));
  return answer;
}

}  // namespace flexslip
