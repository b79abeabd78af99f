#include "bending_test/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "tests/generators.h"
#include "tests/literal_algorithm1.h"
#include "tests/refusal.h"
#include "tests/unit.h"

namespace flexslip {
namespace {

// Fig. 7: μ = 0.3 (1 + 0.2 cos(S/0.02)).
Friction friction_of_fig_7() { return Friction::sinusoid(0.3, 0.2, 0.02 * std::numbers::pi, 0); }

doctest::Approx within(double epsilon, double value) { return doctest::Approx(value).epsilon(epsilon); }

}  // namespace

TEST_CASE("equilibrium: every point of the region has |q| <= mu(S), and is a state (paper, Fig. 7)") {
  const auto friction = friction_of_fig_7();
  const auto region = equilibrium_region(friction, 1.4, 60, 21);
  REQUIRE(region.size() == 60 * 21);
  for (const auto& [S, q, w, F] : region) {
    CHECK(std::abs(q) <= friction.at(S).mu);
    const auto state = fibre_state(S, q);
    CHECK(state.w == w);
    CHECK(state.F == F);
  }
  CHECK(region.front().S == 1);
  CHECK(region.back().S == 1.4);
}

TEST_CASE(
    "equilibrium: the tabulated curve is the exact one to the accuracy of the table, and ends where it ends (oracle)") {
  for (const double S_max : {1.4, 1.9, 3.0})
    for (const Sliding sliding : {Sliding::in, Sliding::out}) {
      const auto exact = equilibrium_curve(friction_of_fig_7(), sliding, S_max, 500);
      const auto table = tabulated_equilibrium_curve(friction_of_fig_7(), sliding, S_max, 500);
      REQUIRE(table.points.size() == exact.points.size());
      CHECK(table.status == exact.status);
      for (std::size_t i = 0; i < exact.points.size(); ++i) {
        CHECK(table.points[i].S == exact.points[i].S);
        CHECK(table.points[i].q == exact.points[i].q);
        CHECK(std::abs(table.points[i].w - exact.points[i].w) <= 1e-12 * exact.points[i].w);
        CHECK(std::abs(table.points[i].F - exact.points[i].F) <=
              1e-12 * (10 + exact.points[i].F));  // F -> 0 at the end
      }
    }
}

TEST_CASE("equilibrium: the curve is the upper envelope of the region, its counterpart the lower (paper, Fig. 7)") {
  const auto friction = friction_of_fig_7();
  const int n_S = 60, n_q = 21;
  const auto region = equilibrium_region(friction, 1.4, n_S, n_q);
  const auto upper = equilibrium_curve(friction, Sliding::in, 1.4, n_S);
  const auto lower = equilibrium_curve(friction, Sliding::out, 1.4, n_S);
  REQUIRE(upper.status == EquilibriumStatus::ok);
  REQUIRE(upper.points.size() == n_S);
  REQUIRE(lower.points.size() == n_S);
  for (std::size_t i = 0; i < n_S; ++i) {
    const auto first = region.begin() + static_cast<std::ptrdiff_t>(i * n_q);
    const auto [least, most] = std::minmax_element(first, first + n_q, [](auto& a, auto& b) { return a.F < b.F; });
    CHECK(upper.points[i].q == friction.at(upper.points[i].S).mu);
    CHECK(lower.points[i].q == -friction.at(lower.points[i].S).mu);
    CHECK(upper.points[i].S == most->S);
    CHECK(upper.points[i].F == within(4 * unit, most->F));
    CHECK(lower.points[i].F == within(4 * unit, least->F));
    if (i > 0) CHECK(upper.points[i].S > upper.points[i - 1].S);  // remark 1 of the paper's section 4.2.4
    if (i > 0) CHECK(upper.points[i].w > upper.points[i - 1].w);
  }
}

TEST_CASE("equilibrium: the region equals a literal Algorithm 1 with its step corrected (oracle: quadrature)") {
  // Lines 2 to 12: S by (S* - 1)/n, β0 from arccot μ to arccot -μ; then back from (w, F) to (S, q).
  const auto friction = friction_of_fig_7();
  const double S_last = 1.4;
  const int n_S = 6, n_beta = 4;
  for (int i = 1; i <= n_S; ++i) {
    const double S = 1 + (S_last - 1) / n_S * i;
    const double mu = 0.3 * (1 + 0.2 * std::cos(S / 0.02));
    const double least = std::atan2(1, mu), most = std::atan2(1, -mu);
    for (int j = 0; j <= n_beta; ++j) {
      const double beta0 = least + (most - least) / n_beta * j;
      const double q = -1 / std::tan(beta0);
      const auto literal = LiteralFibre(S, q).state();
      const auto state = fibre_state_from_force(literal.w, literal.F);
      CAPTURE(S);
      CAPTURE(q);
      REQUIRE(state.status == FibreStatus::ok);
      CHECK(state.S == within(1e-12, S));     // quadrature to 1e-15 of L
      CHECK(std::abs(state.q - q) <= 1e-10);  // times the condition of q
      CHECK(std::abs(state.q) <= friction.at(S).mu + 1e-10);
    }
  }
  // The curve: line 5 replaced, as the paper says.
  for (const auto& [S, q, w, F] : equilibrium_curve(friction, Sliding::in, S_last, 8).points) {
    if (S == 1) continue;
    const auto literal = LiteralFibre(S, 0.3 * (1 + 0.2 * std::cos(S / 0.02))).state();
    CHECK(w == within(1e-11, literal.w));
    CHECK(F == within(1e-11, literal.F));
  }
}

TEST_CASE("equilibrium: the curve starts straight in the square root of S - 1 (limit)") {
  const auto curve = equilibrium_curve(Friction::constant(0.6), Sliding::in, 1.0001, 11);
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const double fraction = static_cast<double>(i) / 10;
    CHECK(curve.points[i].w == within(0.02, fraction * std::sqrt(1e-4 / 2.4)));  // corrections of order w
    CHECK(curve.points[i].F == within(0.03, 48 * curve.points[i].w));
  }
}

