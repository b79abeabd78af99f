#include "numerics/state_space.h"

#include <cmath>
#include <random>

#include <doctest/doctest.h>

namespace flexslip {
namespace {

// A random walk and an Ornstein-Uhlenbeck process, seen together in changing shares by two series.
struct Sights {
  std::vector<double> place;
  std::vector<Eigen::Vector2d> h;
  std::vector<Eigen::RowVector2d> y;
  double variance = 0.04;
};

constexpr double first_variance = 9, roughness = 0.5, power = 0.25, length = 0.8;

Sights some_sights() {
  Sights sights;
  std::mt19937_64 generator(11);
  std::normal_distribution<double> normal;
  double place = 0;
  for (int i = 0; i < 12; ++i) {
    place += 0.1 + 0.3 * std::abs(normal(generator));
    sights.place.push_back(place);
    sights.h.emplace_back(1, i % 3 == 0 ? -0.5 : 0.5);
    sights.y.emplace_back(normal(generator), i);
  }
  return sights;
}

// Both processes at all places, by their joint normal distribution with what is seen: without a filter.
struct Joint {
  Eigen::MatrixXd states;  // covariance, 2n x 2n
  Eigen::MatrixXd H;       // n x 2n
  Eigen::MatrixXd y;       // n x 2

  explicit Joint(const Sights& sights) {
    const auto n = static_cast<Eigen::Index>(sights.place.size());
    states = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    H = Eigen::MatrixXd::Zero(n, 2 * n);
    y.resize(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double at = sights.place[static_cast<std::size_t>(i)];
      H.row(i).segment(2 * i, 2) = sights.h[static_cast<std::size_t>(i)].transpose();
      y.row(i) = sights.y[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < n; ++j) {
        const double other = sights.place[static_cast<std::size_t>(j)];
        states(2 * i, 2 * j) = first_variance + roughness * (std::min(at, other) - sights.place.front());
        states(2 * i + 1, 2 * j + 1) = power * std::exp(-std::abs(at - other) / length);
      }
    }
  }
};

std::vector<FilterStep<2, 2>> passed(const Sights& sights, Eigen::RowVector2d& squares, double& log_determinant) {
  std::vector<FilterStep<2, 2>> steps;
  for (std::size_t i = 0; i < sights.place.size(); ++i) {
    FilterStep<2, 2> here;
    if (i == 0) {
      here.from_before = {Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Zero()};
      here.prediction.mean.setZero();
      here.prediction.covariance = Eigen::Vector2d(first_variance, power).asDiagonal();
    } else {
      const double distance = sights.place[i] - sights.place[i - 1], decay = std::exp(-distance / length);
      here.from_before.matrix = Eigen::Vector2d(1, decay).asDiagonal();
      here.from_before.added = Eigen::Vector2d(roughness * distance, power * (1 - decay * decay)).asDiagonal();
      here.prediction = predicted(steps.back().state, here.from_before);
    }
    const auto update = updated(here.prediction, sights.h[i], sights.y[i], sights.variance);
    squares += update.innovation.cwiseAbs2() / update.variance;
    log_determinant += std::log(update.variance);
    here.state = update.state;
    steps.push_back(here);
  }
  return steps;
}

}  // namespace

TEST_CASE("oracle: filter and smoother agree with the joint normal distribution of all points") {
  const Sights sights = some_sights();
  const Joint joint(sights);
  Eigen::RowVector2d squares = Eigen::RowVector2d::Zero();
  double log_determinant = 0;
  const auto steps = passed(sights, squares, log_determinant);
  const auto means = rts_means(steps);

  const Eigen::Index n = joint.y.rows();
  const Eigen::MatrixXd C =
      joint.H * joint.states * joint.H.transpose() + sights.variance * Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd gain = joint.states * joint.H.transpose() * C.inverse();
  const Eigen::MatrixXd mean = gain * joint.y;
  // Rounding: 1e-16 times 9/0.04, the ratio of variances, and some for the inverse of a matrix of 12.
  constexpr double rounding = 1e-12;
  const Eigen::Matrix2d covariance = (joint.states - gain * joint.H * joint.states).bottomRightCorner<2, 2>();
  CHECK((steps.back().state.covariance - covariance).cwiseAbs().maxCoeff() < rounding);  // of the last place
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& here = means[static_cast<std::size_t>(i)];
    CHECK((here - mean.middleRows(2 * i, 2)).cwiseAbs().maxCoeff() < rounding * 12);
  }
  CHECK(std::abs(log_determinant - std::log(C.determinant())) < rounding * 12);
  for (Eigen::Index series = 0; series < 2; ++series) {
    const double expected = joint.y.col(series).dot(C.inverse() * joint.y.col(series));
    CHECK(squares[series] == doctest::Approx(expected).epsilon(rounding));
  }
}

TEST_CASE("limit: an observation without noise is exact, and infinite noise carries no information") {
  const GaussianState<1, 1> expected{Eigen::Matrix<double, 1, 1>(2.0), Eigen::Matrix<double, 1, 1>(0.25)};
  const Eigen::Matrix<double, 1, 1> h(1.0), y(3.0);
  const auto sharp = updated(expected, h, y, 0);
  CHECK(sharp.state.mean(0, 0) == 3);
  CHECK(sharp.state.covariance(0, 0) == 0);
  const auto blind = updated(expected, h, y, 1e300);
  CHECK(blind.state.mean(0, 0) == 2);
  CHECK(blind.state.covariance(0, 0) == 0.25);
}

TEST_CASE("limit: a diffuse state observed with very little noise keeps the variance of the noise") {
  const GaussianState<2, 1> diffuse{Eigen::Vector2d::Zero(), Eigen::Vector2d(1e4, 1e-4).asDiagonal()};
  constexpr double variance = 1e-18;
  auto update = updated(diffuse, Eigen::Vector2d(1, 0.5), Eigen::Matrix<double, 1, 1>(0.3), variance);
  for (int i = 0; i < 20; ++i)
    update =
        updated(update.state, Eigen::Vector2d(1, i % 2 == 0 ? -0.5 : 0.5), Eigen::Matrix<double, 1, 1>(0.3), variance);
  CHECK(update.state.covariance(0, 0) >= 0);
  CHECK(update.state.covariance(1, 1) >= 0);
  CHECK(std::abs(update.state.mean(0, 0) - 0.3) < 1e-8);
}

}  // namespace flexslip
