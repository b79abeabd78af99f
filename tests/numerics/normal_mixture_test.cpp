#include <cmath>

#include <doctest/doctest.h>

#include "numerics/statistics.h"

namespace flexslip {
namespace {

TEST_CASE("limit: a mixture of one part is the normal distribution") {
  const NormalMixture one{{3, 0.5, 0.2}};
  CHECK(mean_of(one) == 0.5);
  CHECK(deviation_of(one) == doctest::Approx(0.2).epsilon(1e-15));
  for (const double z : {-3.0, -1.0, 0.0, 1.96}) {
    const double probability = 0.5 * std::erfc(-z / std::sqrt(2.0));
    CHECK(probability_below(one, 0.5 + 0.2 * z) == doctest::Approx(probability).epsilon(1e-12));
    CHECK(std::abs(quantile_of(one, probability) - (0.5 + 0.2 * z)) < 1e-9 * 0.2);  // as promised
  }
}

}  // namespace
}  // namespace flexslip
