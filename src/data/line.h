// Straight lines through readings, and how far their scatter may be trusted.
#pragma once

#include <span>

namespace flexslip {

struct Line {
  double mean_x, mean_y;
  double slope;   // 0 if x does not vary
  double sum_xx;  // Σ (x - mean_x)^2
};

// Least squares. Domain: columns of one length, at least one point.
Line line_through(std::span<const double> x, std::span<const double> y);

// Standard deviation of the mean of residuals, times √n: larger than the plain one if neighbours err alike, as an AR(1) process.
// `bias` [1] is added to the correlation that the residuals show, which is at most `most` then.
double effective_deviation(std::span<const double> residuals, std::size_t parameters, double bias, double most);

// The correlation that the residuals of a line lose to it: they show about (2 + 4 rho)/n less than the noise has.
double correlation_lost_to_line(std::span<const double> residuals);

}  // namespace flexslip
