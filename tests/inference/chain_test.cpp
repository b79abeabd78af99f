#include "inference/chain.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Dense>
#include <doctest/doctest.h>

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double wavelength = 0.013;

// Forty readings and some nodes between them, unevenly spaced, with four columns and a wave.
Observations some_observations(std::uint64_t seed, bool gaps) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Observations observations;
  double place = -0.05;
  for (int i = 0; i < 40; ++i) {
    place += 0.004 * uniform() * uniform();
    const bool node = i % 7 == 3;
    const bool unseen = gaps && i % 11 == 5;
    observations.all.push_back({.place = place,
                                .rows = node         ? 0.0
                                        : i % 5 == 0 ? 3.0
                                                     : 1.0,
                                .noise_gain = node || unseen ? 0 : 0.3 + uniform(),
                                .variance = unseen ? std::numeric_limits<double>::infinity()
                                            : node ? 0.003
                                                   : 4e-6});
    observations.values.push_back(uniform() - 0.5);
    Coefficients h(5);
    const double phase = 2 * std::numbers::pi * place / wavelength;
    h << 1, place / 0.1, uniform(), std::cos(phase), std::sin(phase);
    observations.columns.push_back(h);
  }
  observations.prior = {0.25, 0.04, 0.0009, 0.0064, 0.0064};
  return observations;
}

constexpr Hyperparameters some_hyperparameters{.noise = 0.04, .correlation = 0.4, .roughness = 0.07, .length = 0.006};

double covariance_of(Kernel kernel, const Hyperparameters& at, double distance) {
  const double variance = at.roughness * at.roughness;
  const double r = std::abs(distance) / at.length;
  switch (kernel) {
    case Kernel::none:
      return 0;
    case Kernel::exponential:
      return variance * std::exp(-r);
    case Kernel::matern_3_2:
      return variance * (1 + std::sqrt(3.0) * r) * std::exp(-std::sqrt(3.0) * r);
    case Kernel::matern_9_2:
      break;
  }
  const double a = 3 * r;
  return variance * (1 + a + 3 * a * a / 7 + 2 * a * a * a / 21 + a * a * a * a / 105) * std::exp(-a);
}

// The same by dense matrices: nothing of the filter is in it.
struct Dense {
  std::vector<Index> seen;
  MatrixXd H, g_with_seen, e_with_seen, C;
  VectorXd y;
  double log_likelihood;

  Dense(const Observations& observations, Kernel kernel, const Hyperparameters& at) {
    const auto n = static_cast<Index>(observations.all.size());
    for (Index i = 0; i < n; ++i)
      if (std::isfinite(observations.all[static_cast<std::size_t>(i)].variance)) seen.push_back(i);
    H.resize(n, static_cast<Index>(observations.prior.size()));
    MatrixXd K(n, n), E(n, n);
    VectorXd rows = VectorXd::Zero(n), D(n), value(n), variance(n);
    for (Index i = 0; i < n; ++i) {
      const auto& observation = observations.all[static_cast<std::size_t>(i)];
      H.row(i) = observations.columns[static_cast<std::size_t>(i)].transpose();
      rows[i] = (i > 0 ? rows[i - 1] : 0) + (i > 0 ? observation.rows : 0);
      D[i] = observation.noise_gain;
      value[i] = observations.values[static_cast<std::size_t>(i)];
      variance[i] = observation.variance;
    }
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) {
        K(i, j) = covariance_of(
            kernel, at,
            observations.all[static_cast<std::size_t>(i)].place - observations.all[static_cast<std::size_t>(j)].place);
        E(i, j) = at.noise * at.noise * std::pow(at.correlation, std::abs(rows[i] - rows[j]));
      }
    VectorXd prior(H.cols());
    for (Index j = 0; j < H.cols(); ++j) prior[j] = observations.prior[static_cast<std::size_t>(j)];
    const MatrixXd F = K + H * prior.asDiagonal() * H.transpose();
    const MatrixXd all = F + D.asDiagonal() * E * D.asDiagonal();
    C = all(seen, seen);
    for (std::size_t i = 0; i < seen.size(); ++i) C(static_cast<Index>(i), static_cast<Index>(i)) += variance[seen[i]];
    y = value(seen);
    g_with_seen = F(Eigen::all, seen);
    e_with_seen = (E * D.asDiagonal())(Eigen::all, seen);
    f_ = F;
    const Eigen::LLT<MatrixXd> factor(C);
    const double log_determinant = 2 * MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    log_likelihood = -0.5 * (y.dot(factor.solve(y)) + log_determinant +
                             static_cast<double>(seen.size()) * std::log(2 * std::numbers::pi));
  }
  VectorXd f() const { return g_with_seen * C.llt().solve(y); }
  VectorXd e() const { return e_with_seen * C.llt().solve(y); }
  VectorXd variance() const { return (f_ - g_with_seen * C.llt().solve(g_with_seen.transpose())).diagonal(); }

 private:
  MatrixXd f_;
};

}  // namespace

