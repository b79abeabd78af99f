#include "inference/likelihood_gradient.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "fibre/elementary.h"
#include "inference/state_filter-inl.h"

namespace flexslip {
namespace {

// A number with its derivatives to ln σ, ρ, ln σ_g and ln ℓ.
struct Dual {
  double value;
  Eigen::Array4d d;

  Dual() = default;    // of no value, as a double
  Dual(double number)  // NOLINT(google-explicit-constructor): a number is one with no derivative
      : value(number), d(Eigen::Array4d::Zero()) {}
  Dual(double number, Index of) : Dual(number) { d[of] = 1; }
  Dual(double number, Eigen::Array4d derivatives) : value(number), d(std::move(derivatives)) {}

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.d + b.d}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.d - b.d}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.value * b.value, a.d * b.value + b.d * a.value}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double inverse = 1 / b.value;
    const double quotient = a.value * inverse;
    return {quotient, (a.d - b.d * quotient) * inverse};
  }
};

Dual exp(const Dual& a) {
  const double value = elementary::exp(a.value);
  return {value, a.d * value};
}
Dual log(const Dual& a) { return {elementary::log(a.value), a.d / a.value}; }
Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, a.d / (2 * root)};
}
double value_of(const Dual& a) { return a.value; }

Parameters<Dual> duals_of(Kernel kernel, const Hyperparameters& at) {
  const auto p = numbers_of(kernel, at);
  Parameters<Dual> duals{p.noise, Dual(p.correlation, 1), p.roughness, p.rate};
  duals.noise.d[0] = p.noise;
  duals.roughness.d[2] = p.roughness;
  duals.rate.d[3] = -p.rate;
  return duals;
}

template <int M>
LikelihoodGradient gradient_with(const Looks& looks, Kernel kernel, const Hyperparameters& at,
                                 std::span<const double> wavelengths) {
  const std::size_t columns = looks.prior.size();
  const std::size_t waves = wavelengths.size();
  // y, the columns, and the derivatives of those of waves.
  const std::size_t series = 1 + columns + 2 * waves;
  Covariances<M, Dual> covariances(duals_of(kernel, at));
  States<M, Dual> states(series);
  std::array<Dual, M> gain;
  std::vector<Dual> v(series);
  std::vector<Dual> products(series * series, Dual(0));  // upper triangle
  elementary::LogProduct variances;
  Eigen::Array4d log_variances_d = Eigen::Array4d::Zero();
  double seen = 0;
  for (std::size_t k = 0; k < looks.looks.size(); ++k) {
    const Look& look = looks.looks[k];
    if (k > 0) {
      covariances.advance(look.place - looks.looks[k - 1].place, look.rows);
      states.advance(covariances.transition());
    }
    if (!is_seen(look)) continue;
    const Dual s = covariances.look(look.noise_gain, look.variance, gain);
    variances.multiply(s.value);
    log_variances_d += s.d / s.value;
    seen += 1;
    const Coefficients& h = looks.columns[k];
    const Dual scale = Dual(1) / sqrt(s);
    for (std::size_t c = 0; c < series; ++c) {
      double value = c == 0 ? looks.values[k] : c <= columns ? h[static_cast<Index>(c - 1)] : 0;
      if (c > columns) {  // d cos(2πx/λ)/d ln λ = (2πx/λ) sin, and of sin minus that of cos
        const std::size_t wave = (c - columns - 1) / 2;
        const bool of_cosine = (c - columns - 1) % 2 == 0;
        const auto first = static_cast<Index>(columns - 2 * waves + 2 * wave);
        const double phase = 2 * std::numbers::pi * look.place / wavelengths[wave];
        value = of_cosine ? phase * h[first + 1] : -phase * h[first];
      }
      v[c] = states.innovation(value, look.noise_gain, c);
      states.learn(gain, v[c], c);
      v[c] = v[c] * scale;
    }
    for (std::size_t a = 0; a < 1 + columns; ++a)
      for (std::size_t b = a; b < series; ++b) products[a * series + b] = products[a * series + b] + v[a] * v[b];
  }
  const auto product = [&](std::size_t a, std::size_t b) -> const Dual& {
    return products[std::min(a, b) * series + std::max(a, b)];
  };
  const auto p = static_cast<Index>(columns);
  CoefficientMatrix BB(p, p);
  Coefficients By(p);
  for (std::size_t i = 0; i < columns; ++i) {
    By[static_cast<Index>(i)] = product(0, i + 1).value;
    for (std::size_t j = 0; j < columns; ++j)
      BB(static_cast<Index>(i), static_cast<Index>(j)) = product(i + 1, j + 1).value;
  }
  const auto r = regression_of(BB, By, product(0, 0).value, variances.value(), seen, looks.prior);
  const CoefficientMatrix covariance = covariance_of(r);
  LikelihoodGradient result{.value = r.log_likelihood, .hyperparameters = {}, .log_wavelengths = {}};
  for (Index t = 0; t < 4; ++t) {
    double d = -0.5 * (log_variances_d[t] + product(0, 0).d[t]);
    for (std::size_t i = 0; i < columns; ++i) {
      const auto row = static_cast<Index>(i);
      d += r.beta[row] * product(0, i + 1).d[t];
      for (std::size_t j = 0; j < columns; ++j) {
        const auto column = static_cast<Index>(j);
        d -= 0.5 * (r.beta[row] * r.beta[column] + covariance(row, column)) * product(i + 1, j + 1).d[t];
      }
    }
    result.hyperparameters[static_cast<std::size_t>(t)] = d;
  }
  for (std::size_t wave = 0; wave < waves; ++wave) {
    double d = 0;
    for (std::size_t part = 0; part < 2; ++part) {
      const auto column = static_cast<Index>(columns - 2 * waves + 2 * wave + part);
      const std::size_t derivative = 1 + columns + 2 * wave + part;
      d += r.beta[column] * product(0, derivative).value;
      for (std::size_t j = 0; j < columns; ++j) {
        const auto other = static_cast<Index>(j);
        d -= (r.beta[column] * r.beta[other] + covariance(other, column)) * product(j + 1, derivative).value;
      }
    }
    result.log_wavelengths[wave] = d;
  }
  return result;
}

}  // namespace

LikelihoodGradient likelihood_gradient(const Looks& looks, Kernel kernel, const Hyperparameters& at,
                                       std::span<const double> wavelengths) {
  require_domain(looks, kernel, at);
  if (wavelengths.size() > 2 || 2 * wavelengths.size() > looks.prior.size())
    throw std::invalid_argument(std::to_string(wavelengths.size()) +
                                " waves, more than two or than the columns are of");
  return with_state_of<LikelihoodGradient>(
      kernel, [&](auto M) { return gradient_with<decltype(M)::value>(looks, kernel, at, wavelengths); });
}

}  // namespace flexslip
