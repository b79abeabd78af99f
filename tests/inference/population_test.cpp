#include "inference/population.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <doctest/doctest.h>

#include "tests/refusal.h"

namespace flexslip {
namespace {

// The posterior of a record that says value ± error, told p ± q beforehand.
Marginal told(double value, double error, double p, double q) {
  const double own = 1 / (error * error), prior = 1 / (q * q);
  return {{{1, (value * own + p * prior) / (own + prior), 1 / std::sqrt(own + prior)}}, p, q};
}

struct Moments {
  double mean, squares;
};

TEST_CASE(
    "limit: specimens without error, little known beforehand: Student's t for the mean, chi squared for the spread") {
  const std::vector<double> values{0.42, 0.61, 0.35, 0.77, 0.52, 0.48, 0.66, 0.58};
  const auto n = static_cast<double>(values.size());
  std::vector<Marginal> tests;
  Moments m{0, 0};
  constexpr double wide = 100;
  for (const double value : values) {
    tests.push_back(told(value, 1e-4, 0, wide));
    m.mean += value / n;
  }
  for (const double value : values) m.squares += (value - m.mean) * (value - m.mean);
  const auto population = population_of(tests, {0, wide});
  // T alike likely beforehand: SS/T² is chi squared with n - 2 freedoms, M is Student's with as many.
  const boost::math::chi_squared chi(n - 2);
  const boost::math::students_t student(n - 2);
  const double unit = std::sqrt(m.squares / (n * (n - 2)));
  const auto spread_at = [&](double probability) {
    return std::sqrt(m.squares / quantile(complement(chi, probability)));
  };
  const double error = population.spread.standard_error;
  CHECK(!population.spread_is_bound);
  CHECK(std::abs(population.spread.value - spread_at(0.5)) < 0.01 * error);  // as promised
  CHECK(std::abs(population.spread.low - spread_at(0.025)) < 0.01 * error);
  CHECK(std::abs(population.spread.high - spread_at(0.975)) < 0.01 * error);
  CHECK(std::abs(population.mean.value - m.mean) < 0.01 * unit);
  CHECK(std::abs(population.mean.high - (m.mean + unit * quantile(student, 0.975))) < 0.01 * unit);
  CHECK(std::abs(population.mean.low - (m.mean - unit * quantile(student, 0.975))) < 0.01 * unit);
  for (std::size_t t = 0; t < values.size(); ++t) CHECK(std::abs(population.specimens[t].value - values[t]) < 1e-4);
}

TEST_CASE("limit: where specimens may not differ, the mean is that weighted by the errors") {
  const std::vector<double> values{0.5, 0.6, 0.45}, errors{0.1, 0.2, 0.05};
  constexpr double least = 1e-4;
  std::vector<Marginal> tests;
  double weight = 1 / (least * least), sum = 0.4995 * weight;
  for (std::size_t t = 0; t < values.size(); ++t) {
    tests.push_back(told(values[t], errors[t], 0.55, 0.5));
    weight += 1 / (errors[t] * errors[t]);
    sum += values[t] / (errors[t] * errors[t]);
  }
  const auto population = population_of(tests, {0.4995, least});
  CHECK(population.spread_is_bound);
  CHECK(population.spread.low == 0);
  CHECK(std::abs(population.mean.value - sum / weight) < 0.01 * least);
  for (const auto& specimen : population.specimens)
    CHECK(std::abs(specimen.value - population.mean.value) < 0.02 * least);
}

TEST_CASE(
    "limit: many specimens of equal errors: mean and spread of DerSimonian and Laird, each drawn in by its error") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  constexpr int n = 400;
  constexpr double error = 0.08;
  std::vector<Marginal> tests;
  std::vector<double> values;
  Moments m{0, 0};
  for (int t = 0; t < n; ++t) {
    values.push_back(0.5 + 0.15 * normal(random) + error * normal(random));
    tests.push_back(told(values.back(), error, 0.55, 0.5));
    m.mean += values.back() / n;
  }
  for (const double value : values) m.squares += (value - m.mean) * (value - m.mean);
  const double T = std::sqrt(m.squares / (n - 1) - error * error);
  const auto population = population_of(tests, prior_told_to(tests));
  CHECK(std::abs(population.spread.value - T) < 0.1 * population.spread.standard_error);  // of order 1/sqrt(n) of it
  const double mean_error = std::sqrt(m.squares / (n - 1.0) / n);
  CHECK(std::abs(population.mean.value - m.mean) < 0.02 * mean_error);
  CHECK(population.mean.standard_error == doctest::Approx(mean_error).epsilon(0.01));
  const double share = T * T / (T * T + error * error);
  for (std::size_t t = 0; t < n; ++t) {
    CHECK(std::abs(population.specimens[t].value - (m.mean + share * (values[t] - m.mean))) < 0.02 * error);
    CHECK(population.specimens[t].standard_error ==
          doctest::Approx(std::sqrt(share) * error).epsilon(0.03));  // and what M and T err by
  }
}

// A population by sums over M, T and the specimen's value, from posterior and prior as they are.
struct Slow {
  std::vector<double> means, spreads;
  std::vector<std::vector<double>> weights;  // of a spread, of a mean
  double total = 0;

