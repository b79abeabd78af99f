#include "inference/chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Cholesky>

#include "data/names.h"
#include "inference/matern.h"
#include "numerics/effort.h"
#include "numerics/require.h"

namespace flexslip {
namespace {

using chain::States;
using chain::Transition;
using Eigen::Index;
using AllSeries = chain::Series<chain::max_series>;
using SeriesMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, chain::max_series, chain::max_series>;

template <std::size_t N>
void add(double factor, const std::array<double, N>& x, std::array<double, N>& sum) {
  for (std::size_t i = 0; i < N; ++i) sum[i] += factor * x[i];
}

// The states of N series, or of the columns of a covariance, after a transition.
template <int M, std::size_t N, std::size_t Size>
void carry(const Transition<M>& A, const std::array<std::array<double, N>, Size>& states,
           std::array<std::array<double, N>, Size>& next) {
  constexpr int G = M - 1;
  for (int i = 0; i < G; ++i) {
    std::array<double, N> sum{};
    for (int j = 0; j < G; ++j) add(A.of_g(i, j), states[j], sum);
    next[i] = sum;
  }
  for (std::size_t s = 0; s < N; ++s) next[G][s] = A.of_e * states[G][s];
}
template <int M, std::size_t N, std::size_t Size>
std::array<std::array<double, N>, Size> operator*(const Transition<M>& A,
                                                  const std::array<std::array<double, N>, Size>& states) {
  std::array<std::array<double, N>, Size> next;
  carry(A, states, next);
  return next;
}

template <int M>
States<M, M> transposed(const States<M, M>& matrix) {
  States<M, M> out;
  for (int i = 0; i < M; ++i)
    for (int j = 0; j < M; ++j) out[i][j] = matrix[j][i];
  return out;
}

template <int M>
Transition<M> transposed(const Transition<M>& A) {
  return {transposed(A.of_g), A.of_e};
}

// A P A' for a symmetric P.
template <int M>
States<M, M> carried(const Transition<M>& A, const States<M, M>& P) {
  return A * transposed<M>(A * P);
}

// Sums of even and odd terms, for vector instructions.
template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  if constexpr (N % 2 == 1) {
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
    return sum;
  } else {
    std::array<double, 2> sums{};
    for (std::size_t i = 0; i < N; i += 2)
      for (std::size_t odd = 0; odd < 2; ++odd) sums[odd] += a[i + odd] * b[i + odd];
    return sums[0] + sums[1];
  }
}

template <int M>
Few<M> times_state(const States<M, M>& matrix, const Few<M>& v) {  // for a symmetric matrix
  Few<M> out{};
  for (int i = 0; i < M; ++i) add(v[i], matrix[i], out);
  return out;
}

// The stationary covariance of a state.
template <int M>
States<M, M> stationary(const Hyperparameters& at) {
  States<M, M> limit{};
  if constexpr (M > 1) {
    const auto P = matern::stationary<M - 1>();
    for (int i = 0; i < M - 1; ++i)
      for (int j = 0; j < M - 1; ++j) limit[i][j] = at.roughness * at.roughness * P(i, j);
  }
  limit[M - 1][M - 1] = at.noise * at.noise;
  return limit;
}

// The transitions to each observation from the previous one.
template <int M>
void find_transitions(const Observations& observations, const Hyperparameters& at, chain::Steps<M>& steps) {
  const auto& all = observations.all;
  KeptArray<double> away(all.size()), decay(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) away[k] = k == 0 ? 0 : steps.rate * (all[k].place - all[k - 1].place);
  for (std::size_t k = 0; k < all.size(); ++k) decay[k] = -away[k];
  elementary::exp({decay.data(), all.size()}, {decay.data(), all.size()});
  for (std::size_t k = 0; k < all.size(); ++k) {
    Transition<M>& A = steps.steps[k].transition;
    if constexpr (M > 1) A.of_g = matern::transition_over<M - 1>(away[k], decay[k]);
    A.of_e = at.correlation;
    if (all[k].rows == 0) A.of_e = 1;
    if (all[k].rows > 1) A.of_e = A.of_e > 0 ? elementary::exp(all[k].rows * elementary::log(A.of_e)) : 0;
  }
}

// H such that H'X = g + D e is the observed part of the state.
template <int M>
Few<M> seen_by(const Observation& observation) {
  Few<M> H{};
  H[0] = 1;
  H[M - 1] = observation.noise_gain;  // without a kernel, the state is e
  return H;
}

// The observed part H'X for all series.
template <int M, int N>
chain::Series<N> seen(const Observation& observation, const States<M, N>& states) {
  chain::Series<N> sum;
  for (int s = 0; s < N; ++s) sum[s] = observation.noise_gain * states[M - 1][s];
  if constexpr (M > 1)
    for (int s = 0; s < N; ++s) sum[s] += states[0][s];
  return sum;
}

// The value of one series at an observation.
auto& number_of(auto& of_series, int s) {
  if constexpr (requires { of_series[s]; })
    return of_series[static_cast<std::size_t>(s)];
  else
    return of_series;
}

// Filters further series: their standardised innovations, and the predictions of g of the first.
template <int M, int N, class Series>
void filter(const Observations& observations, const chain::Steps<M>& steps, std::span<const Series> series,
            std::span<Series> white, std::span<double> predictions = {}) {
  States<M, N> states{};
  for (std::size_t k = 0; k < series.size(); ++k) {
    const auto& step = steps.steps[k];
    states = step.transition * states;
    if (!predictions.empty()) predictions[k] = M > 1 ? states[0][0] : 0;
    const auto expected = seen<M, N>(observations.all[k], states);
    for (int s = 0; s < N; ++s) {
      const double v = number_of(series[k], s) - expected[s];
      for (int i = 0; i < M; ++i) states[i][s] += step.gain[i] * v;
      number_of(white[k], s) = step.scale * v;
    }
  }
}

// The sums over all observations of the products of two series, four observations at a time.
SeriesMatrix products_of(std::span<const AllSeries> white, std::size_t series) {
  std::array<AllSeries, chain::max_series> sums{};  // of each series with the previous ones and itself
  constexpr std::size_t at_once = 4;
  constexpr AllSeries none{};
  for (std::size_t k = 0; k < white.size(); k += at_once) {
    const auto at = [&](std::size_t j) -> const AllSeries& { return k + j < white.size() ? white[k + j] : none; };
    const AllSeries &a = at(0), &b = at(1), &c = at(2), &d = at(3);
    for (std::size_t s = 0; s < series; ++s)
      for (std::size_t other = 0; other <= s; ++other)
        sums[s][other] += (a[s] * a[other] + b[s] * b[other]) + (c[s] * c[other] + d[s] * d[other]);
  }
  const auto count = static_cast<Index>(series);
  SeriesMatrix products(count, count);
  for (std::size_t s = 0; s < series; ++s)
    for (std::size_t other = 0; other <= s; ++other)
      products(static_cast<Index>(s), static_cast<Index>(other)) =
          products(static_cast<Index>(other), static_cast<Index>(s)) = sums[s][other];
  return products;
}

}  // namespace

