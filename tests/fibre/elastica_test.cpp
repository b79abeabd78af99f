#include "fibre/elastica.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/fibre/accuracy.h"
#include "tests/fibre/ladder.h"
#include "tests/generators.h"
#include "tests/literal_algorithm1.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

struct StateRow {
  const char* group;
  double S, q;
  Digits u, w, F, theta0, Pn, U;
  Digits w_S, w_q, F_S, F_q, U_S, U_q, Pn_S, Pn_q, condition_F_S, condition_F_q, theta0_S, theta0_q;
};
struct EndRow {
  const char* group;
  double q;
  Digits S, w, u, theta0, Pn, U;
};
struct PoleRow {
  const char* group;
  double q;
  Digits u;
};
struct ShapeRow {
  const char* group;
  double S, q, fraction;
  Digits x, y, theta;
};

const std::vector<StateRow>& state_rows() {
  static const std::vector<StateRow> rows{
#include "reference/states.inc"
  };
  return rows;
}
const std::vector<EndRow> end_rows{
#include "reference/ends.inc"
};
const std::vector<PoleRow> pole_rows{
#include "reference/poles.inc"
};
const std::vector<ShapeRow> shape_rows{
#include "reference/shapes.inc"
};

// What a relative change in S - 1 or in q does to F.
double condition_of_F(const StateRow& row) {
  if (row.S == 1) return 1;
  return 1 + std::abs((row.S - 1) * row.F_S.hi / row.F.hi) + std::abs(row.condition_F_q.hi);
}

// A state to try a property on: q in [-20, 20], S up to the end of the branch, at most 30, and down to S - 1 = 1e-12.
struct Somewhere {
  double S, q;
};
Somewhere somewhere(double q_min, double q_max, double S_max) {
  const double q = *between(q_min, q_max);
  const double last = std::min(fibre_branch_end(q).S, S_max) - 1;
  return {1 + last * std::pow(*between(1e-3, 0.999), 4), q};
}

// Composite Simpson's rule on 2 n pieces.
template <class Function>
double simpson(Function f, double from, double to, int n) {
  const double h = (to - from) / (2 * n);
  double sum = f(from) + f(to);
  for (int i = 1; i < 2 * n; ++i) sum += (i % 2 ? 4 : 2) * f(from + h * i);
  return sum * h / 3;
}

