#include "bending_test/sliding_table.h"

#include <cmath>
#include <vector>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "tests/generators.h"

namespace flexslip {
namespace {

// The same integrals, over pieces a twentieth of a period long.
SlidingWork by_quadrature(const Friction& friction, const Rig& rig, double sign, double from, double to, double piece) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 21>;
  SlidingWork sum{0, 0};
  const int n = static_cast<int>(std::ceil((to - from) / piece));
  for (int i = 0; i < n; ++i) {
    const double a = from + (to - from) * i / n, b = from + (to - from) * (i + 1) / n;
    const auto friction_power = [&](double S) {
      const double q = sign * friction.at(S).mu;
      return q * fibre_state(S, q).Pn;
    };
    const auto stage_power = [&](double S) {
      const auto mu = friction.at(S);
      const auto [state, slopes] = fibre_state_slopes(S, sign * mu.mu);
      return state.F *
             (slopes.w_S + slopes.F_S / rig.stiffness + sign * (slopes.w_q + slopes.F_q / rig.stiffness) * mu.slope);
    };
    sum.friction += Rule::integrate(friction_power, a, b, 0);
    sum.stage += Rule::integrate(stage_power, a, b, 0);
  }
  return sum;
}

}  // namespace

TEST_CASE("sliding table: work along a curve, both ways (oracle: Gauss-Kronrod quadrature of Boost.Math)") {
  CHECK(rc::check("random roughness", [] {
    const double wavelength = *between(0.01, 0.2);
    const Friction friction = Friction::sinusoid(*between(0, 0.8), *between(0, 1), wavelength, *between(0, 6.3));
    const Rig rig{*between(10, 500)};
    const double sign = *whole(0, 1) ? 1 : -1;
    SlidingTable table(friction, rig, sign > 0 ? Sliding::in : Sliding::out);
    const double from = 1 + *between(0.001, 0.1), to = from + *between(0.001, 0.05);
    const SlidingWork work = table.work(from, to), back = table.work(to, from);
    const SlidingWork oracle = by_quadrature(friction, rig, sign, from, to, 0.1 * wavelength);
    if (std::isnan(oracle.stage)) return;  // no force holds the fibre all the way
    // Of the work on a whole cell, which may be longer than the way asked for; and rounding of lengths, where friction is steep, on forces of the order of 10.
    const double close = 1e-11 + 0x1p-50 * 10 * friction.steepest();
    RC_ASSERT(std::abs(work.stage - oracle.stage) <= close);
    RC_ASSERT(std::abs(work.friction - oracle.friction) <= close);
    RC_ASSERT(back.stage == -work.stage && back.friction == -work.friction);
  }));
}

TEST_CASE("sliding table: where friction is held at zero the kink costs no accuracy (oracle: the two sides)") {
  const Friction friction = Friction::waves({.mu0 = 0.3, .drift = -3, .terms = {}});  // zero from S = 1.1 on
  SlidingTable table(friction, {50}, Sliding::in);
  const SlidingWork work = table.work(1.05, 1.15);
  const SlidingWork oracle = by_quadrature(friction, {50}, 1, 1.05, 1.1, 0.01);
  CHECK(std::abs(work.friction - oracle.friction) <= 1e-10);
}

TEST_CASE("sliding table: a roughness of a thousandth of a thousandth is tabulated without splitting hairs (limit)") {
  // The rounding of S is visible in such a short wave. Mistaken for a lack of resolution, it would cause 200 pieces a cell.
  const Friction friction = Friction::sinusoid(0.5, 0.2, 3e-5, 1);
  SlidingTable table(friction, {1000}, Sliding::in);
  const SlidingWork work = table.work(1.1, 1.1 + 6e-4);
  const SlidingWork oracle = by_quadrature(friction, {1000}, 1, 1.1, 1.1 + 6e-4, 3e-6);
  CHECK(std::abs(work.friction - oracle.friction) <= 1e-10 * oracle.friction);
}

}  // namespace flexslip
