#include "fibre/elliptic.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <doctest/doctest.h>

#include "tests/fibre/accuracy.h"
#include "tests/fibre/ladder.h"
#include "tests/generators.h"

namespace flexslip {
namespace {

struct EllipticRow {
  const char* group;
  double u, m, m1;
  Digits sn, cn, dn, E, V, P, R;
};

const std::vector<EllipticRow>& elliptic_rows() {
  static const std::vector<EllipticRow> rows{
#include "reference/elliptic.inc"
  };
  return rows;
}

// 1 - x, to 32 digits.
Digits complement(const Digits& x) {
  const double hi = 1 - x.hi;
  return {hi, ((1 - hi) - x.hi) - x.lo};
}

// cn vanishes at K: its error is absolute.
double error_of_cn(double cn, const Digits& truth) { return std::abs((cn - truth.hi) - truth.lo) / unit; }

// 1 - 1/S by the closed forms of docs/theory.md, "The state": from sn, cn, dn, E, and from P, R.
template <class T>
T drawn_by_ladder(T u, T m, T m1) {
  using std::asin, std::cos, std::sin, std::sqrt;
  const Ladder<T> jacobi(u, m, m1);
  const T k = sqrt(m), k1 = sqrt(m1), cd = jacobi.cn / jacobi.dn;
  const T b = 2 * asin(k * cd);
  const T C = (2 * jacobi.E - u - 2 * m * jacobi.sn * cd) / (2 * u);
  const T D = 2 * k * k1 * jacobi.sn / jacobi.dn / (2 * u);
  const T S = 1 / (2 * (cos(b) * C + sin(b) * D));
  return (S - 1) / S;
}

double drawn_by_integrals(double u, double m, double m1) {
  const auto arc = elliptic_arc(u, {m, m1});
  const double s0 = 2 * std::sqrt(m * m1);
  const double x = 0.5 * s0 * arc.one_minus_cn / arc.dn;  // sin and cos of θ0/2
  const double y = (m1 + m * arc.cn) / arc.dn;
  const double versine = 2 * x * x;
  return (u * versine + (1 - versine) * 0.5 * s0 * s0 * arc.R - 2 * x * y * s0 * arc.P) / u;
}

}  // namespace

Worsts measured_elliptic() {
  Worsts worsts;
  for (const auto& row : elliptic_rows()) {
    const EllipticParameter parameter{row.m, row.m1};
    const auto arc = elliptic_arc(row.u, parameter);
    if (row.u > complete_elliptic(parameter).K) continue;
    const auto name = row_name("u", row.u, "m", row.m);
    const auto add = [&](const char* quantity, double error) { worsts.add("all", quantity, error, name); };
    add("sn", error_of(arc.sn, row.sn));
    add("cn", error_of_cn(arc.cn, row.cn));
    add("dn", error_of(arc.dn, row.dn));
    add("1 - cn", error_of(arc.one_minus_cn, complement(row.cn)));
    add("P", error_of(arc.P, row.P));
    add("R", error_of(arc.R, row.R));
    add("E(u)", error_of(jacobi_epsilon(row.u, arc, parameter), row.E));
  }
  return worsts;
}

std::vector<LostDigits> digits_of_S() {
  constexpr double m = 0.75, m1 = 0.25;  // q = 0.577
  std::vector<LostDigits> lost;
  for (const double decade : {-1, -2, -4, -6, -8, -10, -12}) {
    LostDigits worst{std::pow(10.0, decade), 0, 0};
    const double u0 = std::pow(15 * worst.excess / (4 * m * m1), 0.25);  // S - 1 = s0^2 u^4/15 + ...
    for (int i = 0; i < 64; ++i) {
      const double u = u0 * (1 + i / 1024.0);
      const Digits truth = digits(drawn_by_ladder<Fifty>(u, m, m1));
      worst.agm = std::max(worst.agm, error_of(drawn_by_ladder<double>(u, m, m1), truth));
      worst.program = std::max(worst.program, error_of(drawn_by_integrals(u, m, m1), truth));
    }
    lost.push_back(worst);
  }
  return lost;
}

TEST_CASE("elliptic: Jacobi's functions and the integrals keep the errors promised in the header (table)") {
  const auto worsts = measured_elliptic();
  const auto check = [&](const char* quantity, double bound) {
    const auto& worst = worsts.of(quantity);
    INFO(quantity, ": ", worst.error, " at ", worst.row);
    CHECK(worst.error <= bound);
  };
  check("sn", 3);
  check("cn", 5);
  check("dn", 10);
  check("1 - cn", 5);
  check("P", 10);
  check("R", 30);
  check("E(u)", 8);
}

TEST_CASE("elliptic: the errors promised hold everywhere up to K (oracle: AGM ladder in 50 digits)") {
  CHECK(rc::check("u in [0, K], m in [6e-4, 1 - 6e-4]", [] {
    const double m = 0x1p-30 * *whole(644'246, (1 << 30) - 644'246);  // [6e-4, 1 - 6e-4]
    const double m1 = 1 - m;                                          // exact
    const EllipticParameter parameter{m, m1};
    const double u = complete_elliptic(parameter).K * *between(0, 1) * *rc::gen::element(1.0, 0x1p-3, 0x1p-6);
    RC_PRE(u > 0);
    const Ladder<Fifty> truth(u, m, m1);
    for (const auto& arc : {elliptic_arc(u, parameter), nearby_arc(u, parameter)}) {
      RC_ASSERT(error_of(arc.sn, digits(truth.sn)) <= 3);
      RC_ASSERT(error_of_cn(arc.cn, digits(truth.cn)) <= 5);
      RC_ASSERT(error_of(arc.dn, digits(truth.dn)) <= 10);
      RC_ASSERT(error_of(arc.one_minus_cn, digits(1 - truth.cn)) <= 6);
      RC_ASSERT(error_of(arc.P, digits(truth.P)) <= 10);
      RC_ASSERT(error_of(arc.R, digits(truth.R)) <= 30);
      RC_ASSERT(error_of(jacobi_epsilon(u, arc, parameter), digits(truth.E)) <= 8);
    }
  }));
}

TEST_CASE("elliptic: the oracle itself agrees with the tables (table)") {
  for (const auto& row : elliptic_rows()) {
    const Ladder<Fifty> ladder(row.u, row.m, row.m1);
    const auto check = [&](const Fifty& value, const Digits& truth) {
      const Fifty difference = value - truth.hi - truth.lo;
      // {hi, lo} holds 2^-106; P and R are in the ladder differences of quantities of order 1.
      CHECK(std::abs(static_cast<double>(difference)) <= 0x1p-100 * std::abs(truth.hi) + 1e-47);
    };
    check(ladder.sn, row.sn);
    check(ladder.dn, row.dn);
    check(ladder.E, row.E);
    check(ladder.V, row.V);
    check(ladder.P, row.P);
    check(ladder.R, row.R);
  }
}

TEST_CASE("elliptic: agrees with Boost.Math (oracle: library)") {
  for (const auto& row : elliptic_rows()) {
    const EllipticParameter parameter{row.m, row.m1};
    if (row.u > 0.9 * complete_elliptic(parameter).K) continue;  // near K Boost 1.74 loses its dn to 0/0
    const auto arc = elliptic_arc(row.u, parameter);
    long double cn = 0, dn = 0;
    const long double k = std::sqrt(static_cast<long double>(row.m));
    const long double sn = boost::math::jacobi_elliptic(k, static_cast<long double>(row.u), &cn, &dn);
    const long double E = boost::math::ellint_2(k, std::asin(sn));
    // Boost's are good to some 2^-60, ours as promised.
    CHECK(std::abs(arc.sn - static_cast<double>(sn)) <= 3 * unit);
    CHECK(std::abs(arc.cn - static_cast<double>(cn)) <= 5 * unit);
    CHECK(std::abs(arc.dn - static_cast<double>(dn)) <= 10 * unit);
    CHECK(std::abs(jacobi_epsilon(row.u, arc, parameter) - static_cast<double>(E)) <= 8 * unit * row.u);
  }
}

TEST_CASE("elliptic: complete integrals keep the errors promised (oracle: Boost.Math in long double)") {
  double worst_K = 0, worst_E = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double m = std::min(i / 2000.0, 1 - 6e-4);
    const auto [K, E] = complete_elliptic({m, 1 - m});
    const long double k = std::sqrt(static_cast<long double>(m));
    worst_K = std::max(worst_K, std::abs(static_cast<double>((K - boost::math::ellint_1(k)) / K)));
    worst_E = std::max(worst_E, std::abs(static_cast<double>((E - boost::math::ellint_2(k)) / E)));
  }
  INFO("K ", worst_K / unit, " E ", worst_E / unit);
  CHECK(worst_K <= 3 * unit);
  CHECK(worst_E <= 8 * unit);
}

