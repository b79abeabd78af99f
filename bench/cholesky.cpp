// The likelihood of readings with its gradient by the Cholesky factor of their covariance: in the time of the cube of their number, and the truth
// to which all others are held.
#include <numbers>

#include <Eigen/Cholesky>

#include "bench/likelihood.h"

namespace flexslip {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// A kernel of variance 1 over a distance > 0, and its derivative to ln ℓ.
struct KernelAt {
  double value, by_log_length;
};
constexpr double rate = std::numbers::sqrt3 / length;

KernelAt matern_3_2(double distance) {
  const double r = rate * distance, decay = std::exp(-r);
  return {(1 + r) * decay, r * r * decay};
}

// That of celerite2's Matern32Term, whose limit for ε → 0 is the other.
KernelAt celerite2_matern_3_2(double distance) {
  constexpr double epsilon = 0.01;
  const double r = rate * distance, decay = std::exp(-r);
  const double cosine = std::cos(epsilon * distance), sine = std::sin(epsilon * distance) / epsilon;
  return {decay * (cosine + rate * sine), decay * r * (cosine + (rate - 1 / distance) * sine)};
}

// The columns stand in the covariance, with what is known of their coefficients beforehand.
template <KernelAt (*kernel)(double)>
Likelihood dense(const VectorXd& x, const VectorXd& y, const MatrixXd& columns) {
  const Index n = x.size();
  MatrixXd K = MatrixXd::Identity(n, n), slope = MatrixXd::Zero(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = j + 1; i < n; ++i) {
      const auto at = kernel(x[i] - x[j]);
      K(i, j) = K(j, i) = at.value;
      slope(i, j) = slope(j, i) = at.by_log_length;
    }
  constexpr double variance = roughness * roughness;
  MatrixXd C = variance * K + prior * columns * columns.transpose();
  C.diagonal().array() += noise * noise + own_variance;
  const Eigen::LLT<MatrixXd> factor(C);
  const VectorXd alpha = factor.solve(y);
  MatrixXd by_C = -factor.solve(MatrixXd::Identity(n, n));  // 2 ∂ ln p(y)/∂C
  by_C.noalias() += alpha * alpha.transpose();
  const double log_determinant = 2 * factor.matrixLLT().diagonal().array().log().sum();
  return {.value = -0.5 * (static_cast<double>(n) * std::log(2 * std::numbers::pi) + y.dot(alpha) + log_determinant),
          .by_noise = noise * noise * by_C.trace(),
          .by_roughness = variance * by_C.cwiseProduct(K).sum(),
          .by_length = 0.5 * variance * by_C.cwiseProduct(slope).sum()};
}

template <KernelAt (*kernel)(double)>
void likelihood_by_cholesky(benchmark::State& run) {
  const Readings readings = made_readings(run);
  const Index n = run.range(1);
  const VectorXd x = VectorXd::Map(readings.places.data(), n), y = VectorXd::Map(readings.values.data(), n);
  MatrixXd columns(n, run.range(0));
  for (Index i = 0; i < n; ++i)
    columns.row(i) = VectorXd::Map(readings.columns[static_cast<std::size_t>(i)].data(), columns.cols());
  Likelihood found{};
  for (auto _ : run) {
    found = dense<kernel>(x, y, columns);
    benchmark::DoNotOptimize(found);
  }
  report(run, found);
}
BENCHMARK(likelihood_by_cholesky<matern_3_2>)
    ->Name("likelihood_by_cholesky")
    ->ArgsProduct({{1, 7}, {100, 300, 1000}})
    ->Args({1, 3000});
BENCHMARK(likelihood_by_cholesky<celerite2_matern_3_2>)
    ->Name("likelihood_of_celerite2_by_cholesky")
    ->ArgsProduct({{1, 7}, {100, 300, 1000}});

}  // namespace
}  // namespace flexslip
