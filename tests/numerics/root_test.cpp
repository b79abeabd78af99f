#include "numerics/root.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "numerics/polynomial.h"
#include "tests/approximately.h"

namespace flexslip {

TEST_CASE("limit: a zero is found also where Newton's steps lead away from it") {
  const auto flat = [](double x) {
    return ValueAndSlope{std::cbrt(x - 0.3), 1 / (3 * std::pow(std::cbrt(x - 0.3), 2))};
  };
  // Newton's steps are twice as long as they should be: all that is left is halving, 60 times at most.
  CHECK(std::abs(zero_between(flat, -1, 1, 0.9, 1e-15) - 0.3) < 1e-11);
  const auto falling = [](double x) { return ValueAndSlope{-std::atan(20 * x), -20 / (1 + 400 * x * x)}; };
  CHECK(std::abs(zero_between(falling, 0.9, -1, 0.8, 1e-15)) < 1e-14);
}

TEST_CASE("table: the error of a zero is the square of the last step") {
  int calls = 0;
  const auto kepler = [&](double E) {  // 0.7 = E - 0.5 sin E at 1.15800162408910636, computed with 40 digits
    ++calls;
    return ValueAndSlope{E - 0.5 * std::sin(E) - 0.7, 1 - 0.5 * std::cos(E)};
  };
  CHECK(std::abs(zero_between(kepler, 0, 3, 1.5, 1e-8) - 1.15800162408910636) < 4e-16);
  CHECK(calls <= 5);
  const auto large = [](double x) { return ValueAndSlope{x * x - 2e12, 2 * x}; };  // a step relative to x
  CHECK(std::abs(zero_between(large, 1, 1e7, 1e7, 0, 1e-9) / (std::sqrt(2.0) * 1e6) - 1) < 4e-16);
}

TEST_CASE("limit: without a change of sign the result lies within the bracket, and an exact zero is returned") {
  const auto positive = [](double x) { return ValueAndSlope{1 + x * x, 2 * x}; };
  const double x = zero_between(positive, -1, 2, 0.5, 1e-12);
  CHECK(-1 <= x);
  CHECK(x <= 2);
  const auto at_end = [](double y) { return ValueAndSlope{y - 2, 1}; };
  CHECK(zero_between(at_end, 0, 2, 2, 1e-12) == 2);
  const auto none = [](double) { return ValueAndSlope{std::numeric_limits<double>::quiet_NaN(), 1}; };
  const double nowhere = zero_between(none, 0, 1, 0.25, 1e-12);
  CHECK(0 <= nowhere);
  CHECK(nowhere <= 1);
}

TEST_CASE("limit: an infinite slope is no zero") {
  const auto upright = [](double x) { return ValueAndSlope{x - 0.3, std::numeric_limits<double>::infinity()}; };
  CHECK(std::abs(zero_between(upright, 0, 1, 0.5, 1e-12) - 0.3) < 1e-11);
}

TEST_CASE("table: a zero without slopes, also next to undefined values") {
  int calls = 0;
  const auto f = [&](double x) { return ++calls, x > 0.8 ? std::numeric_limits<double>::infinity() : std::exp(x) - 2; };
  CHECK(std::abs(zero_by_secant(f, {0, -1}, {1, f(1)}, 1e-15) - 0.693147180559945309) < 1e-15);
  CHECK(calls < 15);
  const auto falling = [](double x) { return 2 - x * x * x; };
  CHECK(std::abs(zero_by_secant(falling, {2, -6}, {0, 2}, 1e-15) - 1.25992104989487316) < 1e-15);
  const auto never = [](double x) { return x > 0.5 ? std::nan("") : -1.0; };
  CHECK(zero_by_secant(never, {0, -1}, {1, never(1)}, 1e-15) == 0.5);
}

TEST_CASE(
    "identity: the first number at which something is true has a neighbour at which it is false, from either side") {
  const auto beyond = [](double x) { return x * x > 2; };
  const double up = first_where(1, 2, beyond);
  CHECK(beyond(up));
  CHECK(!beyond(std::nextafter(up, 1.0)));
  const double down = first_where(2, 1, [&](double x) { return !beyond(x); });
  CHECK(down == std::nextafter(up, 1.0));
}

TEST_CASE("identity: where a function is first not positive, from either side, at a kink and at a jump") {
  int calls = 0;
  const auto smooth = [&](double x) { return ++calls, 2 - x * x; };
  const double up = first_not_positive(smooth, {1, 1}, 2);
  CHECK(calls < 20);
  CHECK(std::abs(up - 1.41421356237309505) < 1e-15);
  CHECK(!(smooth(up) > 0));
  const double down = first_not_positive([](double x) { return std::fmin(x * x - 2, 10 * (x - 1.2)); }, {3, 7}, 0);
  CHECK(std::abs(down - 1.41421356237309505) < 1e-15);
  calls = 0;
  const auto jumps = [&](double x) { return ++calls, x < 0.3 ? 1.0 : -std::numeric_limits<double>::infinity(); };
  CHECK(first_not_positive(jumps, {0, 1}, 1) == 0.3);
  CHECK(calls < 250);
  CHECK(first_not_positive([](double) { return std::nan(""); }, {0, 1}, 1) < 1e-60);
  CHECK(first_not_positive([](double) { return 1.0; }, {0, 1}, 1) == 1);
}

TEST_CASE("limit: if the condition is never true the result is the end, and next to 0 the search ends") {
  int calls = 0;
  CHECK(first_where(0, 1, [&](double) { return ++calls < 0; }) == 1);
  CHECK(calls == 1);
  CHECK(first_where(1, 0, [](double x) { return x == 0; }) == 0);
  CHECK(first_where(0, 1, [](double x) { return x > 0; }) < 1e-60);
}

TEST_CASE("identity: n halvings reduce a bracket by 2^n around the change") {
  const auto beyond = [](double x) { return x > 0.7; };
  const Bracket left = halved(10, {0, 1}, beyond);
  CHECK(left.width() == 0x1p-10);
  CHECK(!beyond(left.low));
  CHECK(beyond(left.high));
  CHECK(left.middle() == 0.5 * (left.low + left.high));
  const Bracket narrow = halved_until([](const Bracket& b) { return b.width() < 0.01; }, {0, 1}, beyond);
  CHECK(narrow.width() == 0x1p-7);
}

}  // namespace flexslip
