#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "numerics/statistics.h"

namespace flexslip {

TEST_CASE("line: least squares through points that lie on one, and beside one (identity, calculation by hand)") {
  const std::vector<double> x{0, 1, 2, 3};
  CHECK(line_through(x, std::vector{1.0, 3.0, 5.0, 7.0}).slope == 2);
  const Line line = line_through(x, std::vector{0.0, 2.0, 1.0, 3.0});
  CHECK(line.slope == doctest::Approx(0.8).epsilon(1e-15));
  CHECK(line.mean_x == 1.5);
  CHECK(line.mean_y == 1.5);
  CHECK(line.sum_xx == 5);
  CHECK(line_through(std::vector{2.0, 2.0}, std::vector{1.0, 3.0}).slope == 0);
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
