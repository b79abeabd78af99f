#include "cases/design_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "bending_test/reach.h"
#include "fibre/elastica.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

// None if the numbers cannot be computed.
std::optional<DesignOutcome> outcome_with(DesignCase input, DesignParameter parameter, double value) {
  try {
    input.set(parameter, value);
    return outcome_of(input.design());
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const std::invalid_argument&) {  // more roughness than can be followed
    return std::nullopt;
  }
}

std::optional<bool> snaps_with(const DesignCase& input, DesignParameter parameter, double value) {
  const auto outcome = outcome_with(input, parameter, value);
  return outcome ? std::optional(outcome->snaps > 0) : std::nullopt;
}

// Between two values, of which the one snaps and the other does not: the one nearest to the first that is as the other.
double nearest_between(const DesignCase& input, DesignParameter parameter, double as_now, double otherwise, bool now) {
  constexpr double close = 1e-4;
  while (std::abs(otherwise - as_now) > close * otherwise) {
    const double middle = 0.5 * (as_now + otherwise);
    (snaps_with(input, parameter, middle) == !now ? otherwise : as_now) = middle;
  }
  return otherwise;
}

std::optional<double> nearest_change(const DesignCase& input, DesignParameter parameter, bool now) {
  constexpr double step = 1.1;
  constexpr int steps = 36;  // to 30 times as much
  const double from = input.value(parameter);
  std::array<bool, 2> goes_on{true, true};
  for (int n = 1; n <= steps; ++n)
    for (const int way : {1, -1}) {
      bool& possible = goes_on[way > 0 ? 0 : 1];
      if (!possible) continue;
      const double value = from * std::pow(step, way * n);
      const auto there = snaps_with(input, parameter, value);
      possible = there.has_value();
      if (there == !now) return nearest_between(input, parameter, from * std::pow(step, way * (n - 1)), value, now);
    }
  return std::nullopt;
}

std::optional<double> stiffness_change(const DesignCase& input, const Design& design, bool now, double critical) {
  if (!now || !std::isfinite(critical)) return nearest_change(input, DesignParameter::stiffness, now);
  const double from = input.value(DesignParameter::stiffness);
  const double safe = from * std::max(1.0, critical / design.rig.stiffness) * 1.001;
  if (snaps_with(input, DesignParameter::stiffness, safe) != false) return std::nullopt;
  return nearest_between(input, DesignParameter::stiffness, from, safe, now);
}

std::optional<double> travel_change(const DesignCase& input, const DesignOutcome& outcome) {
  constexpr double much_farther = 30;
  if (outcome.first_snap) return outcome.first_snap->stage * input.scales().span();
  DesignCase farther = input;
  try {
    farther.set(DesignParameter::travel, much_farther * input.value(DesignParameter::travel));
    const auto first = outcome_of(farther.design()).first_snap;
    if (first) return first->stage * input.scales().span() * (1 + 1e-6);  // beyond it, to have snapped
  } catch (const InputError&) {                                           // farther than can be computed
  }
  return std::nullopt;
}

}  // namespace

DesignAnswer answer_of(const DesignCase& input) {
  const Design design = input.design();
  DesignAnswer answer{
      input, design, input.scales(), outcome_of(design), critical_stiffness(design.friction, design.travel), {}};
  const bool now = answer.outcome.snaps > 0;
  const auto add = [&](DesignParameter parameter, std::optional<double> to) {
    const auto outcome = to ? outcome_with(input, parameter, *to) : std::nullopt;
    if (outcome && (outcome->snaps > 0) != now)
      answer.changes.push_back({parameter, input.value(parameter), *to, *outcome});
  };
  const auto stiffness = stiffness_change(input, design, now, answer.critical);
  add(DesignParameter::stiffness, stiffness);
  if (stiffness) {
    // k L^3/EI decides: what the stiffness must gain, the specimen may lose.
    const double softer = input.value(DesignParameter::stiffness) / *stiffness;
    if (input.has(DesignParameter::diameter))
      add(DesignParameter::diameter, input.value(DesignParameter::diameter) * std::pow(softer, 0.25));
    if (input.has(DesignParameter::modulus))
      add(DesignParameter::modulus, input.value(DesignParameter::modulus) * softer);
  }
  for (const auto parameter :
       {DesignParameter::span, DesignParameter::mu0, DesignParameter::amplitude, DesignParameter::wavelength})
    if (input.has(parameter)) add(parameter, nearest_change(input, parameter, now));
  add(DesignParameter::travel, travel_change(input, answer.outcome));
  return answer;
}

double stiffness_margin(const Design& design) {
  constexpr double most = 3;
  const double S = longest_in_loading(design.friction, design.rig, design.travel);
  const auto state = fibre_state(S, design.friction.at(S).mu);
  const double w = state.status == FibreStatus::ok ? std::min(state.w, design.travel) : design.travel;
  const double critical = critical_stiffness(design.friction, w);
  return std::clamp(std::log(design.rig.stiffness / critical), -most, most);
}

}  // namespace flexslip
