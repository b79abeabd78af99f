#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "inference/population.h"
#include "numerics/elementary.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

// The posterior of a record that says value ± error, told p ± q beforehand.
Marginal told(double value, double error, double p, double q) {
  const double own = 1 / (error * error), prior = std::isinf(q) ? 0 : 1 / (q * q);
  return {{{1, (value * own + p * prior) / (own + prior), 1 / std::sqrt(own + prior)}}, p, q};
}

TEST_CASE("limit: normal records give the mean weighted by their errors, what was told counted once") {
  const std::vector<double> values{29, 31, 30}, errors{1, 2, 2};
  for (const std::size_t copies : std::vector<std::size_t>{1, 4, 30}) {
    std::vector<Marginal> tests;
    double weight = 1 / (3.0 * 3.0), sum = weight * 28;
    for (std::size_t copy = 0; copy < copies; ++copy)
      for (std::size_t t = 0; t < values.size(); ++t) {
        tests.push_back(told(values[t], errors[t], 28, 3));
        weight += 1 / (errors[t] * errors[t]);
        sum += values[t] / (errors[t] * errors[t]);
      }
    const auto prior = prior_told_to(tests);
    CHECK(prior.mean == 28);
    CHECK(prior.deviation == 3);
    const auto shared = share(tests, prior);
    const double error = 1 / std::sqrt(weight);
    CHECK(std::abs(shared.estimate.value - sum / weight) < 1e-3 * error);  // as promised
    CHECK(std::abs(shared.estimate.standard_error / error - 1) < 1e-3);
    CHECK(std::abs(shared.estimate.low - (sum / weight - 1.959964 * error)) < 1e-3 * error);
    CHECK(std::abs(shared.estimate.high - (sum / weight + 1.959964 * error)) < 1e-3 * error);
    CHECK(shared.telling == tests.size());
    // About their own mean, which the prior has no part in.
    double squares = 0;
    for (std::size_t t = 0; t < values.size(); ++t)
      squares += static_cast<double>(copies) * std::pow((values[t] - (29 + 31 / 4.0 + 30 / 4.0) / 1.5) / errors[t], 2);
    CHECK(shared.chi_squared == doctest::Approx(squares).epsilon(1e-9));  // ln of products, of order 100
  }
}

TEST_CASE("limit: two records that contradict each other are said to; two that agree are not") {
  const std::vector<Marginal> apart{told(10, 1, 0, 20), told(16, 1, 0, 20)};  // chi² = 18
  const auto shared = share(apart, {0, infinity});
  CHECK(shared.chi_squared == doctest::Approx(18).epsilon(1e-9));
  CHECK(shared.agreement == doctest::Approx(std::erfc(3.0)).epsilon(1e-9));  // 2e-5
  CHECK(std::abs(shared.estimate.value - 13) < 1e-3 * shared.estimate.standard_error);
  const std::vector<Marginal> alike{told(10, 1, 0, 20), told(11, 1, 0, 20)};
  CHECK(share(alike, {0, infinity}).agreement > 0.4);
  // Of a mixture the mode that the other test confirms counts.
  const std::vector<Marginal> either{{{{0.9, 10, 0.1}, {0.1, 20, 0.1}}, 0, infinity}, told(20.1, 0.1, 0, infinity)};
  const auto confirmed = share(either, {0, infinity});
  CHECK(std::abs(confirmed.estimate.value - 20.05) < 1e-3);
  CHECK(confirmed.agreement < 0.05);  // the other mode, nine times likelier, is given up: 2 ln 9
  CHECK(confirmed.agreement > 0.01);
}

TEST_CASE("identity: a record that says nothing changes nothing, and has no say in the agreement") {
  const std::vector<Marginal> two{told(10, 1, 12, 4), told(13, 1, 12, 4)};
  auto three = two;
  three.push_back({{{1, 12, 4}}, 12, 4});
  const auto without = share(two, {12, 4}), with = share(three, {12, 4});
  CHECK(with.telling == 2);
  CHECK(with.estimate.value == doctest::Approx(without.estimate.value).epsilon(1e-12));
  CHECK(with.estimate.high == doctest::Approx(without.estimate.high).epsilon(1e-12));
  CHECK(with.agreement == doctest::Approx(without.agreement).epsilon(1e-12));
}

