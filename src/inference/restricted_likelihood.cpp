#include "inference/restricted_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// X' V⁻¹ X of AR(1) noise is a polynomial in its correlation: M0 - ρ M1 + ρ² M2.
struct WhitenedProduct {
  MatrixXd M0, M1, M2;
  explicit WhitenedProduct(const MatrixXd& X) {
    const Index n = X.rows();
    M0 = X.transpose() * X;
    M1 = X.topRows(n - 1).transpose() * X.bottomRows(n - 1);
    M1 += M1.transpose().eval();
    M2 = M0 - X.row(0).transpose() * X.row(0) - X.row(n - 1).transpose() * X.row(n - 1);
  }
  MatrixXd at(double rho) const { return M0 - rho * M1 + rho * rho * M2; }
};

}  // namespace

CorrelatedNoise restricted_noise(const ForceModel& model, const FitPoint& fit) {
  const auto response = model.response(fit.layout, fit.p);
  const Index n = response.force.size();
  const Index last = fit.layout.stiffness();
  const auto degrees_of_freedom = static_cast<double>(n - fit.layout.size());
  const double eta = fit.p[last] - model.prior_mean();
  const WhitenedProduct slopes(response.slopes);
  const WhitenedProduct squares(MatrixXd(model.measured_force() - response.force));
  constexpr int correlations = 100;  // a hundredth apart: a fifth of the standard error that 300 points give
  CorrelatedNoise best{};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < correlations; ++i) {
    const double rho = 0.01 * i;
    const double prior = fit.noise.variance / model.prior_variance();
    const double rss = std::max(squares.at(rho)(0, 0) + prior * eta * eta, 1e-14);
    MatrixXd H = slopes.at(rho);
    H(last, last) += prior;
    const double deviance = degrees_of_freedom * std::log(rss) - std::log(1 - rho * rho) +
                            H.ldlt().vectorD().cwiseMax(1e-300).array().log().sum();
    if (deviance < least) {
      least = deviance;
      best = {rho, rss / degrees_of_freedom};
    }
  }
  return best;
}

RestrictedLikelihood::RestrictedLikelihood(const ForceModel& model, const FitPoint& fit, const CorrelatedNoise& noise)
    : model_(model),
      layout_(fit.layout),
      noise_(noise),
      degrees_of_freedom_(static_cast<double>(model.measured_force().size() - fit.layout.size())) {}

double RestrictedLikelihood::deviance(const VectorXd& p) const {
  if (!model_.permits(layout_, p)) return std::numeric_limits<double>::infinity();
  const VectorXd residuals = model_.measured_force() - model_.force(layout_, p);
  const double eta = p[layout_.stiffness()] - model_.prior_mean();
  const double squares =
      whitened(residuals, noise_.correlation).squaredNorm() + noise_.variance * eta * eta / model_.prior_variance();
  return degrees_of_freedom_ * std::log(std::max(squares, 1e-14));
}

double RestrictedLikelihood::rise95() const {
  // The correlation is estimated too, with a standard error of √((1 - ρ²)/n), and a standard error of the level goes as
  // 1/(1 - ρ): by Satterthwaite's rule it has as many degrees of freedom as half the points that the residuals are worth. The
  // waves depend less on it, and are known where the level is not: so there are at least 20.
  const double rho = noise_.correlation;
  const auto n = static_cast<double>(model_.measured_force().size());
  const double freedom = std::max(0.5 * n * (1 - rho) / (1 + rho), 20.0);
  // The F distribution of 1 and that many degrees of freedom, to its first order, through the logarithm of the squares.
  constexpr double chi2 = 3.841459;
  const double F = chi2 * (1 + (chi2 + 1) / (2 * freedom));
  return degrees_of_freedom_ * std::log1p(F / degrees_of_freedom_);
}

}  // namespace flexslip
