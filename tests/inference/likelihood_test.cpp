#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "inference/population.h"
#include "numerics/elementary.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

double log_normal_density(double x, double mean, double deviation) {
  return -0.5 * std::pow((x - mean) / deviation, 2) - std::log(deviation);
}

// A posterior over its prior, by definition.
double log_quotient(const Marginal& marginal, double x) {
  double sum = 0;
  for (const auto& part : marginal.posterior)
    sum += part.weight * std::exp(log_normal_density(x, part.mean, part.deviation));
  return std::log(sum) - log_normal_density(x, marginal.prior_mean, marginal.prior_deviation);
}

// Differences of ln are known up to a constant.
void check_same_up_to_a_factor(const std::vector<double>& one, const std::vector<double>& other) {
  for (std::size_t i = 1; i < one.size(); ++i)
    CHECK(one[i] - one[0] ==
          doctest::Approx(other[i] - other[0]).scale(1).epsilon(1e-12));  // some ulp of terms of order 100
}

const Marginal two_parts{{{0.7, 0.4, 0.1}, {0.3, 0.7, 0.2}}, 0.55, 0.5};

TEST_CASE("oracle: a posterior narrower than its prior, over it, by the definition") {
  const auto likelihood = likelihood_of(two_parts);
  std::vector<double> ours, theirs;
  for (double x = -0.5; x < 2; x += 0.1) {
    ours.push_back(log_of(likelihood, x));
    theirs.push_back(log_quotient(two_parts, x));
  }
  check_same_up_to_a_factor(ours, theirs);
}

TEST_CASE("identity: a normal record under any normal prior says the same of itself") {
  const double value = 0.3, error = 0.1;
  const auto told = [&](double p, double q) {
    const double weight = 1 / (error * error) + 1 / (q * q);
    return likelihood_of({{{1, (value / (error * error) + p / (q * q)) / weight, 1 / std::sqrt(weight)}}, p, q});
  };
  const auto alone = likelihood_of({{{1, value, error}}, 0, infinity});
  for (const auto& likelihood : {told(0, 1), told(0.5, 0.2), told(-1, 10)}) {
    std::vector<double> ours, theirs;
    for (double x = -0.5; x < 1; x += 0.1) {
      ours.push_back(log_of(likelihood, x));
      theirs.push_back(log_of(alone, x));
    }
    check_same_up_to_a_factor(ours, theirs);
  }
}

TEST_CASE(
    "identity: a part as wide as the prior, or wider, keeps value and slope at its middle, and falls beyond three "
    "deviations") {
  for (const double s : {0.95, 1.0, 1.3}) {
    const Marginal wide{{{1, 0.6, s}}, 0, 1};
    const auto likelihood = likelihood_of(wide);
    const double step =
        1e-5;  // the slope's error is the third derivative, of which there is none; rounding leaves 1e-10
    CHECK((log_of(likelihood, 0.6 + step) - log_of(likelihood, 0.6 - step)) / (2 * step) ==
          doctest::Approx(0.6).epsilon(1e-9));
    for (double x = 0.6 + 3 * s; x < 20; x += 0.5) CHECK(log_of(likelihood, x + 0.5) < log_of(likelihood, x));
  }
  // The record that moved nothing says nothing.
  const auto nothing = likelihood_of({{{1, 0, 1}}, 0, 1});
  CHECK(log_of(nothing, -5) == log_of(nothing, 7));
}

TEST_CASE("oracle: a likelihood blurred is its integral with a normal distribution, by the sum over 40 deviations") {
  const Marginal wide{{{0.6, 0.4, 0.1}, {0.4, 1.2, 0.55}}, 0.55, 0.5};  // the second part is wider than the prior
  for (const auto& marginal : {two_parts, wide}) {
    const auto likelihood = likelihood_of(marginal);
    for (const double spread : {0.02, 0.3, 2.0}) {
      const auto blurred_likelihood = blurred(likelihood, spread);
      for (const double M : {-0.3, 0.5, 1.5}) {
        double sum = 0;
        const double step = std::min(spread, 0.05) / 10;  // the trapezoidal rule of smooth functions: exact to rounding
        for (double v = M - 20 * spread; v < M + 20 * spread; v += step)
          sum += step * std::exp(log_of(likelihood, v) + log_normal_density(v, M, spread)) /
                 std::sqrt(2 * std::acos(-1.0));
        CHECK(log_of(blurred_likelihood, M) == doctest::Approx(std::log(sum)).scale(1).epsilon(1e-11));  // of 1e5 terms
      }
    }
  }
  const auto same = blurred(likelihood_of(two_parts), 0);
  CHECK(log_of(same, 0.3) == log_of(likelihood_of(two_parts), 0.3));
}

TEST_CASE("identity: climbing never falls, and ends where the product is greatest nearby") {
  const std::vector<Likelihood> factors{likelihood_of(two_parts), likelihood_of_normal(0.9, 0.15)};
  for (const double start : {-1.0, 0.2, 0.5, 2.0}) {
    const double top = climbed(factors, start);
    CHECK(log_of_product(factors, top) >= log_of_product(factors, start));
    for (const double aside : {-1e-3, 1e-3}) CHECK(log_of_product(factors, top + aside) < log_of_product(factors, top));
  }
}

TEST_CASE("table: what is no posterior of a number sought is refused") {
  CHECK(message_of([] { likelihood_of({{}, 0, 1}); }) == "a likelihood needs a posterior and a prior of some width");
  CHECK(message_of([] { likelihood_of({{{1, 0.5, 0}}, 0, 1}); }).find("0.500000 ± 0.000000") != std::string::npos);
  CHECK(!message_of([] { likelihood_of({{{1, 0.5, 0.1}}, 0, 0}); }).empty());
}

}  // namespace
}  // namespace flexslip