TEST_CASE("oracle: mixtures against their product summed over many places") {
  std::mt19937_64 random(11);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int trial = 0; trial < 8; ++trial) {
    std::vector<Marginal> tests;
    for (int t = 0; t < 5; ++t) {
      Marginal test{{}, 0.55, 0.5};
      for (int c = 0; c < 4; ++c)
        test.posterior.push_back({0.05 + uniform(), 0.3 + 0.4 * uniform(), 0.02 + 0.2 * uniform()});
      tests.push_back(test);
    }
    const auto shared = share(tests, {0.55, 0.5});
    constexpr int places = 100000;
    double total = 0, below = 0, low = 0, high = 0, sum = 0, squares = 0;
    for (int i = 0; i <= places; ++i) {
      const double x = -1 + 3.0 * i / places;
      const auto density = [&](double mean, double deviation) {
        return std::exp(-0.5 * std::pow((x - mean) / deviation, 2)) / deviation;
      };
      double product = density(0.55, 0.5);
      for (const auto& test : tests) {
        double posterior = 0;
        for (const auto& part : test.posterior) posterior += part.weight * density(part.mean, part.deviation);
        product *= posterior / density(0.55, 0.5);
      }
      total += product;
      sum += product * x;
      squares += product * x * x;
      if (x < shared.estimate.value) below += product;
      if (x < shared.estimate.low) low += product;
      if (x < shared.estimate.high) high += product;
    }
    CHECK(std::abs(below / total - 0.5) <
          1.4e-3);  // 1e-3 of the standard error times the density there, and what one place holds
    CHECK(std::abs(low / total - 0.025) < 1e-4);
    CHECK(std::abs(high / total - 0.975) < 1e-4);
    const double deviation = std::sqrt(squares / total - std::pow(sum / total, 2));
    CHECK(std::abs(shared.estimate.standard_error / deviation - 1) < 1e-3);
  }
}

TEST_CASE("oracle: one value shared is covered by its interval, and tests that share it agree, as often as stated") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  int covered = 0, disagree = 0;
  constexpr int campaigns = 1000;
  for (int campaign = 0; campaign < campaigns; ++campaign) {
    const double truth = 0.55 + 0.3 * normal(random);
    std::vector<Marginal> tests;
    for (int t = 0; t < 6; ++t) {
      const double error = 0.05 * (1 + t % 3);
      tests.push_back(told(truth + error * normal(random), error, 0.55, 0.5));
    }
    const auto shared = share(tests, {0.55, 0.5});
    covered += shared.estimate.low < truth && truth < shared.estimate.high;
    disagree += shared.agreement < 0.05;
  }
  CHECK(covered >= 930);  // 950 expected, deviation 7
  CHECK(covered <= 970);
  CHECK(disagree >= 30);  // 50 expected
  CHECK(disagree <= 70);
}

TEST_CASE(
    "limit: wavelengths of six tests, of which nothing was known beforehand, share their weighted mean in the "
    "logarithm") {
  std::vector<Marginal> tests;
  double weight = 0, sum = 0;
  for (int t = 0; t < 6; ++t) {
    const double log = std::log(20e-6) + 0.002 * (t % 3 - 1), error = 0.002 * (1 + t);
    tests.push_back(
        of_logarithm({std::exp(log), 0, std::exp(log - 1.959964 * error), std::exp(log + 1.959964 * error)}));
    weight += 1 / (error * error);
    sum += log / (error * error);
  }
  const auto shared = share(tests, prior_told_to(tests));
  CHECK(shared.telling == 6);
  CHECK(std::abs(shared.estimate.value - sum / weight) < 1e-3 / std::sqrt(weight));  // as promised
  CHECK(std::abs(shared.estimate.standard_error * std::sqrt(weight) - 1) < 1e-3);
  CHECK(message_of([] { of_logarithm({1, 0.1, 0, 2}); }).find("no logarithm of 1.0") == 0);
}

TEST_CASE("identity: a number plus a constant has its likelihood moved by it") {
  const auto here = told(1, 0.2, 0.5, 0.7), there = shifted(here, 3);
  CHECK(
      log_of(likelihood_of(there), 4.1) - log_of(likelihood_of(there), 4.6) ==
      doctest::Approx(log_of(likelihood_of(here), 1.1) - log_of(likelihood_of(here), 1.6)).epsilon(1e-13));  // some ulp
}

}  // namespace
}  // namespace flexslip
