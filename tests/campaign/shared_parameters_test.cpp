#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "campaign/campaign.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

constexpr double modulus = 30e9;  // [Pa]

// A test whose record says of EI, and so of E, that it is `off` times the modulus, to 2 %; told E to 5 %.
CampaignTest some_test(double moment, double off) {
  CampaignTest test{};
  test.summary = TestSummary{};
  test.section_moment = moment;
  const double own = 1 / (0.02 * 0.02), told = 1 / (0.05 * 0.05);
  const double nominal = std::log(modulus * moment);
  test.summary->known.log_stiffness = {
      {{1, nominal + std::log(off) * own / (own + told), 1 / std::sqrt(own + told)}}, nominal, 0.05};
  return test;
}

TEST_CASE(
    "limit: a modulus shared by sections of any size is the weighted mean of its logarithm, what was stated counted "
    "once") {
  std::vector<CampaignTest> tests{some_test(1e-19, 1.02), some_test(3e-19, 1.05), some_test(2e-20, 1.03)};
  const double own = 1 / (0.02 * 0.02), told = 1 / (0.05 * 0.05);
  const double weight = 3 * own + told, log = own * (std::log(1.02) + std::log(1.05) + std::log(1.03)) / weight;
  const auto shared = share_parameters(tests, {Shareable::modulus});
  REQUIRE(shared.size() == 1);
  CHECK(shared[0].name == "modulus");
  CHECK(shared[0].unit == "Pa");
  CHECK(shared[0].tests == 3);
  CHECK(std::abs(std::log(shared[0].estimate.value / modulus) - log) < 1e-3 / std::sqrt(weight));  // as share promises
  CHECK(shared[0].agreement > 0.5);
  // Suspects, tests without a section and those without an answer have no part.
  tests.push_back(some_test(1e-19, 2));
  tests.back().summary->suspect = true;
  tests.push_back(some_test(1e-19, 2));
  tests.back().section_moment = std::nullopt;
  tests.emplace_back();
  CHECK(share_parameters(tests, {Shareable::modulus})[0].estimate.value == shared[0].estimate.value);
  // The stiffnesses themselves differ by factors, and are said to.
  CHECK(share_parameters(std::span(tests).first(3), {Shareable::bending_stiffness})[0].agreement < 1e-10);
}

TEST_CASE("limit: what no two records tell has no value; what is asked for twice is refused") {
  const std::vector<CampaignTest> tests{some_test(1e-19, 1), some_test(1e-19, 1.01)};
  const auto shared = share_parameters(tests, {Shareable::wavelength});
  CHECK(std::isnan(shared[0].estimate.value));
  CHECK(shared[0].tests == 0);
  CHECK(message_of([&] {
          share_parameters(tests, {Shareable::modulus, Shareable::modulus});
        }).find("once is enough") != std::string::npos);
}

}  // namespace
}  // namespace flexslip
