#include "inference/correlated_noise.h"

#include <algorithm>

namespace flexslip {

using Eigen::Index;
using Eigen::VectorXd;

CorrelatedNoise noise_of(const VectorXd& residuals, Index parameters) {
  const auto n = residuals.size();
  double rho = residuals.head(n - 1).dot(residuals.tail(n - 1)) / std::max(residuals.squaredNorm(), 1e-300);
  rho = std::clamp(rho, 0.0, 0.99);
  if (rho < 2 / std::sqrt(static_cast<double>(n))) rho = 0;  // not significant
  const VectorXd white = whitened(residuals, rho);
  return {rho, std::max(white.squaredNorm() / static_cast<double>(n - parameters), 1e-14)};
}

double log_likelihood(const VectorXd& residuals, double correlation) {
  const auto n = static_cast<double>(residuals.size());
  const double rss = whitened(residuals, correlation).squaredNorm();
  return -0.5 * (n * std::log(std::max(rss / n, 1e-14)) - std::log(1 - correlation * correlation));
}

}  // namespace flexslip
