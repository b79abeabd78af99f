#include "inference/population.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <boost/math/distributions/students_t.hpp>
#include <doctest/doctest.h>

#include "tests/refusal.h"

namespace flexslip {
namespace {

TEST_CASE("table: trials of the vaccine BCG, as metafor has them") {
  struct Trial {
    double ill, vaccinated, ill_without, without;
  };
  // Colditz et al., J. Am. Med. Assoc. 271 (1994).
  constexpr std::array trials{Trial{4, 123, 11, 139},       Trial{6, 306, 29, 303},        Trial{3, 231, 11, 220},
                              Trial{62, 13598, 248, 12867}, Trial{33, 5069, 47, 5808},     Trial{180, 1541, 372, 1451},
                              Trial{8, 2545, 10, 629},      Trial{505, 88391, 499, 88391}, Trial{29, 7499, 45, 7277},
                              Trial{17, 1716, 65, 1665},    Trial{186, 50634, 141, 27338}, Trial{5, 2498, 3, 2341},
                              Trial{27, 16913, 29, 17854}};
  std::vector<Measured> measured;
  for (const auto& [ill, vaccinated, ill_without, without] : trials)
    measured.push_back({std::log(ill / vaccinated / (ill_without / without)),
                        std::sqrt(1 / ill - 1 / vaccinated + 1 / ill_without - 1 / without)});
  const Population found = population_of(measured);
  constexpr double rounding = 0.5e-4;  // of four decimals
  CHECK(found.tests == 13);
  CHECK(std::abs(found.typical.value + 0.7145) < rounding);
  CHECK(std::abs(found.spread * found.spread - 0.3132) < rounding);
  // 0.1798 from the weights alone; Hartung and Knapp's factor is 1.0055.
  CHECK(found.typical.standard_error == doctest::Approx(0.1798 * 1.0055).epsilon(1e-3));
}

// Twice the log density of the differences of the others from the last estimate, but for a constant: what the restricted likelihood is.
double of_contrasts(const std::vector<Measured>& tests, double spread) {
  const auto n = static_cast<Eigen::Index>(tests.size()) - 1;
  const auto variance = [&](Eigen::Index i) {
    const double error = tests[static_cast<std::size_t>(i)].standard_error;
    return error * error + spread * spread;
  };
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(n, n, variance(n));
  Eigen::VectorXd contrasts(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    covariance(i, i) += variance(i);
    contrasts[i] = tests[static_cast<std::size_t>(i)].value - tests.back().value;
  }
  const Eigen::LDLT<Eigen::MatrixXd> factors(covariance);
  return -factors.vectorD().array().log().sum() - contrasts.dot(factors.solve(contrasts));
}

TEST_CASE("oracle: the spread and its interval by the likelihood of contrasts on a fine grid") {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Measured> tests;
    const double spread = 0.3 * (trial % 3);
    for (int t = 0; t < 3 + trial % 8; ++t) {
      const double error = 0.3 * std::exp(1.5 * normal(random));
      tests.push_back({spread * normal(random) + error * normal(random), error});
    }
    const Population found = population_of(tests);
    CAPTURE(trial);
    constexpr double step = 5e-3;
    const double highest = of_contrasts(tests, found.spread);
    for (double each = 0; each < 6; each += step) {
      const double lacks = highest - of_contrasts(tests, each);
      CHECK(lacks > -1e-9);  // rounding of a dozen sums
      if (each > found.min_spread + step && each < found.max_spread - step) CHECK(lacks < 2 * 1.92);
      if (each < found.min_spread - step || each > found.max_spread + step) CHECK(lacks > 2 * 1.92);
    }
  }
}

TEST_CASE("identity: with equal errors mean and spread are those of the sample, less the errors") {
  const std::vector<double> values{0.42, 0.61, 0.35, 0.77, 0.52, 0.48, 0.66, 0.58};
  const auto n = static_cast<double>(values.size());
  double mean = 0, variance = 0;
  for (const double value : values) mean += value / n;
  for (const double value : values) variance += (value - mean) * (value - mean) / (n - 1);
  const auto population = [&](double error) {
    std::vector<Measured> tests;
    for (const double value : values) tests.push_back({value, error});
    return population_of(tests);
  };
  for (const double error : {1e-6, 0.05, 0.1}) {
    const Population found = population(error);
    CHECK(std::abs(found.spread - std::sqrt(variance - error * error)) < 1e-6 * 0.42);  // as promised
    CHECK(found.typical.value == doctest::Approx(mean).epsilon(1e-12));
    CHECK(found.typical.standard_error == doctest::Approx(std::sqrt(variance / n)).epsilon(1e-5));
    const double reach = quantile(boost::math::students_t(n - 1), 0.975) * found.typical.standard_error;
    CHECK(found.typical.high - found.typical.value == doctest::Approx(reach).epsilon(0.01));  // as student_quantile
  }
  // Estimates that agree by chance do not make the mean surer than their errors.
  const Population alike = population(0.4);
  CHECK(alike.spread == 0);
  CHECK(alike.min_spread == 0);
  CHECK(alike.max_spread > 0.1);
  CHECK(alike.typical.standard_error == doctest::Approx(0.4 / std::sqrt(n)).epsilon(1e-12));
}

TEST_CASE("oracle: intervals of 95 % cover mean and spread of simulated campaigns") {
  struct Setting {
    int tests;
    double spread, error;
  };
  std::mt19937_64 random(2021);
  std::normal_distribution<double> normal;
  constexpr int campaigns = 400;
  for (const auto& [tests, spread, error] :
       {Setting{3, 0.1, 0.1}, {3, 0.15, 0.05}, {4, 0, 0.1}, {6, 0.15, 0.08}, {12, 0.03, 0.1}, {26, 0.1, 0.1}}) {
    int mean_covered = 0, spread_covered = 0;
    for (int campaign = 0; campaign < campaigns; ++campaign) {
      std::vector<Measured> measured;
      for (int t = 0; t < tests; ++t) {
        const double own = error * (0.5 + 0.5 * (t % 4));
        measured.push_back({0.5 + spread * normal(random) + own * normal(random), own});
      }
      const Population found = population_of(measured);
      mean_covered += found.typical.low <= 0.5 && 0.5 <= found.typical.high;
      spread_covered += found.min_spread <= spread && spread <= found.max_spread;
    }
    CAPTURE(tests);
    CAPTURE(spread);
    CHECK(mean_covered >= 0.92 * campaigns);
    CHECK(spread_covered >= 0.92 * campaigns);
  }
}

TEST_CASE("identity: what a record measured comes back from posterior and prior, unless it is mostly the prior") {
  const auto marginal = [](double value, double error, double prior_mean, double prior_deviation) {
    const double own = 1 / (error * error), prior = 1 / (prior_deviation * prior_deviation);
    const double mean = (value * own + prior_mean * prior) / (own + prior);
    return Marginal{{{1, mean, 1 / std::sqrt(own + prior)}}, prior_mean, prior_deviation};
  };
  const auto measured = measured_by_record(marginal(0.3, 0.49, 0.55, 0.5));
  REQUIRE(measured);
  CHECK(measured->value == doctest::Approx(0.3).epsilon(1e-12));
  CHECK(measured->standard_error == doctest::Approx(0.49).epsilon(1e-12));
  CHECK(!measured_by_record(marginal(0.3, 0.51, 0.55, 0.5)));
  CHECK(!measured_by_record({{}, 0.55, 0.5}));             // the fit has no such parameter
  CHECK(!measured_by_record({{{1, 0.3, 0}}, 0.55, 0.5}));  // it was not sought
}

TEST_CASE("table: two tests are no population") {
  const std::vector<Measured> two(2, {0.5, 0.1});
  CHECK(message_of([&] { population_of(two); }) == "a population of 2 tests");
}

}  // namespace
}  // namespace flexslip
