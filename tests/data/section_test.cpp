#include "data/section.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <doctest/doctest.h>

#include "tests/approximately.h"

using namespace flexslip;

TEST_CASE("section: second moments against mpmath (table)") {
  struct Row {
    Section section;
    double moment;  // [m^4]
  };
  const Row rows[] = {
      {RoundSection{34.8e-6}, 7.19924369134060091e-20},
      {RectangularSection{10e-3, 4e-3}, 5.33333333333333378e-11},
      {TubularSection{34.8e-6, 30e-6}, 3.22316548914101844e-20},
      {TubularSection{10e-3, 9.9e-3}, 1.93423883603320229e-11},
      {TubularSection{1e-3, 0.999999e-3}, 1.96349246349626922e-19},
      {TubularSection{25e-3, 12e-3}, 1.81568838288074265e-8},
  };
  // 4 ulp, as the header promises.
  for (const Row& row : rows)
    CHECK(second_moment(row.section) == to(4 * std::numeric_limits<double>::epsilon(), row.moment));
}

TEST_CASE("section: the share of shear against Cowper's coefficients for a Poisson's ratio of 0.3 (table)") {
  const double L = 1, h = 0.1;
  // 24 (1 + ν) I/(κ A L²), κ as printed in his table: 0.886 (round), 0.850 (rectangle), 0.531 (thin round tube).
  CHECK(shear_share(RoundSection{h}, L) == doctest::Approx(31.2 * h * h / 16 / 0.886).epsilon(1e-3));
  CHECK(shear_share(RectangularSection{0.3, h}, L) == doctest::Approx(31.2 * h * h / 12 / 0.850).epsilon(1e-3));
  CHECK(shear_share(TubularSection{h, 0.99999 * h}, L) == doctest::Approx(31.2 * h * h / 8 / 0.531).epsilon(1e-3));
  CHECK(shear_share(TubularSection{h, 1e-9 * h}, L) == doctest::Approx(shear_share(RoundSection{h}, L)));
}

TEST_CASE("section: a tube is its outer circle less its inner one (identity)") {
  const double D = 3.1e-3, d = 1.9e-3;
  const double difference = second_moment(RoundSection{D}) - second_moment(RoundSection{d});
  // The difference of two moments of like size loses a digit.
  CHECK(second_moment(TubularSection{D, d}) == to(1e-14, difference));
}

TEST_CASE("section: the second moment of a tube against the integral of y^2 over it (oracle)") {
  const int n = 20000;
  const double D = 2, d = 1.2;
  const auto chord = [](double diameter, double y) {
    const double half = 0.5 * diameter;
    return std::abs(y) < half ? 2 * std::sqrt(half * half - y * y) : 0;
  };
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double y = D * ((i + 0.5) / n - 0.5);
    sum += y * y * (chord(D, y) - chord(d, y)) * D / n;
  }
  CHECK(second_moment(TubularSection{D, d}) == to(1e-5, sum));  // the midpoint rule errs by about n^-1.5 of a circle
}

TEST_CASE("section: the depth is the extent in the direction of bending (table)") {
  CHECK(depth(RoundSection{2}) == 2);
  CHECK(depth(TubularSection{2, 1}) == 2);
  CHECK(depth(RectangularSection{3, 0.5}) == 0.5);
}

TEST_CASE("section: a tube is thin from a wall of a twentieth of its diameter down (table)") {
  CHECK(is_thin_tube(TubularSection{10, 9.1}));
  CHECK_FALSE(is_thin_tube(TubularSection{10, 8.9}));
  CHECK_FALSE(is_thin_tube(RoundSection{10}));
}

TEST_CASE("section: a section without a wall or without size is refused (contract)") {
  CHECK_THROWS_AS(second_moment(TubularSection{1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(second_moment(TubularSection{1, 1.1}), std::invalid_argument);
  CHECK_THROWS_AS(second_moment(TubularSection{1, 0}), std::invalid_argument);
  CHECK_THROWS_AS(second_moment(RoundSection{-1}), std::invalid_argument);
}