std::string_view name_of(Kernel kernel) {
  return name_in_order<Kernel::matern_9_2>(kernel, {"none", "exponential", "matern_3_2", "matern_9_2"});
}

void require_domain(const Observations& observations, Kernel kernel, const Hyperparameters& at) {
  require(at.noise >= 0, "noise", at.noise);
  require(at.correlation >= 0 && at.correlation < 1, "correlation", at.correlation);
  if (kernel != Kernel::none) {
    require(at.roughness > 0, "roughness", at.roughness);
    require(at.length > 0, "correlation length", at.length);
  }
  require(observations.prior.size() <= max_columns, "columns", static_cast<double>(observations.prior.size()));
  if (observations.values.size() != observations.all.size() || observations.columns.size() != observations.all.size())
    throw std::invalid_argument("the columns of the observations differ in length");
}

Chain::Chain(const Observations& observations, Kernel kernel, const Hyperparameters& at)
    : observations_(observations), kernel_(kernel), at_(at) {
  require_domain(observations, kernel, at);
  const std::size_t n = observations.all.size(), columns = observations.prior.size();
  const auto p = static_cast<Index>(columns);
  effort_spent += n * (columns + 1);
  white_ = KeptArray<AllSeries>(n);
  elementary::LogProduct deviations;
  double count = 0;
  matern::with_order_of(kernel, [&](auto order) {
    constexpr int M = decltype(order)::value + 1;
    chain::Steps<M> steps{.steps = KeptArray<chain::Step<M>>(n),
                          .rate = M > 1 ? matern::rate_of(kernel) / at.length : 0};
    find_transitions<M>(observations, at, steps);
    const States<M, M> limit = stationary<M>(at);
    States<M, M> away{};  // covariance - stationary covariance
    States<M, chain::max_series> states{};
    for (std::size_t k = 0; k < n; ++k) {
      const Observation& observation = observations.all[k];
      auto& step = steps.steps[k];
      away = carried<M>(step.transition, away);
      step.predicted = limit;
      for (int i = 0; i < M; ++i) add(1, away[i], step.predicted[i]);
      carry(step.transition, states, step.series);
      AllSeries& white = white_[k];
      if (!is_seen(observation)) {
        step.gain = {};
        step.scale = 0;
        white = {};
        states = step.series;
        continue;
      }
      const Few<M> H = seen_by<M>(observation), PH = times_state<M>(step.predicted, H);
      const double variance = dot(H, PH) + observation.variance, deviation = std::sqrt(variance);
      step.scale = 1 / deviation;
      for (int i = 0; i < M; ++i) step.gain[i] = PH[i] / variance;
      for (int i = 0; i < M; ++i) add(-step.gain[i], PH, away[i]);
      AllSeries v;  // the innovations
      const double* const h = observations.columns[k].data();
      for (std::size_t s = 0; s < max_columns; ++s) v[s] = s < columns ? h[s] : 0;
      v[max_columns] = v[max_columns + 1] = 0;
      v[columns] = observations.values[k];
      const AllSeries expected = seen<M, chain::max_series>(observation, step.series);
      for (std::size_t s = 0; s < chain::max_series; ++s) v[s] -= expected[s];
      for (std::size_t s = 0; s < chain::max_series; ++s) white[s] = step.scale * v[s];
      for (int i = 0; i < M; ++i)
        for (std::size_t s = 0; s < chain::max_series; ++s) states[i][s] = step.series[i][s] + step.gain[i] * v[s];
      deviations.multiply(deviation);
      count += 1;
    }
    steps_ = std::move(steps);
  });
  // The regression on the whitened columns.
  const SeriesMatrix products = products_of({white_.data(), n}, columns + 1);
  CoefficientMatrix information = products.topLeftCorner(p, p);
  double log_determinant = 2 * deviations.value();
  for (Index j = 0; j < p; ++j) {
    information(j, j) += 1 / observations.prior[static_cast<std::size_t>(j)];
    log_determinant += elementary::log(observations.prior[static_cast<std::size_t>(j)]);
  }
  const Eigen::LLT<CoefficientMatrix> factor(information);
  const Coefficients with_y = products.col(p).head(p);
  covariance_ = factor.solve(CoefficientMatrix::Identity(p, p));
  beta_ = by_readings_ = factor.solve(with_y);
  for (Index j = 0; j < p; ++j) log_determinant += 2 * elementary::log(factor.matrixLLT()(j, j));
  log_likelihood_ =
      -0.5 * (count * elementary::log(2 * std::numbers::pi) + products(p, p) - beta_.dot(with_y) + log_determinant);
  if (observations.pull.size() > 0) beta_ += covariance_ * observations.pull;
}

