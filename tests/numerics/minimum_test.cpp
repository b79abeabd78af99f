#include "numerics/minimum.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE("table: the maximum of a smooth function, in few calls") {
  int calls = 0;
  const auto [at, value] = greatest_within([&](double x) { return ++calls, x * std::exp(-x); }, 0, 5, 1e-9);
  CHECK(std::abs(at - 1) < 5e-8);  // the root of a double's rounding, of a peak of width 1
  CHECK(std::abs(value - 1 / std::numbers::e) < 2e-16);
  CHECK(calls < 30);
}

TEST_CASE("limit: a kink, and a function with its maximum at an end") {
  const auto kink = greatest_within([](double x) { return -std::abs(x - std::numbers::sqrt2); }, -3, 7, 1e-10);
  CHECK(std::abs(kink.at - std::numbers::sqrt2) <= 2e-10);
  for (const double side : {-1.0, 1.0}) {
    const auto at_end = greatest_within(
        [&](double x) {
          CHECK(0 <= x);
          CHECK(x <= 1);
          return side * x;
        },
        0, 1, 1e-6);
    CHECK(std::abs(at_end.at - (side > 0 ? 1 : 0)) <= 2e-6);
  }
}

namespace {

double valley(double x, double y) { return std::pow(1 - x, 2) + 100 * std::pow(y - x * x, 2); }  // Rosenbrock's

}  // namespace

TEST_CASE("table: the minimum of Rosenbrock's valley without slopes, from the better of two starts") {
  int calls = 0;
  const FunctionOfNumbers f = [&](std::span<const double> x) { return ++calls, valley(x[0], x[1]); };
  const std::vector<std::vector<double>> starts{{-1.2, 1}, {0.5, 0.5}};
  const LeastOptions options{.steps = {0.2, 0.2}, .close_in_value = 1e-14, .close_in_numbers = 1e-9, .max_calls = 2000};
  const Least least = least_from(f, starts, options);
  CHECK(least.value < 1e-12);
  CHECK(std::abs(least.at[0] - 1) < 1e-5);
  CHECK(std::abs(least.at[1] - 1) < 1e-5);
  calls = 0;
  least_from(f, starts, {.steps = {0.2, 0.2}, .close_in_value = 0, .close_in_numbers = 0, .max_calls = 30});
  CHECK(calls <= 2 * 30);
}

TEST_CASE("limit: for an undefined function the result is a start") {
  const FunctionOfNumbers f = [](std::span<const double> x) {
    return x[0] < 0 ? std::numeric_limits<double>::infinity() : x[0] * x[0];
  };
  const std::vector<std::vector<double>> starts{{-1.0}, {1.0}};
  CHECK(least_from(f, starts, {{0.1}, 1e-9, 1e-9, 200}).value < 1e-6);
  const FunctionOfNumbers none_below = [](std::span<const double> x) { return x[0] < 0 ? std::nan("") : x[0] * x[0]; };
  CHECK(least_from(none_below, starts, {{0.1}, 1e-9, 1e-9, 200}).value < 1e-6);
}

namespace {

struct Hill {
  double value;
  Eigen::Vector2d gradient;
};

Hill hill(const Eigen::Vector2d& x) {  // the valley upside down
  const double across = x[1] - x[0] * x[0];
  return {-valley(x[0], x[1]), {2 * (1 - x[0]) + 400 * x[0] * across, -200 * across}};
}

}  // namespace

TEST_CASE("table: uphill to the top of a hill, or to where the box ends") {
  const Eigen::Vector2d start(-1.2, 1);
  const auto rough = [] { return Eigen::Matrix2d(0.01 * Eigen::Matrix2d::Identity()); };
  Eigen::Matrix2d learned = rough();
  const Box<Eigen::Vector2d> wide{{-2, -2}, {2, 2}, {0.5, 0.5}};
  const auto top = maximised_in_box(hill, start, wide, learned, 200, 1e-16);
  CHECK((top - Eigen::Vector2d(1, 1)).norm() < 1e-6);
  Eigen::Matrix2d curvature;
  curvature << 802, -400, -400, 200;
  CHECK((learned * curvature - Eigen::Matrix2d::Identity()).norm() < 0.1);
  const auto bowl = [](const Eigen::Vector2d& x) {  // greatest at (1, 2), upside down
    return Hill{-std::pow(x[0] - 1, 2) - 3 * std::pow(x[1] - 2, 2), Eigen::Vector2d(2 - 2 * x[0], 12 - 6 * x[1])};
  };
  const Box<Eigen::Vector2d> narrow{{-2, -2}, {0.5, 5}, {0.5, 0.5}};
  learned = rough();
  const auto wall = maximised_in_box(bowl, start, narrow, learned, 200, 1e-16);
  CHECK(wall[0] == 0.5);
  CHECK(std::abs(wall[1] - 2) < 1e-6);
  // Not where a step gains little because it was short.
  const auto flat = [](const Eigen::Vector2d& x) { return Hill{-0.1 * x.squaredNorm(), -0.2 * x}; };
  learned = rough();
  const auto near = maximised_in_box(flat, Eigen::Vector2d(1.5, 0), wide, learned, 8, 0.003);
  CHECK(-flat(near).value < 0.003);
}

TEST_CASE("limit: no step exceeds the longest, and a start outside the box moves to its wall") {
  const Box<Eigen::Vector2d> box{{0, 0}, {10, 10}, {0.25, 0.125}};
  const auto steep = [](const Eigen::Vector2d& x) { return Hill{100 * x[0] + 100 * x[1], Eigen::Vector2d(100, 100)}; };
  Eigen::Matrix2d rough = Eigen::Matrix2d::Identity();
  const auto once = maximised_in_box(steep, Eigen::Vector2d(-5, 1), box, rough, 1, 0);
  CHECK(once[0] == 0.125);
  CHECK(once[1] == 1.125);
}

}  // namespace flexslip
