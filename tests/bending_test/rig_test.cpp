#include "bending_test/rig.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/trace.h"
#include "fibre/elastica.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/bending_test/some_rig.h"
#include "tests/fig_8.h"
#include "tests/generators.h"
#include "tests/unit.h"

namespace flexslip {
namespace {

constexpr double first_fold_of_second_tooth = 0.698273165117728631;  // folds.csv

std::vector<Stability> stabilities(const std::vector<OverallEquilibrium>& found) {
  std::vector<Stability> all;
  for (const auto& equilibrium : found) all.push_back(equilibrium.stability);
  return all;
}

// What 16 ulp of S do to G: the accuracy promised of an equilibrium.
double rounding_of_stage(const RigPoint& point) {
  return 16 * unit * (std::abs(point.stage_slope) * point.S + point.stage);
}

}  // namespace

TEST_CASE(
    "rig: one, three and five overall equilibria at w_s = 0.52, 0.65, 0.69, alternately stable and unstable (paper, "
    "Fig. "
    "8B)") {
  const auto curve = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, longest_at_stage(0.7));
  using enum Stability;
  CHECK(stabilities(overall_equilibria(curve, 0.52)) == std::vector{stable});
  CHECK(stabilities(overall_equilibria(curve, 0.65)) == std::vector{stable, unstable, stable});
  CHECK(stabilities(overall_equilibria(curve, 0.69)) == std::vector{stable, unstable, stable, unstable, stable});
}

TEST_CASE("rig: at the fold the equilibrium is partially stable (paper, Fig. 8B)") {
  const auto curve = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, longest_at_stage(0.7));
  using enum Stability;
  const auto found = overall_equilibria(curve, first_fold_of_second_tooth);
  CHECK(stabilities(found) == std::vector{partially_stable, stable, unstable, stable});  // four, as the paper counts
  REQUIRE(!found.empty());
  CHECK(found.front().point.S == to(1e-12, 1.26251965972998261868));
  CHECK(stabilities(overall_equilibria(curve, first_fold_of_second_tooth * (1 + 1e-8))) ==
        std::vector{stable, unstable, stable});
}

TEST_CASE("rig: every overall equilibrium balances wedge and cantilever, and all are found (oracle: dense sampling)") {
  CHECK(rc::check("random rigs and stage positions", [] {
    const double wavelength = *between(0.01, 0.2);
    const auto friction = Friction::sinusoid(*between(0.1, 0.9), *between(0, 0.6), wavelength, *between(0, 6));
    const Rig rig = any_rig();
    const double stage = *between(0.05, 0.7);
    const auto curve = trace_loading_curve(friction, rig, longest_at_stage(stage));
    const auto found = overall_equilibria(curve, stage);
    for (const auto& [point, stability] : found) {
      RC_ASSERT(std::abs(rig.stiffness * (stage - point.w) - point.F) <= rig.stiffness * rounding_of_stage(point));
      RC_ASSERT((stability == Stability::stable) == (point.stage_slope > 0));
      RC_ASSERT(point.q == friction.at(point.S).mu);
    }
    // Roots as changes of sign; a pair within one step is not seen, hence <=.
    const int n = 20 + static_cast<int>(100 * (curve.end.S - 1) / wavelength);
    std::size_t roots = 0;
    bool below = true;
    for (int i = 1; i <= n; ++i) {
      const bool now = stage_at(friction, rig, 1 + (curve.end.S - 1) * i / n) < stage;
      roots += now != below;
      below = now;
    }
    RC_ASSERT(roots <= found.size());
    RC_ASSERT((found.size() - roots) % 2 == 0u);
    RC_ASSERT(found.size() <= roots + 2);
  }));
}

TEST_CASE("rig: with infinite stiffness the stage position is the deflection (limit)") {
  const auto curve = trace_loading_curve(friction_of_fig_8(), {infinity}, 1.6);
  CHECK(curve.folds.empty());  // the deflection depends almost on S alone
  for (const double S : {1.0, 1.1, 1.5}) CHECK(point_at_length(curve, S).stage == point_at_length(curve, S).w);
  const auto found = overall_equilibria(curve, 0.4);
  REQUIRE(found.size() == 1);
  CHECK(found.front().point.w == to(16 * unit, 0.4));
}

TEST_CASE("rig: a fibre longer than longest_at_stage is at a later stage position (identity)") {
  CHECK(rc::check("q in [0, 20]", [] {
    const double stage = std::pow(10, *between(-5, 1));
    const double S = longest_at_stage(stage) * (1 + std::pow(10, *between(-12, 0)));
    const auto state = fibre_state(S, *between(0, 20));
    RC_PRE(state.status == FibreStatus::ok);
    RC_ASSERT(state.w > stage * (1 - 4 * unit / std::min(stage * stage, 1.0)));  // S - 1 is known to the rounding of S
  }));
  CHECK(longest_at_stage(0.5) == to(4 * unit, 1.6));
}

TEST_CASE("rig: slope and stage of a point agree with the curve (oracle: differences)") {
  CHECK(rc::check("random points of Fig. 8B", [] {
    const auto friction = friction_of_fig_8();
    static const auto curve = trace_loading_curve(friction, rig_of_fig_8, 1.5);
    const double S = *between(1.01, 1.49), h = 1e-6;
    const auto point = point_at_length(curve, S);
    RC_ASSERT(std::abs(point.stage - stage_at(friction, rig_of_fig_8, S)) <= 4 * unit);
    const double difference =
        (stage_at(friction, rig_of_fig_8, S + h) - stage_at(friction, rig_of_fig_8, S - h)) / (2 * h);
    RC_ASSERT(std::abs(point.stage_slope - difference) <= 1e-5);  // G''' h^2/6, G''' of 1e6 with λ
  }));
}

TEST_CASE("rig: stable parts rise, and each takes over where the one before ended (identity)") {
  CHECK(rc::check("random rigs", [] {
    const auto friction = Friction::sinusoid(*between(0.1, 0.9), *between(0, 0.8), *between(0.01, 0.1), *between(0, 6));
    const auto curve = trace_loading_curve(friction, any_rig(), 1.6);
    const auto parts = stable_parts(curve);
    RC_ASSERT(!parts.empty() && parts.front().from.S == 1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto& [from, last] = parts[i];
      RC_ASSERT(from.S < last.S && from.stage < last.stage);
      if (i > 0) {
        RC_ASSERT(std::abs(from.stage - parts[i - 1].to.stage) <= rounding_of_stage(from));
        RC_ASSERT(from.S > parts[i - 1].to.S);
      }
      const double stage = from.stage + (last.stage - from.stage) * *between(0, 1);
      const auto point = point_at_stage(curve, parts[i], stage);
      RC_ASSERT(std::abs(point.stage - stage) <= rounding_of_stage(point));
      RC_ASSERT(point.S >= from.S && point.S <= last.S);
      // The first S with G >= stage: no stable part before reaches it, and no equilibrium lies before it.
      for (const auto& equilibrium : overall_equilibria(curve, stage))
        RC_ASSERT(equilibrium.point.S >= point.S * (1 - 1e-7));
    }
  }));
}

}  // namespace flexslip
