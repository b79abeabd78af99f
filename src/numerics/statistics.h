// Estimates and their errors, distributions, quantiles, straight lines.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "numerics/elementary.h"

namespace flexslip {

// A number that was estimated: its value, how uncertain it is, and between what it lies.

struct Estimate {
  double value = 0;           // median of what is known
  double standard_error = 0;  // standard deviation
  double low = 0, high = 0;   // 95 % interval
};

// Standard errors of a normal distribution to the ends of a 95 % interval.
inline constexpr double two_sided_95 = 1.96;

// One whose errors are normal; and one whose standard error is itself told by `freedom` degrees of freedom only (Student).
inline Estimate normal_estimate(double value, double standard_error) {
  return {value, standard_error, value - two_sided_95 * standard_error, value + two_sided_95 * standard_error};
}
// Of the same number in another unit, and of one whose logarithm is estimated: its interval is symmetric in the logarithm.
Estimate scaled(const Estimate& estimate, double factor);
Estimate exponential(const Estimate& logarithm);
Estimate student_estimate(double value, double standard_error, double freedom);

// Tails and quantiles of the distributions that verdicts rest on.

// P(standard Gaussian > x).
// Max error:  relative 1e-12, for x < 37.
inline double gaussian_tail(double x) { return elementary::exp(elementary::gaussian_below(-x).log_probability); }

// P(t > x) of Student's distribution: Wallace's transformation to a Gaussian (Ann. Math. Stat. 30, 1959).
// Max error:  2 % of the probability for nu >= 8 down to 1e-6.
inline double student_tail(double x, double nu) {
  const double z = (8 * nu + 1) / (8 * nu + 3) * std::sqrt(nu * elementary::log_of_one_and(x * x / nu));
  return gaussian_tail(std::copysign(z, x));
}

// Its inverse: the quantile of Student's t where that of the Gaussian is z.
// Max error:  4.1 % at nu = 2 for 95 % two-sided, and less beyond.
inline double student_quantile(double z, double nu) {
  const double x = z * (8 * nu + 3) / (8 * nu + 1);
  return std::sqrt(nu * elementary::exp_less_one(x * x / nu));
}

// Means and statistics of order: medians, quantiles, and sequences that do not fall.

double mean_of(std::span<const double> values);  // NaN of none

// Of an even number of values the mean of the middle two; NaN of none.
double median_of(std::vector<double> values);

// Of values that do not fall, straight between one and the next: the first at 0, the last at 1. NaN of none.
// Domain:     0 <= probability <= 1.
double quantile_in_order(std::span<const double> values, double probability);

// Standard deviation of a normal number over the median of its distance from the middle: 1/Φ^(-1)(3/4).
inline constexpr double deviation_by_median = 1.4826;

// The noise of single readings, of which neighbours on a smooth curve tell by how much the middle one of three lies off the line through the
// others: noise of deviation σ makes √6 σ of it. Drops do not matter as long as fewer than half of the readings stand beside one.
std::vector<double> second_differences(
    std::span<const double> readings);                          // |second differences|: size - 2 of them, or none
double noise_of_second_differences(std::vector<double> bends);  // by their median; 0 of none

// The nearest non-falling sequence, in least squares.
// Method:     pool adjacent violators (Ayer et al. 1955).
std::vector<double> non_falling(std::span<const double> values);

// Each value, or the greatest before it, or 0: the positions of a stage whose readings jitter.
std::vector<double> advancing(std::span<const double> values);

// Straight lines through readings, and how far their scatter may be trusted.

struct Line {
  double mean_x, mean_y;
  double slope;   // 0 if x does not vary
  double sum_xx;  // Σ (x - mean_x)^2
};

// Least squares. Domain: columns of one length, at least one point.
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

// How y goes with z where both follow a third column x without noise: by the lines through (x, y) and (x, z).
struct CommonLine {
  Line y, z;
  double slope;                   // dy/dz; NaN unless both rise
  std::vector<double> residuals;  // of y about the line of that slope through both means
};
CommonLine common_line(std::span<const double> x, std::span<const double> y, std::span<const double> z);

// The standard error of its slope, of the residuals' effective_deviation with such a bias and `most`.
double slope_error(const CommonLine& line, double bias, double most);

// Standard deviation of the mean of residuals, times √n: larger than the plain one if neighbours err alike, as an AR(1) process.
// `bias` [1] is added to the correlation that the residuals show, which is at most `most` then.
double effective_deviation(std::span<const double> residuals, std::size_t parameters, double bias, double most);

// The correlation that the residuals of a line lose to it: they show about (2 + 4 rho)/n less than the noise has.
double correlation_lost_to_line(std::span<const double> residuals);

// The distribution that sums of squares are judged by: its tail, with freedoms that need not be whole (of variances that are
// sums of unequal parts).

// P(chi squared > x).
// Domain:     x >= 0, 0 < freedoms <= 1e7.
// Max error:  1e-12, and 1e-10 of the smaller of it and its complement.
double chi_squared_beyond(double x, double freedoms);

// What is known of a number, as a mixture of normal distributions.

struct NormalPart {
  double weight;           // [1] > 0
  double mean, deviation;  // in the unit of the number; deviation >= 0
};

// Domain of all: parts not empty; the weights need not add up to 1.
using NormalMixture = std::vector<NormalPart>;

double mean_of(const NormalMixture& mixture);
double deviation_of(const NormalMixture& mixture);
NormalMixture widened(NormalMixture mixture, double by);  // with an independent error besides

// P(number < x).
double probability_below(const NormalMixture& mixture, double x);

// x with P(number < x) = probability. Domain: 0 < probability < 1. Max error: 1e-9 of the deviation.
double quantile_of(const NormalMixture& mixture, double probability);

}  // namespace flexslip
