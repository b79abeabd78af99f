#include "inference/chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "fibre/elementary.h"
#include "fibre/limits.h"
#include "inference/state_filter-inl.h"

namespace flexslip {

Chain::Chain(const Looks& looks, Kernel kernel, const Hyperparameters& at) : looks_(looks) {
  require_domain(looks, kernel, at);
  const std::size_t n = looks.looks.size();
  const std::size_t columns = looks.prior.size();
  const std::size_t series = 1 + columns;
  white_ = Eigen::MatrixXd::Zero(static_cast<Index>(series), static_cast<Index>(n));
  elementary::LogProduct variances;
  double seen = 0;
  with_state_of<void>(kernel, [&](auto size) {
    constexpr int M = decltype(size)::value;
    const auto p = numbers_of(kernel, at);
    chain::Steps<M> steps{.steps = std::vector<chain::Step<M>>(n), .rate = p.rate};
    Covariances<M, double> covariances(p);
    States<M, double> states(series);
    predicted_.resize(n * M * series);
    for (std::size_t k = 0; k < n; ++k) {
      const Look& look = looks.looks[k];
      auto& step = steps.steps[k];
      if (k > 0) {
        covariances.advance(look.place - looks.looks[k - 1].place, look.rows);
        states.advance(covariances.transition());
        step.transition = covariances.transition().at_;
      }
      step.predicted = covariances.covariance().at_;
      std::copy(states.all().begin(), states.all().end(),
                predicted_.begin() + static_cast<std::ptrdiff_t>(k * M * series));
      if (!is_seen(look)) {
        step.innovation = infinity;
        step.gain = {};
        continue;
      }
      step.innovation = covariances.look(look.noise_gain, look.variance, step.gain);
      const double scale = 1 / std::sqrt(step.innovation);
      variances.multiply(step.innovation);
      seen += 1;
      for (std::size_t c = 0; c < series; ++c) {
        const double value = c == 0 ? looks.values[k] : looks.columns[k][static_cast<Index>(c - 1)];
        const double v = states.innovation(value, look.noise_gain, c);
        states.learn(step.gain, v, c);
        white_(static_cast<Index>(c), static_cast<Index>(k)) = v * scale;
      }
    }
    steps_ = std::move(steps);
  });
  const auto p = static_cast<Index>(columns);
  const Eigen::MatrixXd products = white_ * white_.transpose();
  const auto r = regression_of(products.bottomRightCorner(p, p), products.col(0).tail(p), products(0, 0),
                               variances.value(), seen, looks.prior);
  log_likelihood_ = r.log_likelihood;
  log_determinant_ = r.log_determinant;
  beta_ = r.beta;
  covariance_ = covariance_of(r);
}

void Chain::whiten(std::span<const double> series, std::span<double> out) const {
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        constexpr int G = M - 1;
        std::array<double, M> m{};
        for (std::size_t k = 0; k < series.size(); ++k) {
          const auto& step = steps.steps[k];
          if (k > 0) {
            std::array<double, M> next{};
            for (int i = 0; i < G; ++i)
              for (int j = 0; j < G; ++j)
                next[static_cast<std::size_t>(i)] +=
                    step.transition[Square<M, double>::place(i, j)] * m[static_cast<std::size_t>(j)];
            next[G] = step.transition[Square<M, double>::place(G, G)] * m[G];
            m = next;
          }
          if (!is_seen(looks_.looks[k])) {
            out[k] = 0;
            continue;
          }
          const double v = series[k] - (G > 0 ? m[0] : 0) - looks_.looks[k].noise_gain * m[G];
          for (std::size_t i = 0; i < M; ++i) m[i] += step.gain[i] * v;
          out[k] = v / std::sqrt(step.innovation);
        }
      },
      steps_);
}

Chain::Functional Chain::functional(const Coefficients& a, std::span<const double> covariance, double variance) const {
  std::vector<double> v(covariance.size());
  whiten(covariance, v);
  const Eigen::Map<const Eigen::VectorXd> whitened(v.data(), static_cast<Index>(v.size()));
  const auto p = static_cast<Index>(looks_.prior.size());
  const Eigen::VectorXd products = white_ * whitened;
  const Coefficients left = a - products.tail(p);
  const Coefficients with_beta = covariance_ * left;
  return {.mean = a.dot(beta_) + products[0] - products.tail(p).dot(beta_),
          .variance = variance - whitened.squaredNorm() + left.dot(with_beta),
          .with_beta = with_beta};
}

