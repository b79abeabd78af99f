#include "case/equilibrium_study.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "case/problem.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {
namespace {

constexpr double longest_by_default = 1.5;  // [L] about where a real test ends: deflections to half the span

// The length up to which to compute.
double longest_of(const EquilibriumChoice& choice, const Case& input, const Scales& scales) {
  if (choice.longest.empty()) return longest_by_default;
  try {
    const double length = parse_quantity(choice.longest, kind_in(input, kind::length), Range::positive);
    const double S_max = scales.reduced_length(length);
    if (!(S_max > 1))
      throw InputError({.expected = "a length greater than the span", .found = in_quotes(choice.longest)});
    return S_max;
  } catch (const InputError& error) {
    throw located(error, "", 0, "--longest");
  }
}

// Enough points that no period or piece of the friction goes unseen: spaced evenly in √(S - 1), the last are the farthest
// apart, 2 (S_max - 1)/n.
int points_for(const Friction& friction, double S_max) {
  const double for_waves = 8 * (S_max - 1) / friction.smooth_scale();
  const double for_knots = 4 * static_cast<double>(friction.knots().size());
  return static_cast<int>(std::clamp(std::max(for_waves, for_knots), 500.0, static_cast<double>(most_equilibria)));
}

}  // namespace

EquilibriumStudy study_equilibria(const Case& input, const EquilibriumChoice& choice) {
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  const double S_max = longest_of(choice, input, scales);
  const Fibre fibre = fibre_of(input, scales);
  const Friction friction = friction_of(input, fibre, scales, S_max);
  const int n = choice.points > 0 ? choice.points : choice.region ? 100 : points_for(friction, S_max);
  EquilibriumStudy study{
      input.reduced, is_in_inches(input), choice.region, scales, fibre, friction, S_max, EquilibriumStatus::ok, {}};
  if (choice.region) {
    study.points = equilibrium_region(friction, S_max, n, choice.levels, fibre);
    return study;
  }
  auto curve = equilibrium_curve(friction, Sliding::in, S_max, n, fibre);
  study.status = curve.status;
  study.points = std::move(curve.points);
  return study;
}

EquilibriumPortrait portrait_of(const EquilibriumStudy& study) {
  return portrait_of(study.friction, study.fibre, study.longest);
}

}  // namespace flexslip
