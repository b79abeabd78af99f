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
  using Matrix = Eigen::Matrix<double, (G > 0 ? G : 1), (G > 0 ? G : 1)>;
  using Vector = Eigen::Matrix<double, (G > 0 ? G : 1), 1>;
  Matrix limit = Matrix::Zero();
  if constexpr (G > 0) {
    constexpr auto P = matern::stationary<G>();
    for (int i = 0; i < G; ++i)
      for (int j = 0; j < G; ++j) limit(i, j) = p.roughness * p.roughness * P(i, j);
  }
  const auto some = [&](const Matrix& covariance) {
    Matrix lifted = covariance;
    lifted.diagonal().array() += 1e-14 * p.roughness * p.roughness;  // rounding makes no variance negative
    const Eigen::LLT<Matrix> factor(lifted);
    Vector z;
    for (auto& value : z) value = normal();
    return Vector(factor.info() == Eigen::Success ? Vector(factor.matrixL() * z) : Vector(Vector::Zero()));
  };
  Vector g = G > 0 ? some(limit) : Vector(Vector::Zero());
  double e = p.noise * normal();
  for (std::size_t k = 0; k < looks.looks.size(); ++k) {
    const Look& look = looks.looks[k];
    if (k > 0) {
      if constexpr (G > 0) {
        const auto square = matern::transition_over<G, double>(p.rate * (look.place - looks.looks[k - 1].place));
        Matrix A;
        for (int i = 0; i < G; ++i)
          for (int j = 0; j < G; ++j) A(i, j) = square(i, j);
        g = (A * g + some(limit - A * limit * A.transpose())).eval();
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
