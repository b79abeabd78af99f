#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "numerics/statistics.h"

namespace flexslip {
namespace {

TEST_CASE("limit: of one part the mixture is the normal distribution") {
  const NormalMixture one{{3, 0.5, 0.2}};
  CHECK(mean_of(one) == 0.5);
  CHECK(deviation_of(one) == doctest::Approx(0.2).epsilon(1e-15));
  for (const double z : {-3.0, -1.0, 0.0, 1.96}) {
    const double probability = 0.5 * std::erfc(-z / std::sqrt(2.0));
    CHECK(probability_below(one, 0.5 + 0.2 * z) == doctest::Approx(probability).epsilon(1e-12));
    CHECK(std::abs(quantile_of(one, probability) - (0.5 + 0.2 * z)) < 1e-9 * 0.2);  // as promised
  }
}

TEST_CASE("identity: merging keeps weight, mean and deviation, and no probability changes by more than 0.01") {
  std::mt19937_64 random(17);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int trial = 0; trial < 300; ++trial) {
    NormalMixture mixture;
    const double apart = std::pow(10, 2 * uniform() - 1), unlike = 2 * uniform();
    for (int i = 0; i < 40; ++i)
      mixture.push_back({0.01 + uniform(), apart * uniform(), 0.3 * std::exp(unlike * (uniform() - 0.5))});
    const auto fewer = merged(mixture);
    CHECK(fewer.size() < mixture.size());
    CHECK(mean_of(fewer) == doctest::Approx(mean_of(mixture)).epsilon(1e-13));  // forty sums
    CHECK(deviation_of(fewer) == doctest::Approx(deviation_of(mixture)).epsilon(1e-13));
    double worst = 0;
    for (double x = -1; x < 11; x += 0.05)
      worst = std::max(worst, std::abs(probability_below(fewer, x) - probability_below(mixture, x)));
    CHECK(worst < 0.01);  // as promised
  }
  const NormalMixture exact{{1, 2, 0}, {1, 2, 0}, {1, 3, 0}};
  CHECK(merged(exact).size() == 2);
}

}  // namespace
}  // namespace flexslip