void Chain::whiten(std::span<const double> series, std::span<double> out) const {
  effort_spent += series.size();
  std::visit([&]<int M>(const chain::Steps<M>& steps) { filter<M, 1>(observations_, steps, series, out); }, steps_);
}

void Chain::whiten(std::span<const Eight> series, std::span<Eight> out) const {
  effort_spent += 8 * series.size();
  std::visit([&]<int M>(const chain::Steps<M>& steps) { filter<M, 8>(observations_, steps, series, out); }, steps_);
}

Chain::Means Chain::means_of(std::span<const double> values) const {
  const std::size_t n = values.size();
  effort_spent += 3 * n;
  Means means{.f = std::vector<double>(n), .beta = {}};
  std::vector<double> rest(values.begin(), values.end()), white(n), predictions(n);
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        filter<M, 1, double>(observations_, steps, rest, white);
        const Eigen::Map<const Eigen::VectorXd> whitened(white.data(), static_cast<Index>(n));
        Coefficients by_values = whitened_columns().topRows(static_cast<Index>(observations_.prior.size())) * whitened;
        if (observations_.pull.size() > 0) by_values += observations_.pull;
        means.beta = covariance_ * by_values;
        for (std::size_t k = 0; k < n; ++k) rest[k] -= means.f[k] = observations_.columns[k].dot(means.beta);
        filter<M, 1, double>(observations_, steps, rest, white, predictions);
        States<M, 1> r{};  // as in smoothed()
        for (std::size_t k = n; M > 1 && k-- > 0;) {
          const auto& step = steps.steps[k];
          double mean = predictions[k], later = step.scale * white[k];
          for (int i = 0; i < M; ++i) later -= step.gain[i] * r[i][0];
          if (is_seen(observations_.all[k])) {
            const Few<M> H = seen_by<M>(observations_.all[k]);
            for (int i = 0; i < M; ++i) r[i][0] += later * H[i];
          }
          for (int i = 0; i < M; ++i) mean += step.predicted[0][i] * r[i][0];
          means.f[k] += mean;
          r = transposed(step.transition) * r;
        }
      },
      steps_);
  return means;
}