TEST_CASE("equilibrium: a curve that reaches the end of the branch ends there with F = 0 (limit)") {
  const auto end = fibre_branch_end(0);
  const auto curve = equilibrium_curve(Friction::constant(0), Sliding::in, 3, 50);
  REQUIRE(curve.status == EquilibriumStatus::branch_ended);
  CHECK(curve.points.size() < 50);
  CHECK(curve.points.back().S == within(16 * unit, end.S));
  CHECK(curve.points.back().w == within(1e-14, end.w));
  CHECK(curve.points.back().F <= 1e-14);
  for (std::size_t i = 1; i < curve.points.size(); ++i) CHECK(curve.points[i].S > curve.points[i - 1].S);

  const auto out = equilibrium_curve(friction_of_fig_7(), Sliding::out, 2.5, 200);
  REQUIRE(out.status == EquilibriumStatus::branch_ended);
  CHECK(out.points.back().F <= 1e-13);
  CHECK(out.points.back().S == within(1e-12, fibre_branch_end(out.points.back().q).S));

  CHECK(equilibrium_curve(Friction::constant(0.9), Sliding::in, 30, 50).status == EquilibriumStatus::ok);  // no end
  const auto region = equilibrium_region(Friction::constant(0.3), 2.5, 40, 5);
  CHECK(region.size() < 200);
  for (const auto& point : region) CHECK(point.F >= 0);
}

TEST_CASE("equilibrium: every point of a curve is a state with the friction of its length (identity)") {
  CHECK(rc::check("random sinusoids", [] {
    const auto friction = Friction::sinusoid(*between(0, 1), *between(0, 1), *between(0.004, 0.2), *between(-4, 4));
    const auto direction = *whole(0, 1) == 0 ? Sliding::in : Sliding::out;
    const double S_max = 1 + std::pow(10, *between(-8, 0));
    const auto curve = equilibrium_curve(friction, direction, S_max, *whole(2, 40));
    if (curve.status == EquilibriumStatus::ok) RC_ASSERT(curve.points.back().S == S_max);
    for (const auto& point : curve.points) {
      RC_ASSERT(std::abs(point.q) == friction.at(point.S).mu);
      RC_ASSERT(point.F == fibre_state(point.S, point.q).F);
    }
  }));
}

TEST_CASE("equilibrium: an input outside the domain is refused with its value (contract)") {
  const auto friction = friction_of_fig_7();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto curve_to = [&](double S_max, int n) {
    return message_of([&] { equilibrium_curve(friction, Sliding::in, S_max, n); });
  };
  CHECK(curve_to(1.0, 10).find("1.0") != std::string::npos);
  CHECK(curve_to(nan, 10).find("nan") != std::string::npos);
  CHECK(curve_to(1.4, 1).find("1") != std::string::npos);
  CHECK(message_of([&] { equilibrium_region(friction, 0.5, 10, 10); }).find("0.5") != std::string::npos);
  CHECK(message_of([&] { equilibrium_region(friction, 1.5, 10, 1); }).find("1") != std::string::npos);
}

TEST_CASE("equilibrium: an endless curve is refused (contract)") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(message_of([&] { equilibrium_curve(Friction::constant(0.9), Sliding::in, inf, 10); }).find("inf") !=
        std::string::npos);
}

}  // namespace flexslip