std::vector<SmoothedLook> Chain::smoothed() const {
  const std::size_t n = looks_.looks.size();
  const std::size_t series = 1 + looks_.prior.size();
  std::vector<SmoothedLook> result(n);
  std::size_t first_place = 0;  // that is no reading: before it no variance is asked for
  while (first_place < n && looks_.looks[first_place].is_reading()) ++first_place;
  std::array<double, most_columns + 1> together{};  // y less what the columns explain
  together[0] = 1;
  for (std::size_t c = 1; c < series; ++c) together[c] = -beta_[static_cast<Index>(c - 1)];
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        constexpr int G = M - 1;
        // What the looks from here on say of the state: together, column by column, and how precisely.
        Few<M> r{};
        std::array<std::array<double, most_columns + 1>, M> of_columns{}, carried{};
        std::array<double, most_columns + 1> u{}, left{};
        Square<M, double> N{};
        for (std::size_t k = n; k-- > 0;) {
          const auto& step = steps.steps[k];
          const Look& look = looks_.looks[k];
          const bool variances = k >= first_place;
          const double* const white = white_.data() + k * series;
          const double* const predicted = predicted_.data() + k * M * series;
          if (is_seen(look)) {
            // r <- H v/s + (1 - K H)' r, and so for N
            const double scale = 1 / std::sqrt(step.innovation);
            double sum = 0;
            for (std::size_t c = 0; c < series; ++c) sum += white[c] * together[c];
            sum *= scale;
            for (std::size_t i = 0; i < M; ++i) sum -= step.gain[i] * r[i];
            if (G > 0) r[0] += sum;
            r[G] += look.noise_gain * sum;
            if (variances) {
              for (std::size_t c = 1; c < series; ++c) u[c] = white[c] * scale;
              for (std::size_t i = 0; i < M; ++i)
                for (std::size_t c = 1; c < series; ++c) u[c] -= step.gain[i] * of_columns[i][c];
              for (std::size_t c = 1; c < series; ++c) {
                if (G > 0) of_columns[0][c] += u[c];
                of_columns[G][c] += look.noise_gain * u[c];
              }
              Few<M> H{};
              if (G > 0) H[0] = 1;
              H[G] = look.noise_gain;  // of e, which is all there is without a kernel
              const Few<M> Ng = product(N, step.gain);
              const double g = dot<M>(step.gain, Ng) + 1 / step.innovation;
              for (std::size_t i = 0; i < M; ++i)
                for (std::size_t j = 0; j < M; ++j) N.at_[i * M + j] += g * H[i] * H[j] - H[i] * Ng[j] - Ng[i] * H[j];
            }
          }
          const auto mean_of = [&](std::size_t i) {
            double sum = 0;
            for (std::size_t c = 0; c < series; ++c) sum += predicted[i * series + c] * together[c];
            for (std::size_t j = 0; j < M; ++j) sum += step.predicted[i * M + j] * r[j];
            return sum;
          };
          const Coefficients& h = looks_.columns[k];
          result[k].e = mean_of(G);
          result[k].f = h.dot(beta_) + (G > 0 ? mean_of(0) : 0);
          if constexpr (G > 1) result[k].slope = steps.rate * mean_of(1);
          result[k].variance = not_a_number;
          if (!look.is_reading()) {
            double own = 0;  // variance at given β
            for (std::size_t c = 1; c < series; ++c) left[c] = h[static_cast<Index>(c - 1)];
            if constexpr (G > 0) {
              Few<M> Pg;
              for (std::size_t j = 0; j < M; ++j) Pg[j] = step.predicted[j * M];
              own = Pg[0] - dot<M>(Pg, product(N, Pg));
              for (std::size_t c = 1; c < series; ++c) {
                left[c] -= predicted[c];
                for (std::size_t j = 0; j < M; ++j) left[c] -= step.predicted[j] * of_columns[j][c];
              }
            }
            for (std::size_t c = 1; c < series; ++c)
              for (std::size_t d = 1; d < series; ++d)
                own += left[c] * left[d] * covariance_(static_cast<Index>(c - 1), static_cast<Index>(d - 1));
            result[k].variance = own;
          }
          if (k == 0) break;
          const Square<M, double> A{step.transition}, A_transposed = transposed(A);
          r = product(A_transposed, r);
          if (k <= first_place) continue;
          for (std::size_t i = 0; i < M; ++i) {
            carried[i].fill(0);
            for (std::size_t j = 0; j < M; ++j) {
              const double a = step.transition[j * M + i];
              if (a == 0) continue;  // g and e do not mix
              for (std::size_t c = 1; c < series; ++c) carried[i][c] += a * of_columns[j][c];
            }
          }
          std::swap(of_columns, carried);
          N = product(product(A_transposed, N), A);
        }
      },
      steps_);
  if (const auto* steps = std::get_if<chain::Steps<2>>(&steps_)) {
    // Between two looks the mean of an exponential kernel is a sum of exponentials, which bends at each of them.
    const auto g = [&](std::size_t k) { return result[k].f - looks_.columns[k].dot(beta_); };
    const auto slope_at = [&](std::size_t k, std::size_t beside) {
      const double away = looks_.looks[beside].place - looks_.looks[k].place;
      if (away == 0) return 0.0;
      const double e = elementary::exp(-std::abs(away) * steps->rate);
      return std::copysign(steps->rate, away) * (2 * e * g(beside) - (1 + e * e) * g(k)) / (1 - e * e);
    };
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t before = k, after = k;
      while (before > 0 && looks_.looks[before].place == looks_.looks[k].place) --before;
      while (after + 1 < n && looks_.looks[after].place == looks_.looks[k].place) ++after;
      const double place = looks_.looks[k].place;
      const double sides = (looks_.looks[before].place < place) + (looks_.looks[after].place > place);
      result[k].slope = sides > 0 ? (slope_at(k, before) + slope_at(k, after)) / sides : 0;
    }
  }
  return result;
}

}  // namespace flexslip