Chain::Functional Chain::functional(const Coefficients& a, std::span<const double> covariance, double variance) const {
  std::vector<double> v(covariance.size());
  whiten(covariance, v);
  const Eigen::Map<const Eigen::VectorXd> whitened(v.data(), static_cast<Index>(v.size()));
  const auto p = static_cast<Index>(observations_.prior.size());
  const Eigen::VectorXd products = whitened_columns() * whitened;
  const Coefficients left = a - products.head(p);
  const Coefficients with_beta = covariance_ * left;
  return {.mean = a.dot(beta_) + products[p] - products.head(p).dot(beta_),
          .variance = variance - whitened.squaredNorm() + left.dot(with_beta),
          .with_beta = with_beta};
}

std::vector<SmoothedObservation> Chain::smoothed() const {
  const std::size_t n = observations_.all.size(), columns = observations_.prior.size();
  std::vector<SmoothedObservation> result(n);
  std::size_t first_place = 0;  // first observation that is no reading; earlier ones need no variance
  while (first_place < n && observations_.all[first_place].is_reading()) ++first_place;
  AllSeries rest{};  // y - the part that the columns explain
  for (std::size_t c = 0; c < columns; ++c) rest[c] = -beta_[static_cast<Index>(c)];
  rest[columns] = 1;
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        // The score of the state from later observations, for the residual and each column, and its
        // information N.
        States<M, 1> r{};
        States<M, chain::max_series> of_columns{};
        States<M, M> N{};
        for (std::size_t k = n; k-- > 0;) {
          const auto& step = steps.steps[k];
          const Observation& observation = observations_.all[k];
          const bool with_variances = k >= first_place;
          if (is_seen(observation)) {
            const Few<M> H = seen_by<M>(observation);
            double sum = step.scale * dot(rest, white_[k]);
            for (int i = 0; i < M; ++i) sum -= step.gain[i] * r[i][0];
            for (int i = 0; i < M; ++i) r[i][0] += sum * H[i];
            if (with_variances) {
              AllSeries v;
              for (std::size_t s = 0; s < chain::max_series; ++s) v[s] = step.scale * white_[k][s];
              for (int i = 0; i < M; ++i) add(-step.gain[i], of_columns[i], v);
              for (int i = 0; i < M; ++i) add(H[i], v, of_columns[i]);
              const Few<M> with_gain = times_state<M>(N, step.gain);
              const double information = dot(step.gain, with_gain) + step.scale * step.scale;
              for (int i = 0; i < M; ++i)
                for (int j = 0; j < M; ++j)
                  N[i][j] += information * H[i] * H[j] - H[i] * with_gain[j] - with_gain[i] * H[j];
            }
          }
          const auto mean = [&](int i) {
            double sum = dot(step.series[i], rest);
            for (int j = 0; j < M; ++j) sum += step.predicted[i][j] * r[j][0];
            return sum;
          };
          const Coefficients& h = observations_.columns[k];
          result[k] = {.f = h.dot(beta_), .variance = not_a_number, .slope = 0, .e = mean(M - 1)};
          if constexpr (M > 1) result[k].f += mean(0);
          if constexpr (M > 2) result[k].slope = steps.rate * mean(1);
          if (!observation.is_reading()) {
            double own = 0;  // variance at given β
            Coefficients left = h;
            if constexpr (M > 1) {
              const auto& with_g = step.predicted[0];
              own = with_g[0] - dot(with_g, times_state<M>(N, with_g));
              for (std::size_t c = 0; c < columns; ++c) {
                double& of = left[static_cast<Index>(c)];
                of -= step.series[0][c];
                for (int i = 0; i < M; ++i) of -= with_g[i] * of_columns[i][c];
              }
            }
            result[k].variance = own + left.dot(covariance_ * left);
          }
          const Transition<M> back = transposed(step.transition);
          r = back * r;
          if (k <= first_place) continue;
          of_columns = back * of_columns;
          N = carried<M>(back, N);
        }
      },
      steps_);
  if (const auto* steps = std::get_if<chain::Steps<2>>(&steps_)) {
    // With an exponential kernel the mean is a sum of exponentials between observations, with a
    // kink at each one.
    const auto g = [&](std::size_t k) { return result[k].f - observations_.columns[k].dot(beta_); };
    const auto slope_at = [&](std::size_t k, std::size_t beside) {
      const double away = observations_.all[beside].place - observations_.all[k].place;
      if (away == 0) return 0.0;
      const double e = elementary::exp(-std::abs(away) * steps->rate);
      return std::copysign(steps->rate, away) * (2 * e * g(beside) - (1 + e * e) * g(k)) / (1 - e * e);
    };
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t before = k, after = k;
      while (before > 0 && observations_.all[before].place == observations_.all[k].place) --before;
      while (after + 1 < n && observations_.all[after].place == observations_.all[k].place) ++after;
      const double place = observations_.all[k].place;
      const double sides = (observations_.all[before].place < place) + (observations_.all[after].place > place);
      result[k].slope = sides > 0 ? (slope_at(k, before) + slope_at(k, after)) / sides : 0;
    }
  }
  return result;
}