TEST_CASE("identity: products are cut by Eigen's own sizes, and so alike on every processor whatever its caches") {
  CHECK(Eigen::l1CacheSize() == Eigen::internal::defaultL1CacheSize);
  CHECK(Eigen::l2CacheSize() == Eigen::internal::defaultL2CacheSize);
  CHECK(Eigen::l3CacheSize() == Eigen::internal::defaultL3CacheSize);
}

TEST_CASE("oracle: likelihood, means and variances of a chain are those of dense matrices") {
  for (const Kernel kernel : all_kernels)
    for (const bool gaps : {false, true}) {
      CAPTURE(name_of(kernel));
      const Observations observations = some_observations(7, gaps);
      const Dense dense(observations, kernel, some_hyperparameters);
      const Chain chain(observations, kernel, some_hyperparameters);
      // The dense factorisation loses the condition number of C, some 1e4, in rounding.
      constexpr double rounding = 1e-10;
      CHECK(chain.log_likelihood() == doctest::Approx(dense.log_likelihood).epsilon(rounding));
      const VectorXd f = dense.f(), e = dense.e(), variance = dense.variance();
      const auto smoothed = chain.smoothed();
      for (Index i = 0; i < f.size(); ++i) {
        CAPTURE(i);
        const auto& observation = smoothed[static_cast<std::size_t>(i)];
        CHECK(std::abs(observation.f - f[i]) < rounding);
        CHECK(std::abs(observation.e - e[i]) < rounding);
        CHECK(observations.all[static_cast<std::size_t>(i)].is_reading() == std::isnan(observation.variance));
        if (!std::isnan(observation.variance)) CHECK(std::abs(observation.variance - variance[i]) < rounding);
      }
    }
}

TEST_CASE("oracle: derivatives of the likelihood are its differences") {
  for (const Kernel kernel : all_kernels) {
    CAPTURE(name_of(kernel));
    const Observations observations = some_observations(3, false);
    const auto at = [&](double noise, double correlation, double roughness, double length, double lambda) {
      Observations changed = observations;
      for (std::size_t i = 0; i < observations.all.size(); ++i) {
        const double phase = 2 * std::numbers::pi * observations.all[i].place / (wavelength * std::exp(lambda));
        changed.columns[i][3] = std::cos(phase);
        changed.columns[i][4] = std::sin(phase);
      }
      const Hyperparameters p{.noise = some_hyperparameters.noise * std::exp(noise),
                              .correlation = some_hyperparameters.correlation + correlation,
                              .roughness = some_hyperparameters.roughness * std::exp(roughness),
                              .length = some_hyperparameters.length * std::exp(length)};
      return Chain(changed, kernel, p).log_likelihood();
    };
    const std::array<double, 1> lambdas{wavelength};
    const auto gradient = Chain(observations, kernel, some_hyperparameters).gradient(lambdas);
    CHECK(gradient.value == doctest::Approx(at(0, 0, 0, 0, 0)).epsilon(1e-13));
    constexpr double h = 1e-4;
    constexpr double truncation = 1e-5;  // h^2 times third derivatives of some 1e2 to 1e3
    const auto close = [&](double exact, double up, double down) {
      CHECK(exact == doctest::Approx((up - down) / (2 * h)).epsilon(truncation).scale(1));
    };
    close(gradient.hyperparameters[0], at(h, 0, 0, 0, 0), at(-h, 0, 0, 0, 0));
    close(gradient.hyperparameters[1], at(0, h, 0, 0, 0), at(0, -h, 0, 0, 0));
    if (kernel != Kernel::none) {
      close(gradient.hyperparameters[2], at(0, 0, h, 0, 0), at(0, 0, -h, 0, 0));
      close(gradient.hyperparameters[3], at(0, 0, 0, h, 0), at(0, 0, 0, -h, 0));
    }
    close(gradient.log_wavelengths[0], at(0, 0, 0, 0, h), at(0, 0, 0, 0, -h));
  }
}