// The fibre's equation (4.7) integrated by Runge and Kutta from the support (slope theta0, no moment) to midspan: the slope
// there, and the distances travelled.
struct Shot {
  double theta, x, y;
};
Shot shoot(double S, double q, double theta0, double Pn) {
  const double beta0 = std::atan2(1.0, -q);
  const double P1 = Pn / std::sin(beta0) * std::cos(theta0 - beta0);  // (4.10)
  const double P2 = Pn / std::sin(beta0) * std::sin(theta0 - beta0);
  using Vector = std::array<double, 4>;  // θ, θ', x, y
  const auto rate = [&](const Vector& v) {
    return Vector{v[1], S * S * (P2 * std::cos(v[0]) - P1 * std::sin(v[0])), S * std::cos(v[0]), S * std::sin(v[0])};
  };
  const auto plus = [](const Vector& v, double h, const Vector& k) {
    return Vector{v[0] + h * k[0], v[1] + h * k[1], v[2] + h * k[2], v[3] + h * k[3]};
  };
  constexpr int steps = 2000;  // the error, of order h^4, is below 1e-12
  constexpr double h = 0.5 / steps;
  Vector v{theta0, 0, 0, 0};
  for (int i = 0; i < steps; ++i) {
    const Vector k1 = rate(v), k2 = rate(plus(v, h / 2, k1)), k3 = rate(plus(v, h / 2, k2)), k4 = rate(plus(v, h, k3));
    v = plus(plus(plus(plus(v, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return {v[0], v[2], v[3]};
}

// The largest force at constant q: the zero of F_S, by bisection.
FibreState peak(double q) {
  double low = 1.01, high = 1.6;
  while (high - low > 0x1p-52) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (fibre_state_slopes(middle, q).slopes.F_S > 0 ? low : high) = middle;
  }
  return fibre_state(low, q);
}

// doctest's Approx, relative.
doctest::Approx within(double epsilon, double value) { return doctest::Approx(value).epsilon(epsilon); }

}  // namespace

Worsts measured_states() {
  Worsts worsts;
  for (const auto& row : state_rows()) {
    const auto [state, slopes] = fibre_state_slopes(row.S, row.q);
    const auto name = row_name("S", row.S, "q", row.q);
    const double condition = condition_of_F(row);
    const auto add = [&](const char* quantity, double error) { worsts.add(row.group, quantity, error, name); };
    add("w", error_of(state.w, row.w));
    add("F", error_of(state.F, row.F));
    add("F / condition", error_of(state.F, row.F) / condition);
    add("Pn", error_of(state.Pn, row.Pn));
    add("U", error_of(state.U, row.U));
    add("theta0", error_of(state.theta0, row.theta0));
    if (row.S == 1) continue;
    // Slopes vanish where the state does not: their errors are measured by the larger of the slope and value/variable.
    const auto slopes_of = [&](const std::string& quantity, double in_S, const Digits& S_truth, double in_q,
                               const Digits& q_truth, double value, double by) {
      const double S_size = std::max(std::abs(S_truth.hi), std::abs(value) / (row.S - 1));
      const double q_size = std::max(std::abs(q_truth.hi), std::abs(value) / (1 + std::abs(row.q)));
      add((quantity + "_S").c_str(), std::abs((in_S - S_truth.hi) - S_truth.lo) / (unit * S_size * by));
      add((quantity + "_q").c_str(), std::abs((in_q - q_truth.hi) - q_truth.lo) / (unit * q_size * by));
    };
    slopes_of("w", slopes.w_S, row.w_S, slopes.w_q, row.w_q, row.w.hi, 1);
    slopes_of("Pn", slopes.Pn_S, row.Pn_S, slopes.Pn_q, row.Pn_q, row.Pn.hi, 1);
    slopes_of("theta0", slopes.theta0_S, row.theta0_S, slopes.theta0_q, row.theta0_q, row.theta0.hi, 1);
    slopes_of("U", slopes.U_S, row.U_S, slopes.U_q, row.U_q, row.U.hi, 1);
    slopes_of("F", slopes.F_S, row.F_S, slopes.F_q, row.F_q, row.F.hi, condition);
  }
  return worsts;
}

TEST_CASE("elastica: states keep the errors promised in the header (table)") {
  const auto worsts = measured_states();
  const auto check = [&](const char* quantity, double bound) {
    const auto& worst = worsts.of(quantity);
    INFO(quantity, ": ", worst.error * unit, " at ", worst.row);
    CHECK(worst.error * unit <= bound);
  };
  check("w", 3e-15);
  check("Pn", 3e-15);
  check("theta0", 4e-15);
  check("U", 8e-15);
  check("F / condition", 8e-15);
  for (const char* slope : {"w_S", "w_q", "F_S", "F_q", "Pn_S", "Pn_q", "U_S", "U_q", "theta0_S", "theta0_q"})
    check(slope, 1e-14);
}

TEST_CASE("elastica: the errors promised hold everywhere (oracle: AGM ladder in 50 digits)") {
  CHECK(rc::check("q in [-20, 20], S along the branch", [] {
    const auto [S, q] = somewhere(-20, 20, 100);
    const auto [state, slopes] = fibre_state_slopes(S, q);
    const Fifty h = sqrt(1 + Fifty(q) * q), s0 = 1 / h, c0 = -q / h, m = (1 - c0) / 2, m1 = (1 + c0) / 2;
    // From the program's u, Newton's iteration to S in 50 digits; the closed forms of docs/theory.md in P, R and V.
    Fifty u = state.u, z, V, sin_b, theta0;
    for (int i = 0; i < 4; ++i) {
      const Ladder<Fifty> jacobi(u, m, m1);
      const Fifty x = s0 * (1 - jacobi.cn) / jacobi.dn / 2, y = (m1 + m * jacobi.cn) / jacobi.dn;
      const Fifty p = s0 * jacobi.P, r = s0 * s0 * jacobi.R / 2;
      const Fifty drawn = (u * 2 * x * x + (1 - 2 * x * x) * r - 2 * x * y * p) / u;
      z = 2 * x * y * (u - r) - (1 - 2 * x * x) * p;
      V = jacobi.V;
      sin_b = s0 * jacobi.cn / (jacobi.dn * jacobi.dn);
      theta0 = 2 * atan2(x, y);
      u -= (drawn - (S - Fifty(1)) / S) * u / (s0 * jacobi.sn / jacobi.dn * z - drawn);
    }
    const Fifty a = u / S;
    const double condition = 1 + std::abs((S - 1) * slopes.F_S / state.F) + std::abs(q * slopes.F_q / state.F);
    RC_ASSERT(error_of(state.w, digits(z / (2 * a))) * unit <= 3e-15);
    RC_ASSERT(error_of(state.Pn, digits(4 * a * a * s0)) * unit <= 3e-15);
    RC_ASSERT(error_of(state.theta0, digits(theta0)) * unit <= 4e-15);
    RC_ASSERT(error_of(state.U, digits(2 * a * s0 * s0 * V)) * unit <= 8e-15);
    RC_ASSERT(error_of(state.F, digits(8 * a * a * sin_b)) * unit <= 8e-15 * condition);
  }));
}

TEST_CASE("elastica: w and F determine S and q (table)") {
  for (const auto& row : state_rows()) {
    if (std::abs(row.q) == 20) continue;  // the rounding of w and F carries q beyond what the inverse takes
    const auto state = fibre_state_from_force(row.w.hi, row.F.hi);
    CAPTURE(row.group);
    CAPTURE(row.S);
    CAPTURE(row.q);
    REQUIRE(state.status == FibreStatus::ok);
    if (row.S == 1) {
      CHECK(state.S == 1);
      continue;
    }
    const double dw = 32 * unit * row.S * row.w.hi;  // what the header promises
    const double dF = 32 * unit * row.S * row.F.hi * condition_of_F(row);
    CHECK(std::abs(state.w - row.w.hi) <= dw);
    CHECK(std::abs(state.F - row.F.hi) <= dF);
    const double jacobian = row.w_S.hi * row.F_q.hi - row.w_q.hi * row.F_S.hi;
    CHECK(std::abs(state.S - row.S) <=
          (std::abs(row.F_q.hi) * dw + std::abs(row.w_q.hi) * dF) / jacobian + unit * row.S);
    CHECK(std::abs(state.q - row.q) <=
          (std::abs(row.w_S.hi) * dF + std::abs(row.F_S.hi) * dw) / jacobian + unit * std::abs(row.q));
  }
}

TEST_CASE("elastica: the end of the branch (table)") {
  for (const auto& row : end_rows) {
    const auto end = fibre_branch_end(row.q);
    // S grows as the inverse of the distance to the q at which 2E = K, which is the condition number of both.
    const double condition = 1 + std::abs(row.q / (row.q - 0.86043668612567827));
    CAPTURE(row.q);
    CHECK(error_of(end.u, row.u) <= 2);
    CHECK(error_of(end.S, row.S) <= 16 * condition);
    CHECK(error_of(end.w, row.w) <= 16 * condition);
    const double S = end.S * (1 - unit);  // the end itself, rounded, may lie beyond
    const auto [state, slopes] = fibre_state_slopes(S, row.q);
    REQUIRE(state.status == FibreStatus::ok);
    // F = 0 and the values of the end, to the error of S and the bounds of the state.
    const double error_of_S = unit * (1 + error_of(end.S, row.S));
    CHECK(state.F <= (error_of_S + 8e-15) * (S * std::abs(slopes.F_S) + std::abs(row.q * slopes.F_q)));
    const double relative = 2 * error_of_S * S / (S - 1);  // all are powers of S - 1 or of S, the square at most
    CHECK(error_of(state.theta0, row.theta0) * unit <= 4e-15 + relative);
    CHECK(error_of(state.Pn, row.Pn) * unit <= 3e-15 + relative);
    CHECK(error_of(state.U, row.U) * unit <= 8e-15 + relative);
    CHECK(fibre_state(end.S * (1 + 1e-12 * condition), row.q).status == FibreStatus::beyond_branch);
  }
}

TEST_CASE("elastica: above q = 0.8604 the branch does not end but at the pole of S (table)") {
  for (const auto& row : pole_rows) {
    const auto end = fibre_branch_end(row.q);
    CHECK(std::isinf(end.S));
    CHECK(std::isinf(end.w));
    CHECK(end.u > row.u.hi);
    const auto state = fibre_state(1e6, row.q);
    REQUIRE(state.status == FibreStatus::ok);
    CHECK(state.F >= 0);
    CHECK(state.u < row.u.hi);
    CHECK(state.u == within(1e-5, row.u.hi));  // u nears the pole as 1/S
  }
}

TEST_CASE("elastica: the deformed shape (table)") {
  for (const auto& row : shape_rows) {
    const auto state = fibre_state(row.S, row.q);
    const auto point = fibre_shape(state, row.fraction);
    CAPTURE(row.S);
    CAPTURE(row.q);
    CAPTURE(row.fraction);
    CHECK(std::abs((point.x - row.x.hi) - row.x.lo) <= 8 * unit * row.S);
    CHECK(std::abs((point.y - row.y.hi) - row.y.lo) <= 8 * unit * state.w);
    CHECK(std::abs((point.theta - row.theta.hi) - row.theta.lo) <= 8 * unit * state.theta0);
  }
}

TEST_CASE("elastica: the straight fibre (limit)") {
  const auto straight = fibre_state(1, 0.6);
  CHECK(straight.status == FibreStatus::ok);
  CHECK(straight.w == 0);
  CHECK(straight.F == 0);
  CHECK(straight.U == 0);
  CHECK(std::isnan(fibre_state_slopes(1, 0.6).slopes.w_S));
  CHECK(fibre_shape(straight, 0.25).x == 0.25);
  CHECK(fibre_state_from_force(0, 0).S == 1);
  CHECK(fibre_state_from_force(0, 0).q == 0);
}

TEST_CASE("elastica: F tends to 48 w, S - 1 to 2.4 w^2, U to 24 w^2 (limit)") {
  for (const double q : {-2.0, 0.0, 0.6, 3.0})
    for (const double excess : {1e-12, 1e-10, 1e-8}) {
      const double S = 1 + excess;
      const auto state = fibre_state(S, q);
      const double next_term = 8 * (1 + std::abs(q)) * state.w;  // the first correction is of order q w
      CHECK(state.F == within(next_term, 48 * state.w));
      CHECK(S - 1 == within(next_term, 2.4 * state.w * state.w));
      CHECK(state.U == within(next_term, 24 * state.w * state.w));
      CHECK(state.theta0 == within(next_term, 3 * state.w));
    }
}

TEST_CASE("elastica: the frictionless force peaks at 6.67180843438173 (paper)") {
  const auto state = peak(0);
  CHECK(state.F == within(1e-14, 6.67180843438173));  // 15 digits given
  CHECK(state.w == within(1e-8, 0.238188798912727));  // where F is flat, to the square root of its rounding ...
  const double F_S = fibre_state_slopes(1.13015070107338803193, 0).slopes.F_S;
  CHECK(std::abs(F_S) <= 1e-13);  // ... but F_S vanishes where the 40-digit root is
}

TEST_CASE("elastica: the force peaks at 8.06, 9.50, 11.39 for q = 0.3, 0.6, 1.0 (paper)") {
  CHECK(peak(0.3).F == within(1e-14, 8.06278536754364));
  CHECK(peak(0.6).F == within(1e-14, 9.5034301067268));
  CHECK(peak(1.0).F == within(1e-14, 11.3901825511289));
  CHECK(peak(0.6).w == within(1e-12, 0.298200076224235));
}

TEST_CASE("elastica: without friction F vanishes at Gauss's constant, w = 0.834626841674073 (paper)") {
  const auto end = fibre_branch_end(0);
  CHECK(end.w == within(8 * unit, 0.834626841674073186281429732799));
  // S has 16 ulp and F, falling there as (S - 1) F_S, the error promised of it.
  const double fall = std::abs(fibre_state_slopes(end.S * (1 - 16 * unit), 0).slopes.F_S);
  CHECK(fibre_state(end.S, 0).F <= (16 * unit * end.S + 8e-15 * (end.S - 1)) * fall);
}

TEST_CASE("elastica: F exceeds 48 w by 1.2, 4.6 and 11 % for q = 0.3, 0.6 and 1.0 (paper)") {
  const auto excess = [](double q) {
    double most = 0;
    for (int i = 1; i < 1000; ++i) {
      const auto state = fibre_state(1 + 0.2 * i / 1000, q);
      most = std::max(most, state.F / (48 * state.w) - 1);
    }
    return 100 * most;
  };
  CHECK(std::abs(excess(0.3) - 1.2) < 0.05);  // the digits given
  CHECK(std::abs(excess(0.6) - 4.6) < 0.05);
  CHECK(std::abs(excess(1.0) - 11) < 0.5);
  CHECK(excess(0.0) <= 0);  // without friction Euler and Bernoulli do give an upper bound
}

TEST_CASE("elastica: dU = F dw - q Pn dS in both directions (identity)") {
  CHECK(rc::check("q in [-20, 20], S along the branch", [] {
    const auto [S, q] = somewhere(-20, 20, 30);
    const auto [state, slopes] = fibre_state_slopes(S, q);
    RC_ASSERT(state.status == FibreStatus::ok);
    // Each slope is good to 1e-14 of its size in the header's sense, and there are three.
    const double S_size = (state.U + state.F * state.w + std::abs(q) * state.Pn * (S - 1)) / (S - 1) +
                          std::abs(state.F * slopes.w_S) + std::abs(q * state.Pn);
    RC_ASSERT(std::abs(slopes.U_S - (state.F * slopes.w_S - q * state.Pn)) <= 3e-14 * S_size);
    const double q_size = (state.U + state.F * state.w) / (1 + std::abs(q)) + std::abs(slopes.U_q);
    RC_ASSERT(std::abs(slopes.U_q - state.F * slopes.w_q) <= 3e-14 * q_size);
  }));
}

TEST_CASE("elastica: Maxwell's relation, the Jacobian of (w, F) is d(q Pn)/dq (identity)") {
  CHECK(rc::check("q in [-20, 20], S along the branch", [] {
    const auto [S, q] = somewhere(-20, 20, 30);
    const auto [state, slopes] = fibre_state_slopes(S, q);
    const double jacobian = slopes.w_S * slopes.F_q - slopes.w_q * slopes.F_S;
    const double size = std::abs(slopes.w_S * slopes.F_q) + std::abs(slopes.w_q * slopes.F_S) + state.Pn +
                        std::abs(q * slopes.Pn_q) +
                        state.w / (S - 1) * std::max(std::abs(slopes.F_q), state.F / (1 + std::abs(q)));
    RC_ASSERT(std::abs(jacobian - (state.Pn + q * slopes.Pn_q)) <= 4e-14 * size);  // four slopes at 1e-14
  }));
}

TEST_CASE("elastica: slopes agree with the state (oracle: central differences)") {
  CHECK(rc::check("q in [-19.9, 19.9], S along the branch", [] {
    const auto [S, q] = somewhere(-19.9, 19.9, 5);
    const auto slopes = fibre_state_slopes(S, q).slopes;
    const double hS = 1e-5 * std::min(S - 1, fibre_branch_end(q).S - S), hq = 1e-5 * (1 + std::abs(q));
    RC_PRE(S < fibre_branch_end(q - hq).S);
    RC_PRE(hS > 16 * unit);  // the difference of neighbouring numbers is none
    const auto left = fibre_state(S - hS, q), right = fibre_state(S + hS, q);
    const auto down = fibre_state(S, q - hq), up = fibre_state(S, q + hq);
    const auto agrees = [](double slope, double low, double high, double span) {
      // Truncation 1e-10, times what the third derivatives are; rounding of the values, of F times a condition below 1e3.
      return std::abs(slope - (high - low) / span) <=
             1e-8 * std::abs(slope) + 1e-12 * (std::abs(low) + std::abs(high)) / span;
    };
    const double span = (S + hS) - (S - hS);
    RC_ASSERT(agrees(slopes.w_S, left.w, right.w, span));
    RC_ASSERT(agrees(slopes.F_S, left.F, right.F, span));
    RC_ASSERT(agrees(slopes.Pn_S, left.Pn, right.Pn, span));
    RC_ASSERT(agrees(slopes.U_S, left.U, right.U, span));
    RC_ASSERT(agrees(slopes.w_q, down.w, up.w, 2 * hq));
    RC_ASSERT(agrees(slopes.F_q, down.F, up.F, 2 * hq));
    RC_ASSERT(agrees(slopes.Pn_q, down.Pn, up.Pn, 2 * hq));
    RC_ASSERT(agrees(slopes.U_q, down.U, up.U, 2 * hq));
  }));
}

TEST_CASE("elastica: the map can be inverted, its Jacobian is positive (identity)") {
  CHECK(rc::check("q in [-1, 2], S in (1, 1.6]", [] {
    const auto [S, q] = somewhere(-1, 2, 1.6);
    const auto slopes = fibre_state_slopes(S, q).slopes;
    RC_ASSERT(slopes.w_S * slopes.F_q - slopes.w_q * slopes.F_S > 0);
    RC_ASSERT(slopes.w_S > 0);
  }));
}

TEST_CASE("elastica: the inverse undoes the map (identity)") {
  CHECK(rc::check("q in [-19, 19], S along the branch", [] {
    const auto [S, q] = somewhere(-19, 19, 30);
    const auto [state, slopes] = fibre_state_slopes(S, q);
    const auto back = fibre_state_from_force(state.w, state.F);
    RC_ASSERT(back.status == FibreStatus::ok);
    const double condition = 1 + std::abs((S - 1) * slopes.F_S / state.F) + std::abs(q * slopes.F_q / state.F);
    const double dw = 48 * unit * S * state.w, dF = 48 * unit * S * state.F * condition;  // 32 promised, 16 in the map
    RC_ASSERT(std::abs(back.w - state.w) <= dw);
    RC_ASSERT(std::abs(back.F - state.F) <= dF);
    const double jacobian = slopes.w_S * slopes.F_q - slopes.w_q * slopes.F_S;
    RC_ASSERT(std::abs(back.q - q) <=
              (std::abs(slopes.w_S) * dF + std::abs(slopes.F_S) * dw) / jacobian + unit * std::abs(q));
  }));
}

TEST_CASE("elastica: the phase, the deflection and the support's slope rise with S (identity)") {
  CHECK(rc::check("two lengths at one q", [] {
    const double q = *between(-20, 20);
    const double last = std::min(fibre_branch_end(q).S, 30.0) - 1;
    const double a = *between(1e-3, 0.999), b = *between(1e-3, 0.999);
    RC_PRE(std::abs(a - b) > 1e-9);
    const auto shorter = fibre_state(1 + last * std::pow(std::min(a, b), 4), q);
    const auto longer = fibre_state(1 + last * std::pow(std::max(a, b), 4), q);
    RC_ASSERT(shorter.u < longer.u);
    RC_ASSERT(shorter.w < longer.w);
    RC_ASSERT(shorter.theta0 < longer.theta0);
  }));
}

TEST_CASE("elastica: ends, middle, symmetry and arc length of the shape (identity)") {
  CHECK(rc::check("q in [-20, 20], S along the branch", [] {
    const auto at = somewhere(-20, 20, 10);
    const double S = at.S;
    const auto state = fibre_state(S, at.q);
    const auto left = fibre_shape(state, 0), middle = fibre_shape(state, 0.5), right = fibre_shape(state, 1);
    RC_ASSERT(left.x == 0 && left.y == 0 && left.theta == state.theta0);
    RC_ASSERT(right.x == 1 && right.y == 0 && right.theta == -state.theta0);
    RC_ASSERT(std::abs(middle.x - 0.5) <= 20 * unit * S);
    RC_ASSERT(std::abs(middle.y - state.w) <= 16 * unit * state.w);
    RC_ASSERT(middle.theta == 0);
    const double s = *between(0, 0.5);
    RC_ASSERT(std::abs(fibre_shape(state, s).y - fibre_shape(state, 1 - s).y) <= 16 * unit * state.w);

    // A polygon of n chords is short by c/n^2 + d/n^4; two of them give the arc length to d/n^4.
    const auto polygon = [&](int n) {
      double length = 0;
      auto before = left;
      for (int i = 1; i <= n; ++i) {
        const auto point = fibre_shape(state, 0.5 * i / n);
        length += std::hypot(point.x - before.x, point.y - before.y);
        before = point;
      }
      return 2 * length;
    };
    const double arc = (4 * polygon(256) - polygon(128)) / 3;
    RC_ASSERT(std::abs(arc - S) <= 1e-7 * S);
    // The slope agrees with the curve: x' = S cos θ.
    const double x = simpson([&](double t) { return S * std::cos(fibre_shape(state, t).theta); }, 0, s, 128);
    RC_ASSERT(std::abs(x - fibre_shape(state, s).x) <= 1e-7 * S);
  }));
}

TEST_CASE("elastica: the state solves the boundary value problem (4.7) (oracle: Runge-Kutta shooting)") {
  for (const auto& at :
       {Somewhere{1.001, 0.3}, {1.05, -0.8}, {1.1, 0}, {1.2, 0.6}, {1.5, 1.0}, {1.6, 2.0}, {2.0, 0.1}, {4.0, 1.2}}) {
    const double S = at.S, q = at.q;
    const auto state = fibre_state(S, q);
    // Newton's iteration with differences, from a start that is 2 % off, for no slope and half the span at midspan.
    double theta0 = 1.02 * state.theta0, Pn = 0.98 * state.Pn;
    for (int i = 0; i < 12; ++i) {
      const auto shot = shoot(S, q, theta0, Pn);
      const double h = 1e-6;
      const auto in_theta = shoot(S, q, theta0 + h, Pn), in_P = shoot(S, q, theta0, Pn + h);
      const double a = (in_theta.theta - shot.theta) / h, b = (in_P.theta - shot.theta) / h;
      const double c = (in_theta.x - shot.x) / h, d = (in_P.x - shot.x) / h;
      const double f = shot.theta, g = shot.x - 0.5;
      theta0 -= (d * f - b * g) / (a * d - b * c);
      Pn -= (a * g - c * f) / (a * d - b * c);
    }
    CAPTURE(S);
    CAPTURE(q);
    const double h4 =
        1e-10 / (S - 1);  // the error of the integration, through the condition of a nearly straight fibre
    CHECK(theta0 == within(h4, state.theta0));
    CHECK(Pn == within(h4, state.Pn));
    CHECK(shoot(S, q, theta0, Pn).y == within(h4, state.w));
  }
}

TEST_CASE("elastica: the state equals a literal Algorithm 1 (oracle: quadrature of (4.18), (4.23), (4.27))") {
  for (const double q : {-0.9, 0.0, 0.3, 0.6, 1.0, 2.0})
    for (const double S : {1.01, 1.1, 1.3, 1.6}) {
      const auto state = fibre_state(S, q);
      if (state.status != FibreStatus::ok) continue;
      const auto literal = LiteralFibre(S, q).state();
      CAPTURE(S);
      CAPTURE(q);
      CHECK(state.Pn == within(1e-10, literal.Pn));  // quadrature to 1e-15, times the condition of S - 1 and of F
      CHECK(state.w == within(1e-10, literal.w));
      CHECK(state.F == within(1e-10, literal.F));
    }
}

TEST_CASE("elastica: an input outside the domain is refused with its value (contract)") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto names = [](const std::string& value, const std::function<void()>& call) {
    const auto message = message_of(call);
    INFO("message: ", message);
    CHECK(message.find(value) != std::string::npos);
  };
  names("0.99", [] { fibre_state(0.99, 0); });
  names("nan", [] { fibre_state(nan, 0); });
  names("inf", [] { fibre_state(inf, 0); });
  names("nan", [] { fibre_state(1.1, nan); });
  names("20.5", [] { fibre_state(1.1, 20.5); });
  names("-20.5", [] { fibre_state(1.1, -20.5); });
  names("0.99", [] { fibre_state_slopes(0.99, 0); });
  names("20.5", [] { fibre_branch_end(20.5); });
  names("nan", [] { fibre_branch_end(nan); });
  names("-0.1", [] { fibre_state_from_force(-0.1, 1); });
  names("nan", [] { fibre_state_from_force(0.1, nan); });
  names("-1.5", [] { fibre_state_from_force(0.1, -1.5); });
  names("inf", [] { fibre_state_from_force(inf, 1); });
  names("1.5", [] { fibre_shape(fibre_state(1.1, 0), 1.5); });
  names("nan", [] { fibre_shape(fibre_state(1.1, 0), nan); });
  names("does not exist", [] { fibre_shape(fibre_state(3, 0), 0.5); });
}

TEST_CASE("elastica: what does not exist is a status (limit)") {
  const auto beyond = fibre_state(2.2, 0);  // the branch ends at 2.18844
  CHECK(beyond.status == FibreStatus::beyond_branch);
  CHECK(beyond.S == 2.2);
  CHECK(beyond.q == 0);
  CHECK(std::isnan(beyond.F));
  CHECK(fibre_state_slopes(2.2, 0).state.status == FibreStatus::beyond_branch);

  const auto too_strong = fibre_state_from_force(0.1, 48 * 0.1 * 10);  // ten times Euler and Bernoulli's
  CHECK(too_strong.status == FibreStatus::no_friction);
  CHECK(too_strong.w == 0.1);
  CHECK(too_strong.F == 48 * 0.1 * 10);
  CHECK(std::isnan(too_strong.q));
  CHECK(fibre_state_from_force(0.0, 1.0).status == FibreStatus::no_friction);
  CHECK(fibre_state_from_force(0.01, 0.1).status == FibreStatus::no_friction);  // at q = -20 it is 0.22 or more
}

TEST_CASE("curvature, identity: at midspan it is the moment of the reactions at the supports") {
  CHECK(rc::check([] {
    const double S = 1 + std::pow(10, *between(-6, 0)), q = *between(-1, 2);
    const FibreState state = fibre_state(S, q);
    if (state.status != FibreStatus::ok) return;
    const double thrust = state.Pn * (std::sin(state.theta0) - q * std::cos(state.theta0));
    const double moment = 0.25 * state.F + state.w * thrust;
    const double size = 0.25 * state.F + state.w * std::abs(thrust);  // what cancels
    RC_ASSERT(std::abs(curvature_at_midspan(state) - moment) <= 1e-12 * size);
  }));
}

TEST_CASE("curvature, oracle: it is the slope of the slope of the shape, by differences about midspan") {
  for (const double q : {-0.3, 0.0, 0.6, 3.0}) {
    const FibreState state = fibre_state(1.15, q);
    const auto slope = [&](double ds) {
      return (fibre_shape(state, 0.5 - ds).theta - fibre_shape(state, 0.5 + ds).theta) / (2 * ds * state.S);
    };
    // The force makes a corner of κ there: the error of a difference is proportional to ds, the error of two to its square.
    CHECK(curvature_at_midspan(state) == doctest::Approx(2 * slope(5e-5) - slope(1e-4)).epsilon(1e-6));
  }
}

TEST_CASE("curvature, limit: 12 w at small deflection") {
  const FibreState state = fibre_state(1 + 1e-9, 0.4);
  CHECK(curvature_at_midspan(state) == doctest::Approx(12 * state.w).epsilon(1e-4));
  CHECK(curvature_at_midspan(fibre_state(1, 0.4)) == 0);
}

}  // namespace flexslip
