#include "inference/shared_parameter.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "tests/refusal.h"

namespace flexslip {
namespace {

// Tests that each measure the parameter as `value` ± `error`, normally.
struct Measured {
  double value, error;
};

JointLikelihood joint(const std::vector<Measured>& tests) {
  return [tests](std::span<const double> values) {
    std::vector<double> sums;
    for (const double value : values) {
      double sum = 0;
      for (const auto& test : tests) sum -= 0.5 * std::pow((value - test.value) / test.error, 2);
      sums.push_back(sum);
    }
    return sums;
  };
}

TEST_CASE("oracle: normal measurements give their weighted mean and its interval") {
  const std::vector<Measured> tests{{29.0, 1.0}, {31.0, 2.0}, {27.0, 1.5}};
  double weights = 0;
  double weighted = 0;
  for (const auto& test : tests) {
    weights += 1 / (test.error * test.error);
    weighted += test.value / (test.error * test.error);
  }
  const double mean = weighted / weights;
  const double error = 1 / std::sqrt(weights);
  const auto shared = estimate_shared({10, 60, 15}, joint(tests));
  CHECK(shared.status == SharedStatus::ok);
  const double tolerance = 1e-3 * 2 * 1.96 * error;  // as the header says
  CHECK(std::abs(shared.estimate.value - mean) < tolerance);
  CHECK(std::abs(shared.estimate.low - (mean - 1.95996 * error)) < tolerance);
  CHECK(std::abs(shared.estimate.high - (mean + 1.95996 * error)) < tolerance);
  CHECK(std::abs(shared.estimate.standard_error - error) < tolerance);
}

TEST_CASE("oracle: of two maxima the greater is found, and an interval that holds both is given whole") {
  const auto two = [](double depth) {
    return [depth](std::span<const double> values) {
      std::vector<double> sums;
      for (const double x : values)
        sums.push_back(std::log(std::exp(-0.5 * std::pow((x - 2) / 0.1, 2)) +
                                std::exp(-depth - 0.5 * std::pow((x - 3) / 0.1, 2)) + 1e-300));
      return sums;
    };
  };
  const auto clear = estimate_shared({1, 5, 40}, two(10));
  CHECK(std::abs(clear.estimate.value - 2) < 1e-3);
  CHECK(clear.estimate.high < 2.3);
  const auto open = estimate_shared({1, 5, 40}, two(1));
  CHECK(open.estimate.low == doctest::Approx(2 - 0.196).epsilon(1e-3));
  // Where exp(-1 - x^2/2) has fallen to exp(-1.9207): at sqrt(2 * 0.9207) deviations from 3.
  CHECK(open.estimate.high == doctest::Approx(3 + 0.1 * std::sqrt(2 * 0.9207)).epsilon(1e-3));
}

TEST_CASE("limit: a likelihood that rises to the end of the range is said to be cut there") {
  const auto shared = estimate_shared({10, 20, 9}, joint({{30, 5}}));
  CHECK(shared.status == SharedStatus::at_bound);
  CHECK(shared.estimate.value == 20);
  CHECK(shared.estimate.high == 20);
}

TEST_CASE("limit: impossible values are passed over, a range of nothing else is refused") {
  const auto from_15 = [](std::span<const double> values) {
    auto sums = joint({{16, 1}})(values);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] < 15) sums[i] = -std::numeric_limits<double>::infinity();
    return sums;
  };
  const auto shared = estimate_shared({10, 20, 21}, from_15);
  CHECK(std::abs(shared.estimate.value - 16) < 4e-3);  // 1e-3 of the interval
  CHECK(std::abs(shared.estimate.low - 15) < 4e-3);
  const auto nothing = [](std::span<const double> values) {
    return std::vector<double>(values.size(), -std::numeric_limits<double>::infinity());
  };
  CHECK(message_of([&] { estimate_shared({10, 20, 9}, nothing); }) == "no value in the range is possible");
  CHECK(message_of([&] { estimate_shared({20, 10, 9}, joint({{16, 1}})); }).find("20.0") != std::string::npos);
}

}  // namespace
}  // namespace flexslip
