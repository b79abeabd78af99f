// What is known of a few numbers that change along a line and are seen through noise, for several series at once: a Kalman filter and its
// smoother.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace flexslip {

// A state x of so many numbers, of which each of the series has its own: x = mean ± covariance, the same covariance for all.
template <int numbers, int series>
struct KnownState {
  Eigen::Matrix<double, numbers, series> mean;
  Eigen::Matrix<double, numbers, numbers> covariance;
};

// From one place to the next: x becomes A x + u, u of mean 0.
template <int numbers>
struct StateStep {
  Eigen::Matrix<double, numbers, numbers> transition;  // A
  Eigen::Matrix<double, numbers, numbers> added;       // covariance of u
};

template <int numbers, int series>
KnownState<numbers, series> stepped(const KnownState<numbers, series>& known, const StateStep<numbers>& step) {
  return {step.transition * known.mean, step.transition * known.covariance * step.transition.transpose() + step.added};
}

// What a sight y = h'x + ε adds, for each of the series.
template <int numbers, int series>
struct Sight {
  KnownState<numbers, series> known;            // with it
  Eigen::Matrix<double, 1, series> innovation;  // y less what was expected
  double variance;                              // of the innovation
};

// Domain:     variance of ε >= 0, and that of the innovation > 0.
template <int numbers, int series>
Sight<numbers, series> seen(const KnownState<numbers, series>& expected, const Eigen::Matrix<double, numbers, 1>& h,
                            const Eigen::Matrix<double, 1, series>& y, double variance) {
  const Eigen::Matrix<double, numbers, 1> covariance = expected.covariance * h;  // of x with what is seen
  const Eigen::Matrix<double, 1, series> innovation = y - h.transpose() * expected.mean;
  const double total = h.dot(covariance) + variance;
  return {{expected.mean + covariance * innovation / total,
           expected.covariance - covariance * covariance.transpose() / total},
          innovation,
          total};
}

// A place passed: how the state came there, what was expected of it, and what was known with the sight there.
template <int numbers, int series>
struct PassedState {
  StateStep<numbers> step;  // from the place before; that of the first is not asked
  KnownState<numbers, series> expected, known;
};

// What is known of the state at each place with all sights, those after it, too.
// Domain:     covariances of what is expected regular.
// Max error:  1e-16 of the ratio of the greatest variance to the least, relative.
// Method:     Rauch, Tung and Striebel (AIAA J. 3, 1965).
template <int numbers, int series>
std::vector<KnownState<numbers, series>> smoothed(const std::vector<PassedState<numbers, series>>& passed) {
  std::vector<KnownState<numbers, series>> result(passed.size());
  for (std::size_t i = passed.size(); i-- > 0;) {
    result[i] = passed[i].known;
    if (i + 1 == passed.size()) continue;
    const auto& [step, expected, known] = passed[i + 1];
    const Eigen::Matrix<double, numbers, numbers> gain =
        result[i].covariance * step.transition.transpose() * expected.covariance.inverse();
    result[i].mean += gain * (result[i + 1].mean - expected.mean);
    result[i].covariance += gain * (result[i + 1].covariance - expected.covariance) * gain.transpose();
  }
  return result;
}

}  // namespace flexslip