LikelihoodGradient Chain::gradient(std::span<const double> wavelengths) const {
  if (wavelengths.size() > 2 || 2 * wavelengths.size() > observations_.prior.size())
    throw std::invalid_argument(std::to_string(wavelengths.size()) +
                                " waves, more than two or than the columns are of");
  return std::visit([&](const auto& steps) { return gradient_of(steps, wavelengths); }, steps_);
}

// The adjoint of the filter. -2 ln p(y) = Σ ln s + v Q v'/s + ..., with v the innovations of the
// series and s their variance. A bar marks the derivative of this sum in a quantity.
template <int M>
LikelihoodGradient Chain::gradient_of(const chain::Steps<M>& steps, std::span<const double> wavelengths) const {
  constexpr int G = M - 1, N = chain::max_series;
  const std::size_t n = observations_.all.size(), columns = observations_.prior.size();
  effort_spent += n * 2 * (columns + 1);
  const States<M, M> limit = stationary<M>(at_);
  std::array<AllSeries, N> Q{};
  for (std::size_t c = 0; c < columns; ++c) {
    const auto i = static_cast<Index>(c);
    for (std::size_t d = 0; d < columns; ++d) {
      const auto j = static_cast<Index>(d);
      Q[c][d] = by_readings_[i] * by_readings_[j] + covariance_(i, j);
    }
    Q[c][columns] = Q[columns][c] = -by_readings_[i];
  }
  Q[columns][columns] = 1;
  [[maybe_unused]] const auto companion = matern::companion<(G > 0 ? G : 1)>();
  States<M, N> states_bar{};
  States<M, M> P_bar{}, limit_bar{};
  double by_correlation = 0, by_log_length = 0;
  LikelihoodGradient result{.value = log_likelihood_, .hyperparameters = {}, .log_wavelengths = {}};
  for (std::size_t k = n; k-- > 0;) {
    const Observation& observation = observations_.all[k];
    const auto& step = steps.steps[k];
    if (is_seen(observation)) {
      const Few<M> H = seen_by<M>(observation);
      const AllSeries& white = white_[k];
      AllSeries weighted{};
      for (std::size_t c = 0; c <= columns; ++c) add(white[c], Q[c], weighted);
      const double precision = step.scale * step.scale;
      AllSeries v_bar;
      for (int s = 0; s < N; ++s) v_bar[s] = 2 * step.scale * weighted[s];
      Few<M> gain_bar;
      for (int i = 0; i < M; ++i) {
        gain_bar[i] = dot(states_bar[i], white) / step.scale;
        add(step.gain[i], states_bar[i], v_bar);
      }
      for (int i = 0; i < M; ++i) add(-H[i], v_bar, states_bar[i]);
      // K = P H/s, P - K s K', s = H'P H + variance
      const Few<M> with_gain = times_state<M>(P_bar, step.gain);
      const double s_bar =
          (1 - dot(weighted, white) - dot(gain_bar, step.gain)) * precision + dot(step.gain, with_gain);
      Few<M> across;
      for (int i = 0; i < M; ++i) across[i] = 0.5 * (gain_bar[i] * precision + s_bar * H[i]) - with_gain[i];
      for (int i = 0; i < M; ++i) {
        add(across[i], H, P_bar[i]);
        add(H[i], across, P_bar[i]);
      }
      // d cos(2πx/λ)/d ln λ = (2πx/λ) sin, and of sin minus that of cos
      for (std::size_t wave = 0; wave < wavelengths.size(); ++wave) {
        const std::size_t cosine = columns - 2 * (wavelengths.size() - wave), sine = cosine + 1;
        const double* const h = observations_.columns[k].data();
        result.log_wavelengths[wave] -= std::numbers::pi * observation.place / wavelengths[wave] *
                                        (v_bar[cosine] * h[sine] - v_bar[sine] * h[cosine]);
      }
    }
    if (k == 0) break;
    const auto& before = steps.steps[k - 1];
    const Transition<M>& A = step.transition;
    States<M, M> away = before.predicted;  // covariance - stationary covariance, after the previous observation
    States<M, N> states = before.series;
    for (int i = 0; i < M; ++i) add(-1, limit[i], away[i]);
    if (before.scale > 0) {
      const double deviation = 1 / before.scale;
      for (int i = 0; i < M; ++i) {
        add(-before.gain[i] * deviation * deviation, before.gain, away[i]);
        add(before.gain[i] * deviation, white_[k - 1], states[i]);
      }
    }
    // A_bar = states_bar states' + 2 P_bar A away
    const Transition<M> back = transposed(A);
    const States<M, M> half = transposed<M>(back * P_bar), through = back * half;
    if constexpr (G > 0) {
      const Transition<M> stretched{product(companion, A.of_g), 0};  // the slope of A
      const States<M, N> moved = stretched * states;
      const States<M, M> moved_away = stretched * away;
      double sum = 0;
      for (int i = 0; i < G; ++i) sum += dot(states_bar[i], moved[i]) + 2 * dot(half[i], moved_away[i]);
      by_log_length -= steps.rate * (observation.place - observations_.all[k - 1].place) * sum;
    }
    if (observation.rows == 1 || (observation.rows > 1 && at_.correlation > 0)) {
      double by_power = dot(states_bar[G], states[G]);
      for (int i = 0; i < M; ++i) by_power += 2 * half[G][i] * away[i][G];
      by_correlation += by_power * (observation.rows == 1 ? 1 : observation.rows * A.of_e / at_.correlation);
    }
    for (int i = 0; i < M; ++i) {
      add(1, P_bar[i], limit_bar[i]);
      add(-1, through[i], limit_bar[i]);
    }
    P_bar = through;
    states_bar = back * states_bar;
  }
  double by_log_roughness = 0;  // the stationary covariance scales with σ² and σ_g²
  for (int i = 0; i < G; ++i)
    for (int j = 0; j < G; ++j) by_log_roughness += 2 * limit[i][j] * (limit_bar[i][j] + P_bar[i][j]);
  const double by_log_noise = 2 * limit[G][G] * (limit_bar[G][G] + P_bar[G][G]);
  result.hyperparameters = {-0.5 * by_log_noise, -0.5 * by_correlation, -0.5 * by_log_roughness, -0.5 * by_log_length};
  return result;
}

}  // namespace flexslip
