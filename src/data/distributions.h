// Tails and quantiles of the distributions that verdicts rest on.
#pragma once

#include <cmath>
#include <numbers>
#include <numeric>

namespace flexslip {

// P(standard Gaussian > x).
inline double gaussian_tail(double x) { return 0.5 * std::erfc(x / std::numbers::sqrt2); }

// x with P(standard Gaussian < x) = probability.
// Domain:     1e-12 < probability < 1 - 1e-12.
// Max error:  1e-12.
inline double gaussian_quantile(double probability) {
  double low = -10;
  double high = 10;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::midpoint(low, high);
    (gaussian_tail(-middle) < probability ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

// P(t > x) of Student's distribution: Wallace's transformation to a Gaussian (Ann. Math. Stat. 30, 1959).
// Max error:  2 % of the probability for nu >= 8 down to 1e-6.
inline double student_tail(double x, double nu) {
  const double z = (8 * nu + 1) / (8 * nu + 3) * std::sqrt(nu * std::log1p(x * x / nu));
  return gaussian_tail(std::copysign(z, x));
}

// Its inverse: the quantile of Student's t where that of the Gaussian is z.
// Max error:  4.1 % at nu = 2 for 95 % two-sided, and less beyond.
inline double student_quantile(double z, double nu) {
  const double x = z * (8 * nu + 3) / (8 * nu + 1);
  return std::sqrt(nu * std::expm1(x * x / nu));
}

}  // namespace flexslip
