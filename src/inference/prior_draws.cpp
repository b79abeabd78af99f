#include "inference/prior_draws.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "numerics/elementary.h"

namespace flexslip {

using Eigen::Index;

namespace {

// The Cholesky factor of a covariance.
template <int G>
Square<G> root_of(Square<G> L, double roughness) {
  for (int i = 0; i < G; ++i) L(i, i) += 1e-14 * roughness * roughness;  // keeps variances positive despite rounding
  for (int k = 0; k < G; ++k) {
    double squares = 0;
    for (int j = 0; j < k; ++j) squares += L(k, j) * L(k, j);
    if (!(L(k, k) - squares > 0)) return {};
    L(k, k) = std::sqrt(L(k, k) - squares);
    for (int i = k + 1; i < G; ++i) {
      double products = 0;
      for (int j = 0; j < k; ++j) products += L(i, j) * L(k, j);
      L(i, k) = (L(i, k) - products) / L(k, k);
    }
  }
  return L;
}

}  // namespace

double NormalSource::operator()() {
  const auto uniform = [&] { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2 * elementary::log(uniform()));
  return radius * elementary::sine_and_cosine(2 * std::numbers::pi * uniform()).cosine;
}

PriorDraws::PriorDraws(const Observations& observations, Kernel kernel, const Hyperparameters& at)
    : observations_(observations), kernel_(kernel), at_(at) {
  require_domain(observations, kernel, at);
  matern::with_order_of(kernel, [&](auto order) {
    constexpr int G = decltype(order)::value;
    if constexpr (G > 0) {
      const double rate = matern::rate_of(kernel) / at.length;
      Square<G> limit = matern::stationary<G>();
      for (double& covariance : limit.at_) covariance *= at.roughness * at.roughness;
      const auto add = [&](const Square<G>& transition, const Square<G>& added) {
        const Square<G> root = root_of(added, at.roughness);
        steps_.insert(steps_.end(), transition.at_.begin(), transition.at_.end());
        steps_.insert(steps_.end(), root.at_.begin(), root.at_.end());
      };
      for (std::size_t k = 0; k < observations.all.size(); ++k) {
        if (k == 0) {
          add({}, limit);
          continue;
        }
        const double away = rate * (observations.all[k].place - observations.all[k - 1].place);
        const auto A = matern::transition_over<G>(away, elementary::exp(-away));
        Square<G> added = product(product(A, limit), transposed(A));
        for (std::size_t i = 0; i < added.at_.size(); ++i) added.at_[i] = limit.at_[i] - added.at_[i];
        add(A, added);
      }
    }
  });
}

Drawn PriorDraws::operator()(NormalSource& normal) const {
  const std::size_t n = observations_.all.size();
  Drawn drawn{.beta = Coefficients(static_cast<Index>(observations_.prior.size())),
              .f = std::vector<double>(n),
              .values = std::vector<double>(n)};
  for (std::size_t j = 0; j < observations_.prior.size(); ++j)
    drawn.beta[static_cast<Index>(j)] = std::sqrt(observations_.prior[j]) * normal();
  for (std::size_t k = 0; k < n; ++k) drawn.f[k] = observations_.columns[k].dot(drawn.beta);
  const auto G = static_cast<std::size_t>(matern::order_of(kernel_));
  std::array<double, 5> g{}, next{}, z{};
  double e = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Observation& observation = observations_.all[k];
    const double* const transition = steps_.data() + k * 2 * G * G;
    const double* const root = transition + G * G;
    for (std::size_t i = 0; i < G; ++i) z[i] = normal();
    for (std::size_t i = 0; i < G; ++i) {
      next[i] = 0;
      for (std::size_t j = 0; j < G; ++j) next[i] += transition[i * G + j] * g[j];
      for (std::size_t j = 0; j <= i; ++j) next[i] += root[i * G + j] * z[j];
    }
    g = next;
    if (k == 0) {
      e = at_.noise * normal();
    } else if (observation.rows > 0) {
      const double kept =
          at_.correlation > 0 ? elementary::exp(observation.rows * elementary::log(at_.correlation)) : 0;
      e = kept * e + std::sqrt(1 - kept * kept) * at_.noise * normal();
    }
    drawn.f[k] += g[0];
    drawn.values[k] = drawn.f[k] + observation.noise_gain * e +
                      (is_seen(observation) ? std::sqrt(observation.variance) * normal() : 0);
  }
  return drawn;
}

}  // namespace flexslip
