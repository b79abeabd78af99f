// A linear Gaussian state-space model: a state that changes along a line and is observed with
// noise. The Kalman filter and smoother process several series at once.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/LU>

namespace flexslip {

// A state x of several `numbers`: x = mean ± covariance. Each series has its own mean; all have the
// same covariance.
template <int numbers, int series>
struct GaussianState {
  Eigen::Matrix<double, numbers, series> mean;
  Eigen::Matrix<double, numbers, numbers> covariance;
};

// The transition to the next point: x becomes A x + u, where u has mean 0.
template <int numbers>
struct Transition {
  Eigen::Matrix<double, numbers, numbers> matrix;  // A
  Eigen::Matrix<double, numbers, numbers> added;   // covariance of u
};

template <int numbers, int series>
GaussianState<numbers, series> predicted(const GaussianState<numbers, series>& state, const Transition<numbers>& to) {
  return {to.matrix * state.mean, to.matrix * state.covariance * to.matrix.transpose() + to.added};
}

// The result of an observation y = h'x + ε in each series.
template <int numbers, int series>
struct Update {
  GaussianState<numbers, series> state;         // given the observation
  Eigen::Matrix<double, 1, series> innovation;  // y minus its prediction
  double variance;                              // of the innovation
};

// Domain:     the variance of ε is >= 0, the variance of the innovation > 0.
// Method:     Joseph's form, which keeps the covariance positive even if a diffuse state becomes
//             nearly certain.
template <int numbers, int series>
Update<numbers, series> updated(const GaussianState<numbers, series>& prediction,
                                const Eigen::Matrix<double, numbers, 1>& h, const Eigen::Matrix<double, 1, series>& y,
                                double variance) {
  using Square = Eigen::Matrix<double, numbers, numbers>;
  const Eigen::Matrix<double, numbers, 1> covariance = prediction.covariance * h;  // of x with y
  const Eigen::Matrix<double, 1, series> innovation = y - h.transpose() * prediction.mean;
  const double total = h.dot(covariance) + variance;
  const Eigen::Matrix<double, numbers, 1> gain = covariance / total;
  const Square left = Square::Identity() - gain * h.transpose();
  return {{prediction.mean + gain * innovation,
           left * prediction.covariance * left.transpose() + variance * gain * gain.transpose()},
          innovation,
          total};
}

// One point on the line: the transition to it, and the state before and after its observation.
template <int numbers, int series>
struct FilterStep {
  Transition<numbers> from_before;  // unused at the first point
  GaussianState<numbers, series> prediction, state;
};

// The mean of the state at each point, given all observations.
// Domain:     the covariances of the predictions are regular.
// Method:     Rauch, Tung and Striebel (AIAA J. 3, 1965).
template <int numbers, int series>
std::vector<Eigen::Matrix<double, numbers, series>> rts_means(const std::vector<FilterStep<numbers, series>>& steps) {
  std::vector<Eigen::Matrix<double, numbers, series>> means(steps.size());
  for (std::size_t i = steps.size(); i-- > 0;) {
    means[i] = steps[i].state.mean;
    if (i + 1 == steps.size()) continue;
    const auto& [from_before, prediction, state] = steps[i + 1];
    means[i] += steps[i].state.covariance * from_before.matrix.transpose() * prediction.covariance.inverse() *
                (means[i + 1] - prediction.mean);
  }
  return means;
}

}  // namespace flexslip
