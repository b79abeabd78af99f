// A Gaussian process along the fibre as seen at many places (Observations): what they say of it, in time proportional to their number;
// its likelihood with gradient.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "inference/matern.h"
#include "inference/state_pairs.h"
#include "numerics/elementary.h"
#include "numerics/kept_array.h"

namespace flexslip {

// A Gaussian process along the fibre, seen at many places through autocorrelated noise.
//
// At place x_i the value y_i = h_i'β + g(x_i) + D_i e_i + ε_i is seen: h_i known, β ~ N(0, diag(prior)), g of a Matérn kernel, e an AR(1)
// process over the rows of the record with variance σ², ε_i ~ N(0, variance_i).

inline constexpr int max_columns = 16;

using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_columns, 1>;
using CoefficientMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_columns, max_columns>;

// One place where the process is seen.
struct Observation {
  double place;       // [L] x
  double rows;        // rows of the record since the last observation; 0 where this one is no reading
  double noise_gain;  // [L^2/EI] D; 0 where it is no reading
  double variance;    // [1] of ε; infinite where nothing is seen

  bool is_reading() const { return noise_gain != 0; }
};

struct Observations {
  std::vector<Observation> all;       // places not falling
  std::vector<double> values;         // [1] y
  std::vector<Coefficients> columns;  // h
  std::vector<double> prior;          // [1] variances of β
  Coefficients pull = {};             // what else is known of β: the slope of its logarithm; of no size: nothing
};

inline bool is_seen(const Observation& observation) { return observation.variance < infinity; }

// Domain of all that is given them: noise >= 0, 0 <= correlation < 1, roughness > 0 and length > 0 where there is a kernel, at most
// max_columns columns, all of one length: std::invalid_argument otherwise.
void require_domain(const Observations& observations, Kernel kernel, const Hyperparameters& at);

// What all observations together say of one.
struct SmoothedObservation {
  double f;         // [1] mean of h'β + g
  double variance;  // [1] of it, where it is no reading; NaN of readings
  double slope;     // [1/L] dg/dx of the mean of g; of an exponential kernel, which has none, the mean of both sides
  double e;         // [EI/L^2] mean of e
};

namespace chain {  // One step of the filter with a state of M numbers: g and its derivatives, each in units of the rate of the kernel, then e.
template <int M>
struct Step {
  std::array<double, 2 * M * pairs_of(M)> predicted;  // covariance before the observation, a StateMatrix
  Square<M - 1> of_g;                                 // transition to it from the observation before
  double of_e;
  Few<M> gain;
  double deviation, scale;  // of what the observation adds, and one over it; both 0 where nothing is seen
};
template <int M>
struct Steps {
  KeptArray<Step<M>> steps;
  double rate;  // [1/L] of the kernel
};
}  // namespace chain

// The likelihood of what is seen of a Gaussian process, with its gradient.
struct LikelihoodGradient {
  double value;                           // ln p(y)
  std::array<double, 4> hyperparameters;  // its derivatives to ln σ, ρ, ln σ_g and ln ℓ
  std::array<double, 2>
      log_wavelengths;  // and to ln λ of each wave: waves are the last pairs of columns, cos(2πx/λ) and sin(2πx/λ)
};

class Chain {
 public:
  // Domain:     as require_domain. Variances and priors > 0; the observations outlive this.
  // Method:     a Kalman filter whose state is g, its derivatives and e; the columns pass it as further series.
  // Cost:       linear in the observations and in the columns.
  Chain(const Observations& observations, Kernel kernel, const Hyperparameters& at);

  double log_likelihood() const { return log_likelihood_; }            // ln p(y), the pull left out
  const Coefficients& mean() const { return beta_; }                   // of β
  const CoefficientMatrix& covariance() const { return covariance_; }  // of β

  // Of each observation, given all of them.
  // Method:     Bryson and Frazier's backward pass, of y less what the columns explain; the columns pass along for the variances.
  std::vector<SmoothedObservation> smoothed() const;

  // What a further series becomes in the filter: C^(-1/2) of it, C being the covariance of y at given β. 0 where nothing is seen.
  void whiten(std::span<const double> series, std::span<double> out) const;

  // The same of eight series, a row of numbers for each observation, in a fraction of the time.
  using Eight = std::array<double, 8>;
  void whiten(std::span<const Eight> series, std::span<Eight> out) const;

  // The means of f at each observation, and of β, were these values seen there.
  struct Means {
    std::vector<double> f;  // [1]
    Coefficients beta;
  };
  Means means_of(std::span<const double> values) const;

  // A linear functional a'β + b(g) given all observations, b being known by its covariance with g at each of them and its variance.
  struct Functional {
    double mean, variance;
    Coefficients with_beta;  // covariance with β
  };
  Functional functional(const Coefficients& a, std::span<const double> covariance, double variance) const;

  // Of ln p(y). Domain: wavelengths: at most two [L], > 0.
  // Method:     the adjoint of the filter; exact up to rounding.
  LikelihoodGradient gradient(std::span<const double> wavelengths) const;

  // What y and the columns became in the filter, for scans over more columns: first the columns, then y.
  Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> whitened_columns() const {
    const auto series = 1 + static_cast<Eigen::Index>(observations_.prior.size());
    return {white_.data(), series, static_cast<Eigen::Index>(observations_.all.size()),
            Eigen::OuterStride<>(series + series % 2)};
  }

 private:
  template <int M>
  LikelihoodGradient gradient_of(const chain::Steps<M>& steps, std::span<const double> wavelengths) const;

  const Observations& observations_;
  Kernel kernel_;
  Hyperparameters at_;
  std::variant<chain::Steps<1>, chain::Steps<2>, chain::Steps<3>, chain::Steps<6>> steps_;
  KeptArray<double> white_;          // at each observation C^(-1/2) of y and of each column, by pairs
  KeptArray<double> predicted_;      // at each observation, for each pair of these the numbers of their states
  Coefficients beta_, by_readings_;  // of them: the mean, and that without the pull
  CoefficientMatrix covariance_;
  double log_likelihood_ = 0;
};

}  // namespace flexslip
