#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "inference/population.h"
#include "numerics/elementary.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

TEST_CASE("limit: a product of normal distributions is one: integral, moments, quantiles") {
  // Errors of which some are 3000 times the others, far apart: the product lies where no coarse look falls.
  const std::vector<Likelihood> factors{likelihood_of_normal(0.3, 0.001), likelihood_of_normal(0.302, 0.0015),
                                        likelihood_of_normal(-5, 3)};
  double weight = 0, sum = 0, squares = 0;
  for (const auto& factor : factors) {
    weight += factor[0].curvature;
    sum += factor[0].curvature * factor[0].at;
    squares += factor[0].curvature * factor[0].at * factor[0].at;
  }
  const double mean = sum / weight, deviation = 1 / std::sqrt(weight);
  const double log_integral = -0.5 * (squares - sum * mean) + std::log(deviation * std::sqrt(2 * std::acos(-1.0)));
  const auto coarse = density_of_product(factors, 0.7);
  CHECK(coarse.log_integral ==
        doctest::Approx(log_integral).scale(1).epsilon(1e-7));  // what is cut off, and rounding of 1e5 deviations
  const auto fine = density_of_product(factors, 0.25);
  CHECK(fine.log_integral == doctest::Approx(log_integral).scale(1).epsilon(1e-7));
  CHECK(fine.density.mean() == doctest::Approx(mean).scale(deviation).epsilon(1e-7));
  CHECK(fine.density.deviation() == doctest::Approx(deviation).epsilon(1e-6));  // of the cut 1e-8, 36 deviations²
  for (const double z : {-2.5, -1.96, -1.0, 0.0, 0.3, 1.96, 2.5}) {
    const double probability = 0.5 * std::erfc(-z / std::sqrt(2.0));
    CHECK(std::abs(fine.density.quantile(probability) - (mean + z * deviation)) < 1e-3 * deviation);  // as promised
    CHECK(std::abs(fine.density.probability_below(mean + z * deviation) - probability) < 1e-4);
  }
}

TEST_CASE("oracle: products of mixtures against their sum over many places") {
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<Likelihood> factors;
    for (int t = 0; t < 4; ++t) {
      Marginal marginal{{}, 0, trial % 2 == 0 ? 1.0 : infinity};
      for (int c = 0; c < 3; ++c)
        marginal.posterior.push_back({0.05 + uniform(), 2 * uniform() - 1, std::pow(10, -1.7 * uniform())});
      factors.push_back(likelihood_of(marginal));
    }
    const auto product = density_of_product(factors, 0.25);
    constexpr int places = 200000;
    const double step = 12.0 / places;
    double sum = 0, half = 0;
    const double median = product.density.quantile(0.5);
    for (int i = 0; i <= places; ++i) {
      const double x = -6 + step * i;
      const double value = std::exp(log_of_product(factors, x) - product.log_integral) * step;
      sum += value;
      if (x < median) half += value;
    }
    CHECK(std::abs(sum - 1) < 1e-6);  // what is cut off of a mixture, each end 1e-8 of its height, over some widths
    CHECK(std::abs(half - 0.5) < 1e-4 + 20 * step);  // as promised, and what one place holds
  }
}

TEST_CASE("table: what is no density is refused") {
  CHECK(!message_of([] { LineDensity(0, 1, {1, 2, 1}); }).empty());
  CHECK(!message_of([] { LineDensity(0, 1, {0, 0, 0, 0}); }).empty());
  CHECK(!message_of([] { density_of_product({}, 0.25); }).empty());
  const std::vector<Likelihood> flat{{{0, 0, 0, 0}}};
  CHECK(message_of([&] { density_of_product(flat, 0.25); }) == "no factor of the product bounds the number");
  const std::vector<Likelihood> one{likelihood_of_normal(0, 1)};
  CHECK(!message_of([&] { density_of_product(one, 0.8); }).empty());
}

}  // namespace
}  // namespace flexslip
