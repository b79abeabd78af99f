// A Gaussian process along the fibre as seen at many places (looks.h): what they say of it, in time proportional to their number.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "inference/looks.h"
#include "inference/square.h"

namespace flexslip {

// What all looks together say of one.
struct SmoothedLook {
  double f;         // [1] mean of h'β + g
  double variance;  // [1] of it, where it is no reading; NaN of readings
  double slope;     // [1/L] dg/dx of the mean of g; of an exponential kernel, which has none, the mean of both sides
  double e;         // [EI/L^2] mean of e
};

namespace chain {
// One step of the filter with a state of M numbers: g and its derivatives, each in units of the rate of the kernel, then e.
template <int M>
struct Step {
  std::array<double, static_cast<std::size_t>(M) * M> predicted;   // covariance before the look
  std::array<double, static_cast<std::size_t>(M) * M> transition;  // to it from the look before
  Few<M> gain;
  double innovation;  // variance of what the look adds; infinite: nothing is seen
};
template <int M>
struct Steps {
  std::vector<Step<M>> steps;
  double rate;  // [1/L] of the kernel
};
}  // namespace chain

class Chain {
 public:
  // Domain:     as require_domain. Variances and priors > 0; the looks outlive this.
  // Method:     a Kalman filter whose state is g, its derivatives and e; the columns pass it as further series.
  // Cost:       linear in the looks and in the columns.
  Chain(const Looks& looks, Kernel kernel, const Hyperparameters& at);

  double log_likelihood() const { return log_likelihood_; }            // ln p(y)
  double log_determinant() const { return log_determinant_; }          // of the covariance of y
  const Coefficients& mean() const { return beta_; }                   // of β
  const CoefficientMatrix& covariance() const { return covariance_; }  // of β

  // Of each look, given all of them.
  // Method:     Bryson and Frazier's backward pass, of y less what the columns explain; the columns pass along for the variances.
  std::vector<SmoothedLook> smoothed() const;

  // What a further series becomes in the filter: C^(-1/2) of it, C being the covariance of y at given β. 0 where nothing is seen.
  void whiten(std::span<const double> series, std::span<double> out) const;

  // A linear functional a'β + b(g) given all looks, b being known by its covariance with g at each of them and its variance.
  struct Functional {
    double mean, variance;
    Coefficients with_beta;  // covariance with β
  };
  Functional functional(const Coefficients& a, std::span<const double> covariance, double variance) const;

  // What y and the columns became in the filter, for scans over more columns.
  const Eigen::MatrixXd& whitened_columns() const { return white_; }  // first y, then the columns

 private:
  const Looks& looks_;
  std::variant<chain::Steps<1>, chain::Steps<2>, chain::Steps<3>, chain::Steps<4>> steps_;
  Eigen::MatrixXd white_;          // a column for y and each column, C^(-1/2) of it
  std::vector<double> predicted_;  // of the state at each look, series by series
  Coefficients beta_;
  CoefficientMatrix covariance_;
  double log_likelihood_ = 0;
  double log_determinant_ = 0;
};

}  // namespace flexslip
