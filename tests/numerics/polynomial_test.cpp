#include "numerics/polynomial.h"

#include <cmath>

#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE("polynomial, limit: a zero is found also where Newton's steps lead away from it") {
  const auto flat = [](double x) {
    return ValueAndSlope{std::cbrt(x - 0.3), 1 / (3 * std::pow(std::cbrt(x - 0.3), 2))};
  };
  // Newton's steps are twice as long as they should be: all that is left is halving, 60 times at most.
  CHECK(std::abs(zero_between(flat, -1, 1, 0.9, true, 1e-15) - 0.3) < 1e-11);
  const auto falling = [](double x) { return ValueAndSlope{-std::atan(20 * x), -20 / (1 + 400 * x * x)}; };
  CHECK(std::abs(zero_between(falling, -1, 0.9, 0.8, false, 1e-15)) < 1e-14);
}

}  // namespace flexslip
