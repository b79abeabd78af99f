// A linear Gaussian state-space model of a few numbers that change along a line and are observed through noise, for several series at once: the Kalman
// filter and its smoother.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/LU>

namespace flexslip {

// A state x of so many numbers, of which each of the series has its own: x = mean ± covariance, the same covariance for all.
template <int numbers, int series>
struct GaussianState {
  Eigen::Matrix<double, numbers, series> mean;
  Eigen::Matrix<double, numbers, numbers> covariance;
};

// From one place to the next: x becomes A x + u, u of mean 0.
template <int numbers>
struct Transition {
  Eigen::Matrix<double, numbers, numbers> matrix;  // A
  Eigen::Matrix<double, numbers, numbers> added;   // covariance of u
};

template <int numbers, int series>
GaussianState<numbers, series> predicted(const GaussianState<numbers, series>& state, const Transition<numbers>& to) {
  return {to.matrix * state.mean, to.matrix * state.covariance * to.matrix.transpose() + to.added};
}

// What an observation y = h'x + ε tells, of each of the series.
template <int numbers, int series>
struct Update {
  GaussianState<numbers, series> state;         // with it
  Eigen::Matrix<double, 1, series> innovation;  // y less its prediction
  double variance;                              // of the innovation
};

// Domain:     variance of ε >= 0, and that of the innovation > 0.
// Method:     Joseph's form, whose covariance stays positive, however little is left of a diffuse state.
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

// A place on the line: how the state came there, what was expected of it, and what is known with the observation there.
template <int numbers, int series>
struct FilterStep {
  Transition<numbers> from_before;  // that of the first place is not asked
  GaussianState<numbers, series> prediction, state;
};

// The mean of the state at each place, given all observations, those after it, too.
// Domain:     covariances of the predictions regular.
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
