#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "contact/slope_friction.h"
#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/uniform.h"

namespace flexslip {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// By definition, n² of them.
std::vector<double> dilated(const std::vector<double>& z, double step, double r) {
  std::vector<double> out(z.size(), -infinite);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j < z.size(); ++j) {
      const double x = step * (static_cast<double>(i) - static_cast<double>(j));
      if (std::abs(x) <= r * (1 + 1e-12)) out[i] = std::max(out[i], z[j] + std::sqrt(std::max(r * r - x * x, 0.0)) - r);
    }
  return out;
}

std::vector<double> rough(std::size_t n, double height) {
  Uniform uniform;
  std::vector<double> z;
  for (std::size_t i = 0; i < n; ++i) z.push_back(uniform(-height, height));
  return z;
}

}  // namespace

TEST_CASE("path of edge: the dilation by its definition (oracle: every pair)") {
  for (const double height : {0.01, 0.3, 5.0})
    for (const double r : {0.05, 0.1, 0.35, 1.0, 7.0, 500.0}) {
      const auto z = rough(301, height);
      const auto path = path_of_edge(z, 0.1, r), there = dilated(z, 0.1, r);
      // The oracle's √(r² - x²) - r loses rounding of r² over its root, which at the rim of the circle is √(rounding) r.
      for (std::size_t i = 0; i < z.size(); ++i) CHECK(std::abs(path[i] - there[i]) < 1e-7 * r);
    }
}

TEST_CASE("path of edge: a point sees all, a valley narrower than the edge is bridged, a slope stays (limit)") {
  const auto z = rough(50, 1);
  CHECK(path_of_edge(z, 0.1, 0) == z);
  std::vector<double> slope(100), valley(101, 0.0);
  for (std::size_t i = 0; i < 100; ++i) slope[i] = 0.02 * static_cast<double>(i);
  const auto over = path_of_edge(slope, 0.1, 1);
  // The circle touches the slope behind its lowest point, √(1 + slope²) - 1 of its radius higher, and between samples by x²/2r less.
  for (std::size_t i = 30; i < 80; ++i) CHECK(over[i] == doctest::Approx(slope[i] + std::sqrt(1.04) - 1).epsilon(2e-3));
  valley[50] = -3;
  // The circle of radius 5 stands on the samples at ±0.1.
  CHECK(path_of_edge(valley, 0.1, 5)[50] == doctest::Approx(-(5 - std::sqrt(25 - 0.01))).epsilon(1e-9));
}

TEST_CASE("path of edge: radii that are none are refused (limit)") {
  CHECK(has(message_of([] { path_of_edge(std::vector{0.0, 1.0}, 0.1, -1); }), "radius"));
  CHECK(has(message_of([] { path_of_edge(std::vector{0.0, 1.0}, 0, 1); }), "distance of 0"));
}

}  // namespace flexslip
