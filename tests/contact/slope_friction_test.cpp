#include "contact/slope_friction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/uniform.h"
#include "tests/unit.h"

namespace flexslip {

TEST_CASE("slope friction: on the way there and on the way back (table: tan(atan μ ± α) at 40 digits)") {
  struct Row {
    double mu, slope, there, back;
  };
  for (const auto& [mu, slope, there, back] : {Row{0.5, 0.1, 0.63157894736842105263, 0.38095238095238095238},
                                               Row{0.584, -0.0623, 0.50338523434189207235, 0.67070229576736312609},
                                               Row{1.2, 0.3, 2.34375, 0.66176470588235294118}}) {
    CHECK(friction_on_slope(mu, slope) == doctest::Approx(there).epsilon(1e-12));
    CHECK(friction_on_the_way_back(there, mu) == doctest::Approx(back).epsilon(1e-12));
    CHECK(slope_of_friction(there, mu) == doctest::Approx(slope).epsilon(1e-11));
  }
}

TEST_CASE("slope friction: slope and friction are each other's inverse (identity)") {
  Uniform uniform;
  for (int i = 0; i < 10000; ++i) {
    const double mu = uniform(0.01, 2), slope = uniform(-0.9, 0.9) * std::min(mu, 1 / mu);
    const double apparent = friction_on_slope(mu, slope);
    CHECK(std::abs(slope_of_friction(apparent, mu) - slope) < 64 * unit * (1 + std::abs(apparent)));
  }
}

TEST_CASE("slope friction: small slopes, A = slope amplitude (1 + μ²)/μ to first order (limit)") {
  for (const double mu : {0.1, 0.584, 1.3})
    for (const double slope : {1e-3, 1e-4, 1e-5}) {
      // one wave of the surface, in 1000 places
      double first = 0;
      for (int i = 0; i < 1000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 1000;
        first += 2e-3 * friction_on_slope(mu, slope * std::cos(angle)) * std::cos(angle);
      }
      const double amplitude = first / mu;
      const double expected = slope * (1 + mu * mu) / mu;
      // of third order: the next term of the amplitude is (3/4) μ² slope²
      CHECK(std::abs(amplitude / expected - 1) < mu * mu * slope * slope + 1000 * unit);  // and rounding of the sum
    }
}

TEST_CASE(
    "slope friction: a wave 0.11 µm high every 10.9 µm shows the paper's means (paper: closing remark 2, Table 1)") {
  const double step = 0.01, slope = 2 * std::numbers::pi * 0.1095 / 10.9;
  std::vector<double> path;
  for (int i = 0; i <= 1090; ++i) path.push_back(0.1095 * std::cos(2 * std::numbers::pi * step * i / 10.9));
  const std::vector<double> shown = friction_of_heights(path, step, 0.584);
  const auto [least, greatest] = std::minmax_element(shown.begin(), shown.end());
  CHECK(*greatest == doctest::Approx(friction_on_slope(0.584, slope)).epsilon(1e-4));  // between heights a 1090th apart
  CHECK(0.5 * (*greatest - *least) / 0.584 ==
        doctest::Approx(0.145).epsilon(2e-3));  // to first order in slopes of 0.06
}

TEST_CASE("slope friction: slopes too steep are named, in each direction (limit)") {
  const std::vector<double> falls{0, 0, -0.06, 0}, climbs{0, 0.3, 0, 0};
  const auto down = too_steep(falls, 0.1, 0.5, 20);
  REQUIRE(down);
  CHECK(down->interval == 1);
  CHECK(down->slope == doctest::Approx(-0.6));
  CHECK_FALSE(too_steep(std::vector{0.0, 0.06, 0.06}, 0.1, 0.5, 20));
  CHECK(too_steep(climbs, 0.1, 0.5, 20)->interval == 1);  // which falls by 3 beyond 0.5, the steeper of both faults
  CHECK(too_steep(std::vector{0.0, 0.3}, 0.1, 0.5, 20)->slope == doctest::Approx(3));
  CHECK(too_steep(std::vector{0.0, -0.5}, 1, 0.5, 20));  // friction of exactly 0
  CHECK(has(message_of([] { friction_on_slope(0.5, 2); }), "holds whatever pulls"));
  CHECK(has(message_of([&] { friction_of_heights(falls, 0.1, 0.5); }), "slides by itself"));
}

}  // namespace flexslip
