// The likelihood and posterior of a Gaussian process along the specimen, observed through
// autocorrelated noise. Cost: proportional to the number of observations.
//
// The place x of a point is its distance from the middle of the observed length, in spans: x = (S -
// S_middle)/2, so that λ is the period in x.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "inference/kernel.h"
#include "numerics/elementary.h"
#include "numerics/few.h"
#include "numerics/kept_array.h"

namespace flexslip {

// Observations of a process.
//
// At place x_i the value y_i = h_i'β + g(x_i) + D_i e_i + ε_i is observed: h_i known, β ~ N(0,
// diag(prior)), g of a Matérn kernel, e an AR(1) process over the rows of the record with variance
// σ², ε_i ~ N(0, variance_i).

inline constexpr int max_columns = 16;

using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_columns, 1>;
using CoefficientMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_columns, max_columns>;

// One observation.
struct Observation {
  double place;       // [L] x
  double rows;        // rows of the record since the last reading; 0 if this is no reading
  double noise_gain;  // [L^2/EI] D; 0 if this is no reading
  double variance;    // [1] of ε; infinite if nothing is observed

  bool is_reading() const { return noise_gain != 0; }
};

struct Observations {
  std::vector<Observation> all;       // in the order of their places
  std::vector<double> values;         // [1] y
  std::vector<Coefficients> columns;  // h
  std::vector<double> prior;          // [1] variances of β
  Coefficients pull = {};             // gradient of the logarithm of a further likelihood of β; size 0: none
};

inline bool is_seen(const Observation& observation) { return observation.variance < infinity; }

// Throws std::invalid_argument unless noise >= 0, 0 <= correlation < 1, roughness > 0 and length >
// 0 where there is a kernel, and there are at most max_columns columns, all of one length.
void require_domain(const Observations& observations, Kernel kernel, const Hyperparameters& at);

// The posterior of one observation given all of them.
struct SmoothedObservation {
  double f;         // [1] mean of h'β + g
  double variance;  // [1] of f; NaN for a reading
  double slope;     // [1/L] dg/dx of the mean of g; for an exponential kernel, the mean of both one-sided slopes
  double e;         // [EI/L^2] mean of e
};

namespace chain {
// N series that the filter processes together.
template <int N>
using Series = std::array<double, static_cast<std::size_t>(N)>;
// Their states of M numbers each: g and its derivatives, each in units of the rate of the kernel,
// then e.
template <int M, int N>
using States = std::array<Series<N>, static_cast<std::size_t>(M)>;
inline constexpr int max_series = max_columns + 2;  // the columns and y; even, for vector instructions

// The transition of the state from one observation to the next, for g with its derivatives and for
// e.
template <int M>
struct Transition {
  Square<M - 1> of_g;
  double of_e;
};

// One step of the filter.
template <int M>
struct Step {
  Transition<M> transition;      // from the previous observation
  States<M, M> predicted;        // covariance of the state before the observation
  States<M, max_series> series;  // predicted states of the columns and of y
  Few<M> gain;
  double scale;  // 1 / standard deviation of the innovation; 0 if nothing is observed
};
template <int M>
struct Steps {
  KeptArray<Step<M>> steps;
  double rate;  // [1/L] of the kernel
};
}  // namespace chain

// The likelihood of the observations, with its gradient.
struct LikelihoodGradient {
  double value;                           // ln p(y)
  std::array<double, 4> hyperparameters;  // derivatives with respect to ln σ, ρ, ln σ_g and ln ℓ
  std::array<double, 2> log_wavelengths;  // and to ln λ of each wave, whose columns cos(2πx/λ) and sin(2πx/λ) come last
};

class Chain {
 public:
  // Domain:     as require_domain; variances and priors > 0. The observations must outlive the
  //             chain.
  // Method:     a Kalman filter whose state is g, its derivatives and e; the columns are further
  //             series.
  // Cost:       linear in the observations and in the columns.
  Chain(const Observations& observations, Kernel kernel, const Hyperparameters& at);

  double log_likelihood() const { return log_likelihood_; }            // ln p(y), without the pull
  const Coefficients& mean() const { return beta_; }                   // of β
  const CoefficientMatrix& covariance() const { return covariance_; }  // of β

  // The posterior of each observation.
  // Method:     Bryson and Frazier's backward pass over the residuals of y, and over the columns
  //             for the variances.
  std::vector<SmoothedObservation> smoothed() const;

  // C^(-1/2) times a further series, with C the covariance of y at given β; 0 if nothing is
  // observed.
  void whiten(std::span<const double> series, std::span<double> out) const;

  // The same for eight series at once, in a fraction of the time.
  using Eight = std::array<double, 8>;
  void whiten(std::span<const Eight> series, std::span<Eight> out) const;

  // The means of f at each observation and of β for other values of y.
  struct Means {
    std::vector<double> f;  // [1]
    Coefficients beta;
  };
  Means means_of(std::span<const double> values) const;

  // The posterior of a linear functional a'β + b(g). b is given by its covariance with g at each
  // observation and its variance.
  struct Functional {
    double mean, variance;
    Coefficients with_beta;  // covariance with β
  };
  Functional functional(const Coefficients& a, std::span<const double> covariance, double variance) const;

  // Domain:     at most two wavelengths [L], > 0.
  // Method:     the adjoint of the filter; exact up to rounding.
  LikelihoodGradient gradient(std::span<const double> wavelengths) const;

  // The standardised innovations of the columns and of y, in this order, for scans over further
  // columns.
  Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> whitened_columns() const {
    return {white_.data()->data(), static_cast<Eigen::Index>(observations_.prior.size() + 1),
            static_cast<Eigen::Index>(observations_.all.size()), Eigen::OuterStride<>(chain::max_series)};
  }

 private:
  template <int M>
  LikelihoodGradient gradient_of(const chain::Steps<M>& steps, std::span<const double> wavelengths) const;

  const Observations& observations_;
  Kernel kernel_;
  Hyperparameters at_;
  std::variant<chain::Steps<1>, chain::Steps<2>, chain::Steps<3>, chain::Steps<6>> steps_;
  KeptArray<chain::Series<chain::max_series>> white_;  // the innovations of all series
  Coefficients beta_, by_readings_;                    // mean of β with and without the pull
  CoefficientMatrix covariance_;
  double log_likelihood_ = 0;
};

}  // namespace flexslip
