#include "numerics/interpolant.h"

#include <cmath>

#include <doctest/doctest.h>

#include "numerics/polynomial.h"
#include "tests/approximately.h"

namespace flexslip {
namespace {

using Polynomial = Interpolant<6>;

// A polynomial of degree 6 with its derivative and its integral from -1.
double value(double x) { return 3 + x * (-2 + x * x * (1 + x * (0.5 + x * x * 4))); }
double slope(double x) { return -2 + x * x * (3 + x * (2 + x * x * 24)); }
double integral(double x) {
  const auto primitive = [](double t) { return t * (3 + t * (-1 + t * t * (0.25 + t * (0.1 + t * t * 4 / 7)))); };
  return primitive(x) - primitive(-1);
}

Polynomial::Values at_nodes() {
  Polynomial::Values values{};
  for (std::size_t j = 0; j < values.size(); ++j) values[j] = value(Polynomial::node(j));
  return values;
}

}  // namespace

TEST_CASE("interpolant, identity: a polynomial of its degree is exact, with derivative and integral") {
  const auto series = Polynomial::chebyshev(at_nodes());
  const auto bernstein = Polynomial::bernstein(at_nodes());
  const auto primitive = integrated(series, 1);
  for (double x = -1; x <= 1; x += 0.125) {
    CAPTURE(x);
    CHECK(series_at(series, x) == to(1e-14, value(x)));
    CHECK(series_slope_at(series, x).value == to(1e-14, value(x)));
    CHECK(series_slope_at(series, x).slope == to(1e-13, slope(x)));
    CHECK(bernstein_at(bernstein, 0.5 * (1 + x)).value == to(1e-13, value(x)));
    CHECK(bernstein_at(bernstein, 0.5 * (1 + x)).slope == to(1e-12, 2 * slope(x)));  // in t, half as long
    CHECK(std::abs(series_at(primitive, x) - integral(x)) < 1e-14);
  }
}

TEST_CASE("series, identity: derivative and product agree with the polynomials, up to the truncation") {
  const auto series = Polynomial::chebyshev(at_nodes());
  const auto rate = derivative(series);
  const auto whole = product<12>(series, rate);
  const auto work = integrated(whole, 1);  // ∫ f f' = f²/2
  const auto cut = product<8>(series, rate);
  for (double x = -1; x <= 1; x += 0.125) {
    CAPTURE(x);
    CHECK(series_at(rate, x) == to(1e-13, slope(x)));
    CHECK(std::abs(series_at(whole, x) - value(x) * slope(x)) < 2e-12);  // of a product of up to 300
    CHECK(std::abs(series_at(work, x) - 0.5 * (value(x) * value(x) - value(-1) * value(-1))) < 2e-12);
  }
  for (std::size_t k = 0; k < cut.size(); ++k) CHECK(cut[k] == whole[k]);
}

TEST_CASE("cubic, identity: values and slopes at its ends, and a cubic is exact") {
  const auto f = [](double t) { return ValueAndSlope{2 + t * (-1 + t * (3 - 5 * t)), -1 + t * (6 - 15 * t)}; };
  const Cubic cubic(f(0).value, f(1).value, f(0).slope, f(1).slope);
  for (double t = 0; t <= 1; t += 0.125) {
    CHECK(std::abs(cubic.at(t).value - f(t).value) < 1e-14);  // of terms of up to 10
    CHECK(std::abs(cubic.at(t).slope - f(t).slope) < 4e-14);
  }
}

TEST_CASE("interpolant, identity: Bernstein coefficients of x are evenly spaced, and their hull holds the polynomial") {
  Polynomial::Values x{};
  for (std::size_t j = 0; j < x.size(); ++j) x[j] = Polynomial::node(j);
  const auto line = Polynomial::bernstein(x);
  for (std::size_t i = 0; i < line.size(); ++i) CHECK(std::abs(line[i] - (static_cast<double>(i) / 3 - 1)) < 1e-14);
  CHECK(sign_changes(line) == 1);

  const auto bernstein = Polynomial::bernstein(at_nodes());
  const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());
  for (double t = -1; t <= 1; t += 0.01) {
    CHECK(value(t) >= *least - 1e-12);
    CHECK(value(t) <= *greatest + 1e-12);
  }
}

}  // namespace flexslip