  double mean_below(double x) const {
    double sum = 0;
    for (const auto& row : weights)
      for (std::size_t i = 0; i < means.size(); ++i) sum += means[i] < x ? row[i] : 0;
    return sum / total;
  }
  double spread_below(double x) const {
    double sum = 0;
    for (std::size_t j = 0; j < spreads.size(); ++j)
      for (const double weight : weights[j]) sum += spreads[j] < x ? weight : 0;
    return sum / total;
  }
};

double normal_density(double x, double mean, double deviation) {
  return std::exp(-0.5 * std::pow((x - mean) / deviation, 2)) / deviation;
}

Slow slow_population(const std::vector<Marginal>& tests, double p, double q) {
  Slow slow;
  constexpr double step = 0.01;  // of values and M: a fifth of the narrowest part
  for (double x = -1.5; x < 2.5; x += step) slow.means.push_back(x);
  std::vector<std::vector<double>> likelihoods;
  for (const auto& test : tests) {
    auto& likelihood = likelihoods.emplace_back();
    for (const double x : slow.means) {
      double posterior = 0;
      for (const auto& part : test.posterior) posterior += part.weight * normal_density(x, part.mean, part.deviation);
      likelihood.push_back(posterior / normal_density(x, test.prior_mean, test.prior_deviation));
    }
  }
  for (double T = 0.0125; T < 1.5; T += 0.0125) {  // T below 0.006 is as 0: the sum over values would not resolve it
    slow.spreads.push_back(T);
    auto& row = slow.weights.emplace_back();
    for (const double M : slow.means) {
      double weight = normal_density(M, p, q) * normal_density(T, 0, q);
      for (const auto& likelihood : likelihoods) {
        double sum = 0;
        for (std::size_t i = 0; i < slow.means.size(); ++i)
          if (std::abs(slow.means[i] - M) < 7 * T) sum += likelihood[i] * normal_density(slow.means[i], M, T);
        weight *= sum;
      }
      row.push_back(weight);
      slow.total += weight;
    }
  }
  return slow;
}

TEST_CASE("oracle: mixtures against slow sums over mean, spread and every specimen's value") {
  const std::vector<Marginal> tests{{{{0.7, 0.4, 0.06}, {0.3, 0.7, 0.1}}, 0.5, 0.45},
                                    {{{1, 0.55, 0.05}}, 0.5, 0.45},
                                    {{{0.5, 0.3, 0.2}, {0.5, 0.35, 0.08}}, 0.5, 0.45},
                                    {{{1, 0.8, 0.15}}, 0.5, 0.45}};
  const auto population = population_of(tests, {0.5, 0.3});
  const auto slow = slow_population(tests, 0.5, 0.3);
  // A place of the sums holds 1 % of the probability at most, half of it either side of an end.
  CHECK(std::abs(slow.mean_below(population.mean.value) - 0.5) < 0.03);
  CHECK(std::abs(slow.mean_below(population.mean.low) - 0.025) < 0.003);
  CHECK(std::abs(slow.mean_below(population.mean.high) - 0.975) < 0.003);
  CHECK(std::abs(slow.spread_below(population.spread.value) - 0.5) < 0.05);
  CHECK(std::abs(slow.spread_below(population.spread.high) - 0.975) < 0.003);
  // The first specimen from the posterior of M and T.
  double sum = 0, squares = 0, total = 0;
  for (std::size_t j = 0; j < slow.spreads.size(); ++j)
    for (std::size_t i = 0; i < slow.means.size(); ++i) {
      if (slow.weights[j][i] < 1e-7 * slow.total) continue;
      double seen = 0, x1 = 0, x2 = 0;
      for (double x = -0.5; x < 1.5; x += 0.01) {
        double posterior = 0;
        for (const auto& part : tests[0].posterior)
          posterior += part.weight * normal_density(x, part.mean, part.deviation);
        const double weight =
            posterior / normal_density(x, 0.5, 0.45) * normal_density(x, slow.means[i], slow.spreads[j]);
        seen += weight;
        x1 += weight * x;
        x2 += weight * x * x;
      }
      total += slow.weights[j][i];
      sum += slow.weights[j][i] * x1 / seen;
      squares += slow.weights[j][i] * x2 / seen;
    }
  const double mean = sum / total, deviation = std::sqrt(squares / total - mean * mean);
  CHECK(std::abs(population.specimens[0].value - mean) < 0.02 * deviation);
  CHECK(population.specimens[0].standard_error == doctest::Approx(deviation).epsilon(0.02));
}

struct Coverage {
  int mean = 0, spread = 0, specimens = 0;
};

struct Truth {
  double M, T;
};

template <class Draw>
Coverage coverage(int campaigns, int tests, double error, Draw truth) {
  std::mt19937_64 random(2021);
  std::normal_distribution<double> normal;
  Coverage coverage;
  for (int campaign = 0; campaign < campaigns; ++campaign) {
    const auto [M, T] = truth(normal, random);
    std::vector<Marginal> records;
    std::vector<double> values;
    for (int t = 0; t < tests; ++t) {
      const double own = error * (0.5 + 0.5 * (t % 4));
      values.push_back(M + T * normal(random));
      records.push_back(told(values.back() + own * normal(random), own, 0.55, 0.5));
    }
    const auto population = population_of(records, prior_told_to(records));
    coverage.mean += population.mean.low <= M && M <= population.mean.high;
    coverage.spread += population.spread.low <= T && T <= population.spread.high;
    for (std::size_t t = 0; t < values.size(); ++t)
      coverage.specimens +=
          std::abs(population.specimens[t].value - values[t]) < 1.96 * population.specimens[t].standard_error;
  }
  return coverage;
}

constexpr int campaigns = 250;
constexpr int least = 230, most = 245;  // 92 and 98 %

TEST_CASE("oracle: intervals of 95 % cover mean and spread of simulated campaigns, truth drawn as was believed") {
  for (const int tests : {4, 12, 26}) {
    const auto found = coverage(campaigns, tests, 0.1, [](auto& normal, auto& random) {
      const double M = 0.55 + 0.5 * normal(random);
      return Truth{M, 0.5 * std::abs(normal(random))};
    });
    CAPTURE(tests);
    CHECK(found.mean >= least);
    CHECK(found.mean <= most);
    CHECK(found.spread >= least);
    CHECK(found.spread <= most);
    CHECK(found.specimens >= 0.92 * campaigns * tests);
    CHECK(found.specimens <= 0.98 * campaigns * tests);
  }
}

TEST_CASE(
    "oracle: intervals of 95 % cover mean and spread of simulated campaigns whose specimens differ by as little as "
    "real ones") {
  struct Setting {
    int tests;
    double T, error;
  };
  for (const auto& [tests, T, error] : {Setting{6, 0.15, 0.08}, {12, 0.15, 0.05}, {26, 0.1, 0.1}, {12, 0.03, 0.1}}) {
    const auto found = coverage(campaigns, tests, error, [&, T = T](auto& normal, auto& random) {
      return Truth{0.55 + 0.25 * normal(random), T};
    });
    CAPTURE(tests);
    CAPTURE(T);
    CHECK(found.mean >= least);  // more than 98 % where few tests hardly tell T: it might be greater
    CHECK(found.spread >= least);
    CHECK(found.specimens >= 0.92 * campaigns * tests);
  }
}

TEST_CASE("identity: records that say nothing leave what was known; two that differ by far are told apart") {
  const std::vector<Marginal> nothing(3, {{{1, 0.55, 0.5}}, 0.55, 0.5});
  const auto unknown = population_of(nothing, {0.55, 0.5});
  CHECK(std::abs(unknown.mean.value - 0.55) < 0.01 * 0.5);
  CHECK(unknown.mean.standard_error == doctest::Approx(0.5).epsilon(0.01));
  CHECK(unknown.spread_is_bound);
  CHECK(unknown.spread.high == doctest::Approx(0.5 * 2.241403).epsilon(0.01));  // half-normal
  const std::vector<Marginal> apart{told(0.3, 0.02, 0.55, 0.5), told(0.8, 0.02, 0.55, 0.5)};
  const auto two = population_of(apart, {0.55, 0.5});
  CHECK(!two.spread_is_bound);
  CHECK(two.spread.low > 0.1);
}

TEST_CASE("table: one test is no population, and what was known beforehand has a width") {
  const std::vector<Marginal> one{told(0.5, 0.1, 0.55, 0.5)};
  CHECK(message_of([&] { population_of(one, {0.55, 0.5}); }).find("a population of 1 tests") != std::string::npos);
  const std::vector<Marginal> two(2, one[0]);
  CHECK(!message_of([&] { population_of(two, {0.55, std::numeric_limits<double>::infinity()}); }).empty());
}

}  // namespace
}  // namespace flexslip