TEST_CASE("oracle: the slope of a chain is the difference of its means at places where nothing is seen") {
  for (const Kernel kernel : {Kernel::exponential, Kernel::matern_3_2}) {
    CAPTURE(name_of(kernel));
    const Observations observations = some_observations(5, false);
    constexpr double h = 1e-6;
    Observations around;
    around.prior = observations.prior;
    for (std::size_t i = 0; i < observations.all.size(); ++i)
      for (const double away : {-h, 0.0, h}) {
        Observation observation = observations.all[i];
        observation.place += away;
        if (away != 0)
          observation = {.place = observation.place,
                         .rows = 0,
                         .noise_gain = 0,
                         .variance = std::numeric_limits<double>::infinity()};
        around.all.push_back(observation);
        around.values.push_back(observations.values[i]);
        around.columns.push_back(observations.columns[i]);  // of f, so that only g has a slope
      }
    const auto smoothed = Chain(observations, kernel, some_hyperparameters).smoothed();
    const auto beside = Chain(around, kernel, some_hyperparameters).smoothed();
    for (std::size_t i = 1; i + 1 < smoothed.size(); ++i) {
      CAPTURE(i);
      const double difference = (beside[3 * i + 2].f - beside[3 * i].f) / (2 * h);
      constexpr double truncation =
          2e-3;  // h times a second derivative of some 1e5 at an observation, in slopes of some 1e1
      CHECK(smoothed[i].slope == doctest::Approx(difference).epsilon(truncation).scale(1));
    }
  }
}

TEST_CASE("identity: a functional that is the process at an observation is that observation") {
  for (const Kernel kernel : all_kernels) {
    const Observations observations = some_observations(11, true);
    const Chain chain(observations, kernel, some_hyperparameters);
    const auto smoothed = chain.smoothed();
    for (const std::size_t i : {0, 5, 20, 39}) {
      std::vector<double> covariance;
      for (const auto& observation : observations.all)
        covariance.push_back(
            covariance_of(kernel, some_hyperparameters, observation.place - observations.all[i].place));
      const auto f = chain.functional(observations.columns[i], covariance, covariance[i]);
      constexpr double rounding = 1e-11;
      CHECK(std::abs(f.mean - smoothed[i].f) < rounding);
      if (!observations.all[i].is_reading()) CHECK(std::abs(f.variance - smoothed[i].variance) < rounding);
    }
  }
}

TEST_CASE(
    "identity: means of other values are those of a chain of these; eight series become what each becomes alone") {
  for (const Kernel kernel : all_kernels) {
    Observations observations = some_observations(5, true);
    observations.pull = Coefficients::Constant(5, 0.7);
    const Chain chain(observations, kernel, some_hyperparameters);
    Observations others = observations;
    const std::size_t n = others.values.size();
    std::vector<Chain::Eight> series(n), together(n);
    for (std::size_t k = 0; k < n; ++k) {
      others.values[k] = std::sin(0.3 * static_cast<double>(k * k));
      for (std::size_t l = 0; l < 8; ++l) series[k][l] = std::cos(static_cast<double>((l + 1) * k));
    }
    const auto means = chain.means_of(others.values);
    const Chain of_others(others, kernel, some_hyperparameters);
    const auto smoothed = of_others.smoothed();
    CHECK((means.beta - of_others.mean()).norm() < 1e-12);
    for (std::size_t k = 0; k < n; ++k) CHECK(std::abs(means.f[k] - smoothed[k].f) < 1e-11);
    chain.whiten(series, together);
    std::vector<double> one(n), alone(n);
    for (std::size_t l = 0; l < 8; ++l) {
      for (std::size_t k = 0; k < n; ++k) one[k] = series[k][l];
      chain.whiten(one, alone);
      for (std::size_t k = 0; k < n; ++k) CHECK(std::abs(together[k][l] - alone[k]) < 1e-11 * (1 + std::abs(alone[k])));
    }
  }
}

TEST_CASE("limit: a chain refuses what is no process") {
  const Observations observations = some_observations(1, false);
  Hyperparameters wrong = some_hyperparameters;
  wrong.correlation = 1;
  CHECK_THROWS_AS(Chain(observations, Kernel::matern_3_2, wrong), std::invalid_argument);
  wrong = some_hyperparameters;
  wrong.length = 0;
  CHECK_THROWS_AS(Chain(observations, Kernel::matern_3_2, wrong), std::invalid_argument);
  CHECK_NOTHROW(Chain(observations, Kernel::none, wrong));
}

}  // namespace flexslip
