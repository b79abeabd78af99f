// Residuals that err alike from point to point: r_i = ρ r_{i-1} + ε_i (theory.md, "Residuals").
#pragma once

#include <cmath>

#include <Eigen/Dense>

namespace flexslip {

struct CorrelatedNoise {
  double correlation;  // [1] ρ of neighbouring residuals
  double variance;     // of the innovations ε
};

// Made independent: r_i - ρ r_{i-1}, and √(1 - ρ²) r_0; columns alike.
template <class Matrix>
Matrix whitened(const Matrix& residuals, double correlation) {
  Matrix result = residuals;
  const auto n = residuals.rows();
  result.bottomRows(n - 1) = residuals.bottomRows(n - 1) - correlation * residuals.topRows(n - 1);
  result.row(0) = std::sqrt(1 - correlation * correlation) * residuals.row(0);
  return result;
}

// The lag-one correlation of residuals, between 0 and 0.99, and 0 where it is not significant; the variance with `parameters`
// degrees of freedom taken off.
CorrelatedNoise noise_of(const Eigen::VectorXd& residuals, Eigen::Index parameters);

// Of residuals, the variance at its best for the given correlation; up to a constant.
double log_likelihood(const Eigen::VectorXd& residuals, double correlation);

}  // namespace flexslip
