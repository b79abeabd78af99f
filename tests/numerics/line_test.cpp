#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "numerics/statistics.h"

namespace flexslip {

TEST_CASE("line: least squares through points on and off a line (identity, calculation by hand)") {
  const std::vector<double> x{0, 1, 2, 3};
  CHECK(line_through(x, std::vector{1.0, 3.0, 5.0, 7.0}).slope == 2);
  const Line line = line_through(x, std::vector{0.0, 2.0, 1.0, 3.0});
  CHECK(line.slope == doctest::Approx(0.8).epsilon(1e-15));
  CHECK(line.mean_x == 1.5);
  CHECK(line.mean_y == 1.5);
  CHECK(line.sum_xx == 5);
  CHECK(line_through(std::vector{2.0, 2.0}, std::vector{1.0, 3.0}).slope == 0);
}

TEST_CASE("line: the slope between two columns that both depend on a third (identity, calculation by hand)") {
  const std::vector<double> x{0, 1, 2, 3}, z{1, 3, 5, 7};
  const CommonLine exact = common_line(x, std::vector{5.0, 11.0, 17.0, 23.0}, z);
  CHECK(exact.slope == 3);
  CHECK(exact.residuals == std::vector{0.0, 0.0, 0.0, 0.0});
  CHECK(slope_error(exact, 0, 0.9) == 0);
  // y about its line through x: -0.3, 0.9, -0.9, 0.3; that is 1.8 squared, 0.9 for each of two freedoms, neighbours of opposite sign.
  const CommonLine line = common_line(x, std::vector{0.0, 2.0, 1.0, 3.0}, z);
  CHECK(line.slope == doctest::Approx(0.4).epsilon(1e-15));
  CHECK(slope_error(line, 0, 0.9) == doctest::Approx(std::sqrt(0.9 / 5) / 2).epsilon(1e-14));
  CHECK(std::isnan(common_line(x, std::vector{3.0, 2.0, 1.0, 0.0}, z).slope));
  CHECK(std::isnan(common_line(std::vector{1.0, 1.0}, std::vector{0.0, 1.0}, std::vector{0.0, 1.0}).slope));
}

TEST_CASE("line: the scatter of a mean of correlated readings (oracle: 4,000 simulated means)") {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  constexpr int n = 100;
  for (const double rho : {0.0, 0.5}) {
    double means = 0, estimates = 0;
    for (int run = 0; run < 4000; ++run) {
      std::vector<double> readings(n);
      double error = normal(generator), mean = 0;
      for (double& reading : readings) {
        error = rho * error + std::sqrt(1 - rho * rho) * normal(generator);
        reading = error;
        mean += error / n;
      }
      means += mean * mean;
      const double deviation = effective_deviation(readings, 0, 0, 0.95);
      estimates += deviation * deviation / n;
    }
    CHECK(estimates / means ==
          doctest::Approx(1).epsilon(0.1));  // 2/√4000 of scatter, and the bias of ρ in 100 readings
  }
}

}  // namespace flexslip
