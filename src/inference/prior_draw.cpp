#include "inference/prior_draw.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "fibre/elementary.h"
#include "inference/state_filter-inl.h"

namespace flexslip {
namespace {

// The process drawn beforehand, at given β: g and e at each look.
template <int M>
void draw_states(const Looks& looks, const Parameters<double>& p, NormalSource& normal, Drawn& drawn) {
  constexpr int G = M - 1;
  constexpr int size = G > 0 ? G : 1;
  using Matrix = Square<size, double>;
  Matrix limit{};
  if constexpr (G > 0) {
    constexpr auto P = matern::stationary<G>();
    for (int i = 0; i < G; ++i)
      for (int j = 0; j < G; ++j) limit(i, j) = p.roughness * p.roughness * P(i, j);
  }
  const auto some = [&](const Matrix& covariance) {
    Few<size> z, out{};
    for (double& value : z) value = normal();
    Matrix L = covariance;  // whose lower triangle Cholesky's becomes
    for (int i = 0; i < size; ++i) L(i, i) += 1e-14 * p.roughness * p.roughness;  // rounding makes no variance negative
    for (int k = 0; k < size; ++k) {
      double squares = 0;
      for (int j = 0; j < k; ++j) squares += L(k, j) * L(k, j);
      if (!(L(k, k) - squares > 0)) return Few<size>{};
      L(k, k) = std::sqrt(L(k, k) - squares);
      for (int i = k + 1; i < size; ++i) {
        double products = 0;
        for (int j = 0; j < k; ++j) products += L(i, j) * L(k, j);
        L(i, k) = (L(i, k) - products) / L(k, k);
      }
    }
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j) out[static_cast<std::size_t>(i)] += L(i, j) * z[static_cast<std::size_t>(j)];
    return out;
  };
  Few<size> g = G > 0 ? some(limit) : Few<size>{};
  double e = p.noise * normal();
  for (std::size_t k = 0; k < looks.looks.size(); ++k) {
    const Look& look = looks.looks[k];
    if (k > 0) {
      if constexpr (G > 0) {
        const Matrix A = matern::transition_over<G, double>(p.rate * (look.place - looks.looks[k - 1].place));
        Matrix added = product(product(A, limit), transposed(A));
        for (std::size_t i = 0; i < added.at_.size(); ++i) added.at_[i] = limit.at_[i] - added.at_[i];
        g = product(A, g);
        const auto more = some(added);
        for (std::size_t i = 0; i < size; ++i) g[i] += more[i];
      }
      if (look.rows > 0) {
        const double kept = p.correlation > 0 ? elementary::exp(look.rows * elementary::log(p.correlation)) : 0;
        e = kept * e + std::sqrt(1 - kept * kept) * p.noise * normal();
      }
    }
    drawn.f[k] += g[0];
    drawn.values[k] = drawn.f[k] + look.noise_gain * e + (is_seen(look) ? std::sqrt(look.variance) * normal() : 0);
  }
}

}  // namespace

double NormalSource::operator()() {
  const auto uniform = [&] { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2 * elementary::log(uniform()));
  return radius * elementary::sine_and_cosine(2 * std::numbers::pi * uniform()).cosine;
}

Drawn draw_from_prior(const Looks& looks, Kernel kernel, const Hyperparameters& at, NormalSource& normal) {
  require_domain(looks, kernel, at);
  const std::size_t n = looks.looks.size();
  Drawn drawn{.beta = Coefficients(static_cast<Index>(looks.prior.size())),
              .f = std::vector<double>(n),
              .values = std::vector<double>(n)};
  for (std::size_t j = 0; j < looks.prior.size(); ++j)
    drawn.beta[static_cast<Index>(j)] = std::sqrt(looks.prior[j]) * normal();
  for (std::size_t k = 0; k < n; ++k) drawn.f[k] = looks.columns[k].dot(drawn.beta);
  with_state_of<void>(kernel,
                      [&](auto M) { draw_states<decltype(M)::value>(looks, numbers_of(kernel, at), normal, drawn); });
  return drawn;
}

}  // namespace flexslip
