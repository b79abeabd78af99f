#include "inference/mirror.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fibre/elementary.h"

namespace flexslip::loops {
namespace {

struct Information {
  Eigen::Matrix4d gram = Eigen::Matrix4d::Zero();
  double log_determinant = 0;
};

// The differences in - out at the places of a loop and their regressors, whitened: an Ornstein-Uhlenbeck process seen through
// noise, by a Kalman filter along S.
Information whiten(const Pairs& places, const Noise& noise) {
  Information information;
  const double power = noise.difference * noise.difference;
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  double variance = power;
  for (std::size_t i = 0; i < places.S.size(); ++i) {
    if (i > 0) {
      const double decay = elementary::exp(-(places.S[i] - places.S[i - 1]) / noise.length);
      mean *= decay;
      variance = decay * decay * variance + power * (1 - decay * decay);
    }
    const double total = variance + noise.force * noise.force * places.noise_of_unit[i] + least_noise * least_noise;
    const auto& in = places.in_slopes[i];
    const auto& out = places.out_slopes[i];
    const Eigen::Vector4d y(places.in[i] - places.out[i], out[0] - in[0], out[1] - in[1], 1);
    const Eigen::Vector4d innovation = y - mean;
    information.gram.noalias() += innovation * innovation.transpose() / total;
    information.log_determinant += elementary::log(total);
    mean += variance / total * innovation;
    variance -= variance * variance / total;
  }
  return information;
}

}  // namespace

NormalStep Estimator::estimate(const Noise& noise, Eigen::Index differences) const {
  const auto contacts = static_cast<Eigen::Index>(calibration_.contact.size());
  const Eigen::Index n = 1 + contacts + differences;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  double squares = 0, log_determinant = 0;
  for (const auto& mirror : mirrors_) {
    const auto information = whiten(mirror.places, noise);
    const std::array<Eigen::Index, 3> at{0, 1 + static_cast<Eigen::Index>(mirror.column), 1 + contacts};
    const Eigen::Index used = 2 + differences;
    for (Eigen::Index i = 0; i < used; ++i) {
      b[at[static_cast<std::size_t>(i)]] += information.gram(0, i + 1);
      for (Eigen::Index j = 0; j < used; ++j)
        A(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]) += information.gram(i + 1, j + 1);
    }
    squares += information.gram(0, 0);
    log_determinant += information.log_determinant;
  }
  const auto add_prior = [&](Eigen::Index i, double value, double deviation) {
    A(i, i) += 1 / (deviation * deviation);
    b[i] -= value / (deviation * deviation);
    squares += value * value / (deviation * deviation);
  };
  add_prior(0, calibration_.log_stiffness, options_.stiffness_error);
  for (Eigen::Index i = 0; i < contacts; ++i)
    add_prior(1 + i, calibration_.contact[static_cast<std::size_t>(i)], options_.contact_error);
  if (differences > 0) add_prior(1 + contacts, 0, 1);  // a mean difference beyond 1 is none of friction
  const Eigen::LDLT<Eigen::MatrixXd> factors(A);
  NormalStep result{.step = factors.solve(b), .covariance = {}, .objective = 0};
  result.covariance = factors.solve(Eigen::MatrixXd::Identity(n, n));
  for (Eigen::Index i = 0; i < n; ++i) log_determinant += elementary::log(std::abs(factors.vectorD()[i]));
  result.objective = log_determinant + squares - b.dot(result.step);
  return result;
}

Noise likely_noise(const Estimator& estimator, const Noise& start, double reading, double shortest, double longest) {
  const std::array<double, 3> low{elementary::log(reading + 1e-12), elementary::log(1e-5), elementary::log(shortest)};
  const std::array<double, 3> high{elementary::log(1e2 * reading + 1e-9), elementary::log(2.0),
                                   elementary::log(longest)};
  std::array<double, 3> at{elementary::log(start.force + 1e-11), elementary::log(start.difference),
                           elementary::log(start.length)};
  const auto noise_at = [](const std::array<double, 3>& x) {
    return Noise{elementary::exp(x[0]), elementary::exp(x[1]), elementary::exp(x[2])};
  };
  for (std::size_t i = 0; i < 3; ++i) at[i] = std::clamp(at[i], low[i], high[i]);
  double best = estimator.estimate(noise_at(at), 0).objective;
  std::array<double, 3> step{0.5, 0.8, 0.8};
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (std::size_t i = 0; i < 3; ++i) {
      bool moved = false;
      for (const double sign : {1.0, -1.0}) {
        auto trial = at;
        trial[i] = std::clamp(at[i] + sign * step[i], low[i], high[i]);
        if (trial[i] == at[i]) continue;
        const double objective = estimator.estimate(noise_at(trial), 0).objective;
        if (!(objective < best)) continue;
        best = objective;
        at = trial;
        step[i] *= sign;  // go on this way first
        moved = true;
        break;
      }
      step[i] *= moved ? 1.4 : 0.4;
    }
    if (std::all_of(step.begin(), step.end(), [](double s) { return std::abs(s) < 0.05; })) break;
  }
  return noise_at(at);
}

}  // namespace flexslip::loops
