#include "bending_test/portrait.h"

#include <algorithm>

#include "contact/over_rollers.h"

namespace flexslip {
namespace {

int points_drawn_for(const Friction& friction, double S_max) {
  constexpr double most = 20000;
  const double waves = 16 * (S_max - 1) / friction.smooth_scale();
  return static_cast<int>(std::clamp(std::max(waves, 8.0 * static_cast<double>(friction.knots().size())), 300.0, most));
}

// From the straight specimen on, which a thick one leaves at once.
std::vector<EquilibriumPoint> from_straight(std::vector<EquilibriumPoint> curve) {
  if (curve.front().w > 0) curve.insert(curve.begin(), {1, 0, 0, 0});
  return curve;
}

std::vector<EquilibriumPoint> drawn(const Friction& friction, Sliding sliding, double S_max, const Fibre& fibre) {
  return from_straight(equilibrium_curve(friction, sliding, S_max, points_drawn_for(friction, S_max), fibre).points);
}

constexpr double shortest = 1.01;  // [L] that a picture shows

}  // namespace

EquilibriumPortrait portrait_of(const Friction& friction, const Fibre& fibre, double S_max) {
  EquilibriumPortrait portrait{
      drawn(friction, Sliding::in, S_max, fibre), drawn(friction, Sliding::out, S_max, fibre), {}, {}};
  portrait.frictionless = drawn(Friction::constant(0), Sliding::in, S_max, fibre);
  const double S = 1 + 0.7 * (portrait.in.back().S - 1);
  const double most = met(friction, fibre, 1, S_max).at(S).mu, least = -met(friction, fibre, -1, S_max).at(S).mu;
  constexpr int levels = 60;
  for (int i = 0; i <= levels; ++i) {
    const double q = least + (most - least) * i / levels;
    const FibreState state = fibre.state(S, q);
    if (state.status == FibreStatus::ok) portrait.at_one_length.push_back({S, q, state.w, state.F});
  }
  return portrait;
}

SlidingLimits limits_of(const BendingTest& test, const History& history) {
  double S_max = shortest;
  for (const auto& point : history.path) S_max = std::max(S_max, point.S);
  for (const auto& snap : history.snaps) S_max = std::max({S_max, snap.before.S, snap.after.S});
  const Friction& friction = test.friction.kinetic;
  SlidingLimits limits{drawn(friction, Sliding::in, S_max, test.rig.fibre), {}};
  if (!friction.depends_on_way()) limits.out = drawn(friction, Sliding::out, S_max, test.rig.fibre);
  return limits;
}

OverallPortrait overall_portrait(const Friction& friction, const Rig& rig, std::span<const double> stages) {
  const double farthest = *std::max_element(stages.begin(), stages.end());
  const SlidingCurve traced = trace_loading_curve(friction, rig, longest_at_stage(farthest));
  OverallPortrait portrait;
  double S_max = shortest;
  for (const double stage : stages) {
    portrait.at_stage.push_back(overall_equilibria(traced, stage));
    for (const auto& equilibrium : portrait.at_stage.back()) S_max = std::max(S_max, equilibrium.point.S);
  }
  S_max = std::min(1 + 1.1 * (S_max - 1), traced.end.S);
  portrait.in = drawn(friction, Sliding::in, S_max, rig.fibre);
  return portrait;
}

std::vector<EquilibriumPoint> frictionless_up_to(double deflection, int n, const Fibre& fibre) {
  return from_straight(sliding_up_to(deflection, 0, n, fibre));
}

}  // namespace flexslip
