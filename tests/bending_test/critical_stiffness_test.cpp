#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "bending_test/design.h"
#include "bending_test/rig.h"
#include "bending_test/trace.h"
#include "fibre/elastica.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/fig_8.h"
#include "tests/generators.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

FibreState state_on(const Friction& friction, double S) { return fibre_state(S, friction.at(S).mu); }

// Deflection rises along the curve: where it reaches w_max.
double length_at_deflection(const Friction& friction, double w_max) {
  double low = 1, high = longest_at_stage(w_max);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const auto state = state_on(friction, middle);
    (state.status == FibreStatus::ok && state.w < w_max ? low : high) = middle;
  }
  return low;
}

// The oracle: -dF/dw between neighbours of a dense sample, from the states alone.
double sampled_critical_stiffness(const Friction& friction, double w_max, int n) {
  const double S_end = length_at_deflection(friction, w_max);
  double most = 0;
  auto last = state_on(friction, 1);
  for (int i = 1; i <= n; ++i) {
    const double sigma = std::sqrt(S_end - 1) * i / n;
    const auto next = state_on(friction, 1 + sigma * sigma);
    if (next.status != FibreStatus::ok) break;
    most = std::max(most, -(next.F - last.F) / (next.w - last.w));
    last = next;
  }
  return most;
}

bool snaps(const Friction& friction, double stiffness, double w_max) {
  return !trace_loading_curve(friction, {stiffness}, length_at_deflection(friction, w_max)).folds.empty();
}

}  // namespace

TEST_CASE("critical stiffness, oracle: the steepest fall of densely sampled states") {
  CHECK(rc::check([] {
    const double mu0 = *between(0.05, 1.2);
    const double wavelength = std::pow(10, *between(-2, -0.5));
    const Friction friction = Friction::waves({mu0,
                                               0,
                                               {{*between(0, 0.5), wavelength, *between(0, 6.28)},
                                                {*between(0, 0.5), wavelength * *between(1, 3), *between(0, 6.28)}}});
    const double w_max = *between(0.1, 0.55);
    const double k = critical_stiffness(friction, w_max);
    const double sampled = sampled_critical_stiffness(friction, w_max, 40000);
    RC_PRE(k < infinity);
    // A chord is never steeper than the curve somewhere beneath it. It is less steep by (π h/P)^2/6 of the rough part at the
    // cusp, h/P being at most a hundredth of a period here; at the end of the range by half a step.
    RC_ASSERT(sampled <= k * (1 + 1e-9) + 1e-6);
    RC_ASSERT(sampled >= k - 3e-3 * (k + 48));
  }));
}

TEST_CASE("critical stiffness, oracle: the tracer finds folds just below it and none just above it") {
  CHECK(rc::check([] {
    const double w_max = *between(0.2, 0.5);
    const Friction friction =
        Friction::sinusoid(*between(0.2, 1.2), *between(0.02, 0.9), *between(0.008, 0.1), *between(0, 6.28));
    const double k = critical_stiffness(friction, w_max);
    RC_PRE(k > 1e-3 && k < infinity);
    // 1e-6: the ends of the two ranges, found in two ways, differ by rounding
    RC_ASSERT(snaps(friction, 0.999 * k, w_max));
    RC_ASSERT(!snaps(friction, 1.001 * k, w_max));
  }));
}

TEST_CASE("critical stiffness, identity: there G' and G'' vanish together") {
  const Friction friction = friction_of_fig_8();
  const double k = critical_stiffness(friction, 0.5);
  // Just below it the last pair of folds encloses the cusp, at a distance proportional to the root of the difference in k.
  const auto curve = trace_loading_curve(friction, {k * (1 - 1e-8)}, length_at_deflection(friction, 0.5));
  REQUIRE(curve.folds.size() == 2);
  const double S = 0.5 * (curve.folds[0].point.S + curve.folds[1].point.S);
  const double half = 0.5 * (curve.folds[1].point.S - curve.folds[0].point.S);
  CHECK(half < 1e-4 * 0.04 * std::numbers::pi);  // √(2e-8)/2π of a period of 2λ, and a factor for the rest
  const auto slope = [&](double at) {
    const auto mu = friction.at(at);
    const auto slopes = fibre_state_slopes(at, mu.mu).slopes;
    return slopes.w_S + slopes.F_S / k + (slopes.w_q + slopes.F_q / k) * mu.slope;
  };
  const double size = fibre_state_slopes(S, friction.at(S).mu).slopes.w_S;
  CHECK(std::abs(slope(S)) < 2e-8 * size);  // what k lacks
  const double h = 1e-3;
  const double second = (slope(S + h) - slope(S - h)) / (2 * h);
  const double third = (slope(S + h) - 2 * slope(S) + slope(S - h)) / (h * h);
  CHECK(third > 0);
  // The root of G'' is within the distance of the folds, and h^2/6 of the fourth derivative of G' (2π/P)^2 G''' away.
  CHECK(std::abs(second) < third * (half + h * h * 2500));
}

TEST_CASE(
    "critical stiffness, limit: of constant friction it is the slope at the end of the range, beyond the peak of the "
    "force") {
  for (const double mu : {0.0, 0.3, 0.6}) {
    const Friction friction = Friction::constant(mu);
    const double S = length_at_deflection(friction, 0.35);
    const auto slopes = fibre_state_slopes(S, mu).slopes;
    CHECK(critical_stiffness(friction, 0.35) == to(1e-12, -slopes.F_S / slopes.w_S));  // rounding of w at the end
  }
}

TEST_CASE("critical stiffness, table: no rig snaps before the frictionless peak of the force") {
  constexpr double peak = 0.238188798912727;  // MODEL, section 2
  const Friction none = Friction::constant(0);
  CHECK(critical_stiffness(none, peak * (1 - 1e-6)) == 0);
  CHECK(critical_stiffness(none, peak * (1 + 1e-3)) > 0);
}

TEST_CASE("critical stiffness, limit: a friction that falls fast enough snaps with the deflection itself controlled") {
  // From 19 to nothing within 1e-4 of the span: w rises with q.
  const Friction cliff = Friction::table({{1.0, 1.2, 1.2001, 2.0}, {19.0, 19.0, 0.0, 0.0}});
  REQUIRE(state_on(cliff, 1.2001).w < state_on(cliff, 1.2).w);
  CHECK(critical_stiffness(cliff, 0.4) == infinity);
  CHECK(critical_stiffness(cliff, 0.2) < infinity);
}

TEST_CASE(
    "critical stiffness, limit: at the corner of a table a pair of folds closes to the rounding of lengths, and is "
    "followed there") {
  for (const auto& [S_1, S_2] : {std::pair{1.48, 1.485}, std::pair{1.4, 1.41}}) {
    const Friction ramp = Friction::table({{S_1, S_2}, {0.9, 0.5}});
    const double k = critical_stiffness(ramp, 0.9);
    const auto S_end = longest_at_stage(0.9);
    CHECK(trace_loading_curve(ramp, {1.001 * k}, S_end).folds.size() <
          trace_loading_curve(ramp, {0.999 * k}, S_end).folds.size());
  }
}

TEST_CASE("critical stiffness, contract: what is out of their domain is refused with its value") {
  CHECK(message_of([] { critical_stiffness(friction_of_fig_8(), 0); }).find("0.000000") != std::string::npos);
  CHECK(message_of([] { critical_stiffness(friction_of_fig_8(), infinity); }).find("inf") != std::string::npos);
}

}  // namespace flexslip
