#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <doctest/doctest.h>

#include "numerics/statistics.h"

namespace flexslip {

TEST_CASE("identity: as many values lie below the median as above it") {
  CHECK(median_of({3, 1, 2}) == 2);
  CHECK(median_of({4, 1, 3, 2}) == 2.5);
  CHECK(median_of({7}) == 7);
  CHECK(std::isnan(median_of({})));
}

TEST_CASE("oracle: the nearest non-falling sequence is no farther than any by brute force") {
  const std::vector<double> values{1, 3, 2, 2.5, 0.5, 4, 3.9};
  const auto fitted = non_falling(values);
  CHECK(std::is_sorted(fitted.begin(), fitted.end()));
  const auto misfit = [&](const std::vector<double>& other) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += (values[i] - other[i]) * (values[i] - other[i]);
    return sum;
  };
  // Every block of it is a mean, and every cut of the sequence into blocks whose means rise is no better.
  double least = 1e300;
  for (unsigned cuts = 0; cuts < 64; ++cuts) {
    std::vector<double> other;
    for (std::size_t i = 0; i < values.size();) {
      std::size_t j = i + 1;
      while (j < values.size() && !(cuts >> (j - 1) & 1)) ++j;
      const double mean = std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(i),
                                          values.begin() + static_cast<std::ptrdiff_t>(j), 0.0) /
                          static_cast<double>(j - i);
      other.insert(other.end(), j - i, mean);
      i = j;
    }
    if (std::is_sorted(other.begin(), other.end())) least = std::min(least, misfit(other));
  }
  CHECK(misfit(fitted) == doctest::Approx(least).epsilon(1e-14));
}

TEST_CASE("table: what advances never goes back, nor below 0") {
  CHECK(advancing({}).empty());
  const std::vector<double> stages{-0.1, 0.2, 0.1, 0.3, 0.3};
  CHECK(advancing(stages) == std::vector<double>{0, 0.2, 0.2, 0.3, 0.3});
}

}  // namespace flexslip
