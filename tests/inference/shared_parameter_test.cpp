#include "inference/shared_parameter.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "tests/refusal.h"

namespace flexslip {
namespace {

doctest::Approx to_rounding(double value) { return doctest::Approx(value).scale(0).epsilon(1e-14); }  // some ulp

TEST_CASE("table: three tests give their weighted mean; a scatter within their errors changes nothing") {
  const std::vector<OwnEstimate> tests{{29.0, 1.0}, {31.0, 2.0}, {30.0, 2.0}};  // weights 1, 1/4, 1/4
  const auto shared = estimate_shared(tests, std::nullopt);
  CHECK(shared.estimate.value == to_rounding((29.0 + 31.0 / 4 + 30.0 / 4) / 1.5));
  CHECK(shared.estimate.standard_error == to_rounding(1 / std::sqrt(1.5)));
  CHECK(shared.estimate.high - shared.estimate.low == to_rounding(2 * 1.95996 / std::sqrt(1.5)));
  CHECK(shared.scatter < 1);
}

TEST_CASE("table: tests that contradict each other widen the error by their scatter") {
  const std::vector<OwnEstimate> tests{{10.0, 1.0}, {16.0, 1.0}};  // chi^2 = 18 with one freedom
  const auto shared = estimate_shared(tests, std::nullopt);
  CHECK(shared.estimate.value == 13.0);
  CHECK(shared.scatter == to_rounding(std::sqrt(18.0)));
  CHECK(shared.estimate.standard_error == to_rounding(std::sqrt(18.0) / std::sqrt(2.0)));
}

TEST_CASE("identity: what was stated beforehand counts once, however many tests were told it") {
  const OwnEstimate stated{30, 1};
  // Tests whose records say 33 ± 2, told 30 ± 1: posteriors of weight 1 + 1/4.
  const double weight = 1 + 0.25;
  const OwnEstimate told{(30 + 33 * 0.25) / weight, 1 / std::sqrt(weight)};
  const auto own = of_the_record(told, stated);
  REQUIRE(own);
  CHECK(own->value == doctest::Approx(33).scale(0).epsilon(1e-13));  // cancellation of two weights
  CHECK(own->error == doctest::Approx(2).scale(0).epsilon(1e-13));
  for (const std::size_t n : std::vector<std::size_t>{1, 4, 100}) {
    const std::vector<OwnEstimate> tests(n, *own);
    const auto shared = estimate_shared(tests, stated);
    const double expected = (30 + 33 * 0.25 * static_cast<double>(n)) / (1 + 0.25 * static_cast<double>(n));
    CHECK(shared.estimate.value == doctest::Approx(expected).scale(0).epsilon(1e-12));
  }
}

TEST_CASE("limit: a record that adds nothing to what was stated has no estimate of its own") {
  CHECK(!of_the_record({30.1, 0.999}, {30, 1}));
  CHECK(!of_the_record({30.1, 1.2}, {30, 1}));
  const auto shared = estimate_shared({}, OwnEstimate{30, 1});
  CHECK(shared.estimate.value == 30.0);
  CHECK(shared.estimate.standard_error == 1.0);
}

TEST_CASE("table: bad estimates are refused") {
  const std::vector<OwnEstimate> one{{1, 1}};
  CHECK(message_of([&] { estimate_shared(one, std::nullopt); }) == "a shared value needs two tests");
  const std::vector<OwnEstimate> exact{{1, 1}, {2, 0}};
  CHECK(message_of([&] { estimate_shared(exact, std::nullopt); }).find("2.000000 ± 0.000000") != std::string::npos);
}

}  // namespace
}  // namespace flexslip
