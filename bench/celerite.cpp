// The likelihood of readings with its gradient by celerite2, at its best: what does not depend on the hyperparameters and all memory are had once, and its
// functions know the sizes of all small matrices when compiled. Its Matern32Term is the Matérn 3/2 kernel but for ε = 0.01.
#include <numbers>

#include <Eigen/Cholesky>
#include <celerite2/celerite2.h>

#include "bench/likelihood.h"

namespace flexslip {
namespace {

using Eigen::Dynamic, Eigen::Index, Eigen::RowMajor, Eigen::VectorXd;

// σ_g² exp(-ω|τ|) (cos ετ + ω/ε sin ετ), ω = √3/ℓ: of rank two, U and V being a cosine and a sine. A series for y and for each column.
template <int series>
class Celerite2 {
 public:
  explicit Celerite2(const Readings& readings) {
    const auto n = static_cast<Index>(readings.places.size());
    t_ = VectorXd::Map(readings.places.data(), n);
    Y_.resize(n, series);
    Y_.col(0) = VectorXd::Map(readings.values.data(), n);
    for (Index i = 0; i < n; ++i)
      Y_.row(i).tail(columns) = Coefficients::Map(readings.columns[static_cast<std::size_t>(i)].data());
    V_.resize(n, 2);
    V_.col(0) = (epsilon * t_).array().cos();
    V_.col(1) = (epsilon * t_).array().sin();
    U_.resize(n, 2);
    a_.resize(n);
    bd_.resize(n);
    bZ_.resize(n, series);
    Z_.resize(n, series);
  }

  // At hyperparameters σ, σ_g, ℓ.
  Likelihood at(double sigma, double sigma_g, double ell) {
    const double rate = std::numbers::sqrt3 / ell, even = sigma_g * sigma_g, odd = even * rate / epsilon;
    const Eigen::Vector2d c(rate, rate);
    a_.setConstant(sigma * sigma + own_variance + even);
    U_.col(0) = even * V_.col(0) + odd * V_.col(1);
    U_.col(1) = even * V_.col(1) - odd * V_.col(0);
    celerite2::core::factor(t_, c, a_, U_, V_, d_, W_, S_);
    celerite2::core::solve_lower(t_, c, U_, W_, Y_, Z_, F_);

    // The regression on the columns.
    const Square M = Z_.transpose() * d_.cwiseInverse().asDiagonal() * Z_;
    Information information = M.template bottomRightCorner<columns, columns>();
    information.diagonal().array() += 1 / prior;
    const Eigen::LLT<Information> factor(information);
    const Coefficients with_y = M.template bottomLeftCorner<columns, 1>(), beta = factor.solve(with_y);
    const double log_determinant =
        d_.array().log().sum() + columns * std::log(prior) + 2 * factor.matrixLLT().diagonal().array().log().sum();
    const double value = -0.5 * (static_cast<double>(t_.size()) * std::log(2 * std::numbers::pi) + M(0, 0) -
                                 beta.dot(with_y) + log_determinant);

    // Back: of M, of Z and d, of the matrices, of the coefficients.
    Eigen::Matrix<double, series, 1> left;
    left << 1, -beta;
    Square by_M = left * left.transpose();
    by_M.template bottomRightCorner<columns, columns>() += factor.solve(Information::Identity());
    bZ_.noalias() = -(d_.cwiseInverse().asDiagonal() * Z_) * by_M;
    bd_ = -0.5 * (bZ_.cwiseProduct(Z_).rowwise().sum().array() + 1) / d_.array();
    Eigen::Vector2d bc_solve, bc;
    celerite2::core::solve_lower_rev(t_, c, U_, W_, Y_, Z_, F_, bZ_, bt_, bc_solve, bU_solve_, bW_, bY_);
    celerite2::core::factor_rev(t_, c, a_, U_, V_, d_, W_, S_, bd_, bW_, bt_, bc, ba_, bU_, bV_);
    bU_ += bU_solve_;
    const double by_even = ba_.sum() + bU_.cwiseProduct(V_).sum();
    const double by_odd = bU_.col(0).dot(V_.col(1)) - bU_.col(1).dot(V_.col(0));
    return {.value = value,
            .by_noise = 2 * sigma * sigma * ba_.sum(),
            .by_roughness = 2 * (even * by_even + odd * by_odd),
            .by_length = -(odd * by_odd + rate * (bc.sum() + bc_solve.sum()))};
  }

 private:
  static constexpr double epsilon = 0.01;
  static constexpr int columns = series - 1;
  using Coefficients = Eigen::Matrix<double, columns, 1>;
  using Information = Eigen::Matrix<double, columns, columns>;
  using LowRank = Eigen::Matrix<double, Dynamic, 2, RowMajor>;
  using RightHandSide = Eigen::Matrix<double, Dynamic, series, RowMajor>;
  using Square = Eigen::Matrix<double, series, series>;

  VectorXd t_, a_, d_, bd_, ba_, bt_;
  LowRank U_, V_, W_, bU_, bU_solve_, bV_, bW_;
  RightHandSide Y_, Z_, bZ_, bY_;
  Eigen::Matrix<double, Dynamic, 4, RowMajor> S_;
  Eigen::Matrix<double, Dynamic, 2 * series, RowMajor> F_;
};

template <int series>
void measure(benchmark::State& run) {
  Celerite2<series> process(made_readings(run));
  Likelihood found{};
  for (auto _ : run) {
    found = process.at(noise, roughness, length);
    benchmark::DoNotOptimize(found);
  }
  report(run, found);
}

void likelihood_by_celerite2(benchmark::State& run) { run.range(0) == 1 ? measure<2>(run) : measure<8>(run); }
BENCHMARK(likelihood_by_celerite2)->ArgsProduct({{1, 7}, {100, 300, 1000, 3000}});

}  // namespace
}  // namespace flexslip
