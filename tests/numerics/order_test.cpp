#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
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

TEST_CASE("calculation by hand: quantiles of values in order lie on the lines between them") {
  const std::vector<double> values{1, 2, 4, 8};
  CHECK(quantile_in_order(values, 0) == 1);
  CHECK(quantile_in_order(values, 1) == 8);
  CHECK(quantile_in_order(values, 0.5) == 3);
  CHECK(quantile_in_order(values, 0.25) == 1.75);
  CHECK(quantile_in_order(std::vector{5.0}, 0.3) == 5);
  CHECK(std::isnan(quantile_in_order({}, 0.5)));
  CHECK(mean_of(values) == 3.75);
  CHECK(std::isnan(mean_of(std::vector<double>{})));
}

TEST_CASE("oracle: the noise of single readings, simulated on a curve with drops") {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  std::vector<double> readings;
  double lost = 0;
  for (int i = 0; i < 20000; ++i) {
    if (i % 50 == 49) lost += 30;
    readings.push_back(1e-3 * i - 1e-7 * i * i - lost + 0.2 * normal(generator));
  }
  // Scatter of a median of dependent values: 0.8 %; two in fifty second differences hold a drop, which raises their median by 5 %.
  const double noise = noise_of_second_differences(second_differences(readings));
  CHECK(noise > 0.2 * 0.97);
  CHECK(noise < 0.2 * 1.09);
}

TEST_CASE("calculation by hand: second differences of a line, of a parabola, and of too few readings") {
  CHECK(second_differences(std::vector{1.0, 2.0, 3.0, 4.0}) == std::vector{0.0, 0.0});
  CHECK(second_differences(std::vector{0.0, 1.0, 4.0, 9.0}) == std::vector{2.0, 2.0});
  CHECK(noise_of_second_differences({6, 6}) == doctest::Approx(deviation_by_median * std::sqrt(6.0)).epsilon(1e-15));
  CHECK(second_differences(std::vector{1.0, 2.0}).empty());
  CHECK(noise_of_second_differences({}) == 0);
  CHECK(deviation_by_median == doctest::Approx(1 / elementary::gaussian_quantile(0.75)).epsilon(2e-5));
}

TEST_CASE("oracle: brute force finds no nearer non-decreasing sequence") {
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

TEST_CASE("table: an advancing sequence never decreases, nor falls below 0") {
  CHECK(advancing({}).empty());
  const std::vector<double> stages{-0.1, 0.2, 0.1, 0.3, 0.3};
  CHECK(advancing(stages) == std::vector<double>{0, 0.2, 0.2, 0.3, 0.3});
}

}  // namespace flexslip
