// Estimates and their errors, distributions, quantiles, straight lines.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "numerics/elementary.h"

namespace flexslip {

// ---- Estimates

struct Estimate {
  double value = 0;           // median
  double standard_error = 0;  // standard deviation
  double low = 0, high = 0;   // 95 % interval
};

// Standard errors of a normal distribution to the ends of a 95 % interval.
inline constexpr double two_sided_95 = 1.96;

// An estimate with normal errors.
inline Estimate normal_estimate(double value, double standard_error) {
  return {value, standard_error, value - two_sided_95 * standard_error, value + two_sided_95 * standard_error};
}
// The same estimate in another unit.
Estimate scaled(const Estimate& estimate, double factor);
// The estimate of a quantity from the estimate of its logarithm. The interval is symmetric in the
// logarithm.
Estimate exponential(const Estimate& logarithm);
// An estimate whose standard error was determined with `freedom` degrees of freedom (Student).
Estimate student_estimate(double value, double standard_error, double freedom);

// ---- Tails and quantiles

// P(standard Gaussian > x).
// Max error:  relative 1e-12, for x < 37.
inline double gaussian_tail(double x) { return elementary::exp(elementary::gaussian_below(-x).log_probability); }

// P(t > x) for Student's distribution, by Wallace's transformation to a Gaussian (Ann. Math. Stat.
// 30, 1959).
// Max error:  2 % of the probability for nu >= 8 down to 1e-6.
inline double student_tail(double x, double nu) {
  const double z = (8 * nu + 1) / (8 * nu + 3) * std::sqrt(nu * elementary::log_of_one_and(x * x / nu));
  return gaussian_tail(std::copysign(z, x));
}

// The inverse: the quantile of Student's t for which the Gaussian quantile is z.
// Max error:  4.1 % at nu = 2 for 95 % two-sided, less for larger nu.
inline double student_quantile(double z, double nu) {
  const double x = z * (8 * nu + 3) / (8 * nu + 1);
  return std::sqrt(nu * elementary::exp_less_one(x * x / nu));
}

// ---- Means, medians, quantiles, monotone sequences

double mean_of(std::span<const double> values);  // NaN if empty

// The median. For an even number of values, the mean of the middle two; NaN if empty.
double median_of(std::vector<double> values);

// The quantile of sorted values, linearly interpolated: the first value at probability 0, the last
// at 1. NaN if empty.
// Domain:     0 <= probability <= 1.
double quantile_in_order(std::span<const double> values, double probability);

// The standard deviation of a normal variable divided by the median of its distance from the mean:
// 1/Φ^(-1)(3/4).
inline constexpr double deviation_by_median = 1.4826;

// The absolute second differences of readings: size - 2 of them, or none. For noise of standard
// deviation σ on a smooth curve, the standard deviation of second differences is √6 σ.
std::vector<double> second_differences(std::span<const double> readings);
// The noise of single readings, from the median of their second differences; 0 if there are none.
// Drops do not matter if fewer than half of the readings are next to one.
double noise_of_second_differences(std::vector<double> bends);

// The non-decreasing sequence nearest in least squares.
// Method:     pool adjacent violators (Ayer et al. 1955).
std::vector<double> non_falling(std::span<const double> values);

// The running maximum of the values, at least 0: the positions of a stage whose readings jitter.
std::vector<double> advancing(std::span<const double> values);

// ---- Straight lines and the scatter about them

struct Line {
  double mean_x, mean_y;
  double slope;   // 0 if x does not vary
  double sum_xx;  // Σ (x - mean_x)^2
};

// Least squares.
// Domain:     columns of equal length, at least one point.
Line line_through(std::span<const double> x, std::span<const double> y);

// The same through n points (x(i), y(i)).
template <class X, class Y>
Line line_through(std::size_t n, const X& x, const Y& y) {
  Line line{.mean_x = 0, .mean_y = 0, .slope = 0, .sum_xx = 0};
  for (std::size_t i = 0; i < n; ++i) line.mean_x += x(i), line.mean_y += y(i);
  line.mean_x /= static_cast<double>(n);
  line.mean_y /= static_cast<double>(n);
  double sum_xy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    line.sum_xx += (x(i) - line.mean_x) * (x(i) - line.mean_x);
    sum_xy += (x(i) - line.mean_x) * (y(i) - line.mean_y);
  }
  line.slope = line.sum_xx > 0 ? sum_xy / line.sum_xx : 0;
  return line;
}

// The slope of y against z, where both depend on a third column x without noise. It is the ratio of
// the slopes of (x, y) and (x, z).
struct CommonLine {
  Line y, z;
  double slope;                   // dy/dz; NaN unless both slopes are positive
  std::vector<double> residuals;  // of y about the line of that slope through both means
};
CommonLine common_line(std::span<const double> x, std::span<const double> y, std::span<const double> z);

// The standard error of the slope, from effective_deviation of the residuals with this `bias` and
// `most`.
double slope_error(const CommonLine& line, double bias, double most);

// √n times the standard deviation of the mean of n residuals. It exceeds the ordinary one if
// neighbours are correlated, as in an AR(1) process.
// `bias` [1] is added to the observed correlation; the sum is limited to `most`.
double effective_deviation(std::span<const double> residuals, std::size_t parameters, double bias, double most);

// [1] The correlation that fitting a line removes from its residuals: about (2 + 4 rho)/n.
double correlation_lost_to_line(std::span<const double> residuals);

// ---- Chi squared

// P(chi squared > x). The degrees of freedom may be fractional, as for variances that are sums of
// unequal parts.
// Domain:     x >= 0, 0 < freedoms <= 1e7.
// Max error:  1e-12, and relative 1e-10 of the smaller of the result and its complement.
double chi_squared_beyond(double x, double freedoms);

// ---- Mixtures of normal distributions

struct NormalPart {
  double weight;           // [1] > 0
  double mean, deviation;  // in the unit of the quantity; deviation >= 0
};

// Domain of all functions: at least one part. The weights need not add up to 1.
using NormalMixture = std::vector<NormalPart>;

double mean_of(const NormalMixture& mixture);
double deviation_of(const NormalMixture& mixture);
NormalMixture widened(NormalMixture mixture, double by);  // convolved with an independent error

// P(quantity < x).
double probability_below(const NormalMixture& mixture, double x);

// x with P(quantity < x) = probability.
// Domain:     0 < probability < 1.
// Max error:  1e-9 of the standard deviation.
double quantile_of(const NormalMixture& mixture, double probability);

}  // namespace flexslip
