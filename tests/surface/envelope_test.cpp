#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "surface/slope_friction.h"
#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/uniform.h"

namespace flexslip {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// As they are defined, n² of them.
std::vector<double> dilated(const std::vector<double>& z, double step, double r) {
  std::vector<double> out(z.size(), -infinite);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j < z.size(); ++j) {
      const double x = step * (static_cast<double>(i) - static_cast<double>(j));
      if (std::abs(x) <= r * (1 + 1e-12)) out[i] = std::max(out[i], z[j] + std::sqrt(std::max(r * r - x * x, 0.0)) - r);
    }
  return out;
}

std::vector<double> closed(const std::vector<double>& z, double step, double r) {
  const std::vector<double> path = dilated(z, step, r);
  std::vector<double> out(z.size(), infinite);
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j < z.size(); ++j) {
      const double x = step * (static_cast<double>(i) - static_cast<double>(j));
      if (std::abs(x) <= r * (1 + 1e-12))
        out[i] = std::min(out[i], path[j] - std::sqrt(std::max(r * r - x * x, 0.0)) + r);
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

TEST_CASE("envelope: path and closing as they are defined (oracle: every pair)") {
  for (const double height : {0.01, 0.3, 5.0})
    for (const double r : {0.05, 0.1, 0.35, 1.0, 7.0, 500.0}) {
      const auto z = rough(301, height);
      const auto path = path_of_edge(z, 0.1, r), over = envelope(z, 0.1, r);
      const auto path_there = dilated(z, 0.1, r), over_there = closed(z, 0.1, r);
      for (std::size_t i = 0; i < z.size(); ++i) {
        // the oracle's √(r² - x²) - r loses rounding of r² over its root, which at the rim of the circle is √(rounding) r
        CHECK(std::abs(path[i] - path_there[i]) < 1e-7 * r);
        CHECK(std::abs(over[i] - over_there[i]) < 1e-7 * r);
      }
    }
}

TEST_CASE("envelope: no sample lies above it, and a second rolling changes nothing (identity)") {
  const auto z = rough(400, 0.2);
  for (const double r : {0.2, 1.0, 5.0}) {
    const auto over = envelope(z, 0.1, r), again = envelope(over, 0.1, r);
    for (std::size_t i = 0; i < z.size(); ++i) {
      CHECK(over[i] >= z[i] - 1e-12);
      CHECK(std::abs(again[i] - over[i]) < 1e-12);
    }
  }
}

TEST_CASE(
    "envelope: a point sees all, a valley narrower than the edge is bridged, a slope and a wide valley stay (limit)") {
  const auto z = rough(50, 1);
  CHECK(path_of_edge(z, 0.1, 0) == z);
  CHECK(envelope(z, 0.1, 0) == z);
  std::vector<double> slope(100), valley(101, 0.0);
  for (std::size_t i = 0; i < 100; ++i) slope[i] = 0.02 * static_cast<double>(i);
  const auto over = envelope(slope, 0.1, 1);
  for (std::size_t i = 20; i < 80; ++i)
    CHECK(std::abs(over[i] - slope[i]) < 1e-4);  // sampled: x²/2r between two, x a step at most
  valley[50] = -3;
  // The circle of radius 5 sinks by 5 - √(25 - 0.01) between samples at ±0.1.
  CHECK(envelope(valley, 0.1, 5)[50] == doctest::Approx(-(5 - std::sqrt(25 - 0.01))).epsilon(1e-9));
  for (std::size_t i = 0; i < 101; ++i)
    valley[i] = 0.001 * std::pow(static_cast<double>(i) - 50, 2) * 0.01;  // radius of curvature 500
  const auto wide = envelope(valley, 0.1, 5);
  for (std::size_t i = 10; i < 90; ++i) CHECK(std::abs(wide[i] - valley[i]) < 1e-4);
}

TEST_CASE("envelope: radii that are none are refused (limit)") {
  CHECK(has(message_of([] { path_of_edge(std::vector{0.0, 1.0}, 0.1, -1); }), "radius"));
  CHECK(has(message_of([] { path_of_edge(std::vector{0.0, 1.0}, 0, 1); }), "distance of 0"));
}

}  // namespace flexslip