TEST_CASE("elliptic: sn^2 + cn^2 = 1, dn^2 = m1 + m cn^2, V = 2 P + (m - m1) R (identity)") {
  for (const auto& row : elliptic_rows()) {
    const auto arc = elliptic_arc(row.u, {row.m, row.m1});
    CHECK(std::abs(arc.sn * arc.sn + arc.cn * arc.cn - 1) <= 8 * unit);
    CHECK(std::abs(arc.dn * arc.dn - (row.m1 + row.m * arc.cn * arc.cn)) <= 8 * unit);
    if (row.u <= complete_elliptic({row.m, row.m1}).K)
      CHECK(error_of(2 * arc.P + (row.m - row.m1) * arc.R, row.V) <=
            40);  // errors of P and R; V is of the size of 2 P + R
  }
}

TEST_CASE("elliptic: circular functions at m = 0, hyperbolic at m = 1, nothing at u = 0 (limit)") {
  for (const double u : {1e-3, 0.1, 0.5, 1.0, 1.5}) {
    const auto circular = elliptic_arc(u, {0, 1});
    CHECK(circular.sn == doctest::Approx(std::sin(u)).epsilon(8 * unit));
    CHECK(circular.dn == 1);
    CHECK(circular.P == doctest::Approx(u - std::sin(u)).epsilon(4 * unit * u / (u - std::sin(u))));
    const auto hyperbolic = elliptic_arc(u, {1, 0});
    CHECK(hyperbolic.sn == doctest::Approx(std::tanh(u)).epsilon(8 * unit));
    CHECK(hyperbolic.cn == doctest::Approx(1 / std::cosh(u)).epsilon(8 * unit));
    CHECK(hyperbolic.dn == doctest::Approx(1 / std::cosh(u)).epsilon(8 * unit));
  }
  const auto nothing = elliptic_arc(0, {0.3, 0.7});
  CHECK(nothing.sn == 0);
  CHECK(nothing.cn == 1);
  CHECK(nothing.P == 0);
  CHECK(nothing.R == 0);
  CHECK(complete_elliptic({0, 1}).K == doctest::Approx(std::numbers::pi / 2).epsilon(2 * unit));
}

TEST_CASE("elliptic: the AGM's S - 1 loses digits as 1/(S - 1), S - 1 from P and R does not (oracle: 50 digits)") {
  for (const auto& lost : digits_of_S()) {
    INFO("S - 1 = ", lost.excess, ": AGM ", lost.agm, " program ", lost.program);
    CHECK(lost.agm * lost.excess > 0.1);  // units of 2^-52: an absolute error of the last digit of S ...
    CHECK(lost.agm * lost.excess < 10);   // ... and only a few
    CHECK(lost.program <= 16);
  }
}

}  // namespace flexslip
