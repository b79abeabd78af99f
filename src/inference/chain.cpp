#include "inference/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "data/names.h"
#include "inference/matern.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"
#include "numerics/require.h"

namespace flexslip {

// The Kalman filter whose state is a Matérn process, its derivatives and an AR(1) process.

namespace {

using Eigen::Index;

struct Parameters {
  double noise, correlation, roughness, rate;
};

Parameters parameters_of(Kernel kernel, const Hyperparameters& at) {
  return {at.noise, at.correlation, kernel == Kernel::none ? 0 : at.roughness,
          kernel == Kernel::none ? 0 : matern::rate_of(kernel) / at.length};
}

// What is known of a state of which nothing is seen. G numbers of g, then e.
template <int M>
StateMatrix<M> limit_of(const Parameters& p) {
  constexpr std::size_t G = M - 1;
  StateMatrix<M> limit{};
  if constexpr (G > 0) {
    constexpr auto P = matern::stationary<M - 1>();
    for (std::size_t i = 0; i < G; ++i)
      for (std::size_t j = 0; j < G; ++j) limit[j / 2][i][j % 2] = p.roughness * p.roughness * P.at_[i * G + j];
  }
  limit[G / 2][G][G % 2] = p.noise * p.noise;
  return limit;
}

// What an observation sees of the state: g and D e.
template <int M>
Few<M> seen_of_state(double D) {
  Few<M> H{};
  if (M > 1) H[0] = 1;
  H[M - 1] = D;  // of e, which is all there is without a kernel
  return H;
}

// How the state goes on from each observation to the next.
template <int M>
void find_transitions(const Observations& observations, const Parameters& p, chain::Steps<M>& steps) {
  const auto power = [&](double rows) {
    return p.correlation > 0 ? elementary::exp(rows * elementary::log(p.correlation)) : 0;
  };
  const std::size_t n = observations.all.size();
  KeptArray<double> decay(M > 1 ? n : 0);
  if constexpr (M > 1) {
    for (std::size_t k = 0; k < n; ++k)
      decay[k] = k == 0 ? 0 : -p.rate * (observations.all[k].place - observations.all[k - 1].place);
    const std::span all(decay.data(), n);
    elementary::exp(all, all);
  }
  for (std::size_t k = 0; k < n; ++k) {
    auto& step = steps.steps[k];
    const Observation& observation = observations.all[k];
    step.of_g = {};
    step.of_e = 0;
    if (k == 0) continue;
    if constexpr (M > 1) {
      const double distance = observation.place - observations.all[k - 1].place;
      step.of_g = matern::transition_over<M - 1>(p.rate * distance, decay[k]);
    }
    step.of_e = observation.rows == 0 ? 1 : observation.rows == 1 ? p.correlation : power(observation.rows);
  }
}

// The filter's covariances: what is known of the state before each observation, and what that tells of it.
template <int M>
class Covariances {
 public:
  explicit Covariances(const Parameters& p) : limit_(limit_of<M>(p)) {}

  void meet(const Observation& observation, chain::Step<M>& step) {
    constexpr std::size_t G = M - 1;
    const TransitionInPairs<M> A(step.of_g, step.of_e);
    away_ = A * transposed<M>(A * away_);
    double* predicted = step.predicted.data();
    for (std::size_t b = 0; b < pairs_of(M); ++b)
      for (std::size_t i = 0; i < M; ++i, predicted += 2) put(away_[b][i] + limit_[b][i], predicted);
    step.gain = {};
    step.deviation = step.scale = 0;
    if (!is_seen(observation)) return;
    const double D = observation.noise_gain;
    Row<M> with_seen;  // P H'
    for (std::size_t b = 0; b < pairs_of(M); ++b) {
      with_seen[b] = D * (away_[b][G] + limit_[b][G]);
      if (G > 0) with_seen[b] += away_[b][0] + limit_[b][0];
    }
    const Few<M> PH = numbers_of<M>(with_seen);
    const double innovation = (G > 0 ? PH[0] + D * PH[G] : D * PH[G]) + observation.variance;
    step.deviation = std::sqrt(innovation);
    step.scale = 1 / step.deviation;
    const double precision = 1 / innovation;
    for (std::size_t i = 0; i < M; ++i) step.gain[i] = PH[i] * precision;
    for (std::size_t b = 0; b < pairs_of(M); ++b)
      for (std::size_t i = 0; i < M; ++i) away_[b][i] -= step.gain[i] * with_seen[b];
  }

 private:
  StateMatrix<M> limit_, away_{};  // what is known where nothing is seen, and of it what is known away from that
};

template <int M>
StateMatrix<M> predicted_at(const chain::Step<M>& step) {
  StateMatrix<M> P;
  const double* from = step.predicted.data();
  for (PairOfStates<M>& columns : P)
    for (Pair& pair : columns) pair = pair_at(from), from += 2;
  return P;
}

// A state times a transition.
template <int M>
Few<M> carried(const Square<M - 1>& of_g, double of_e, const Few<M>& state) {
  constexpr std::size_t G = M - 1;
  Few<M> next{};
  for (std::size_t i = 0; i < G; ++i)
    for (std::size_t j = 0; j < G; ++j) next[i] += of_g.at_[i * G + j] * state[j];
  next[G] = of_e * state[G];
  return next;
}

// Series: the columns, then y, by pairs; an odd one goes with zeros.
constexpr std::size_t most_series = max_columns + 1;
constexpr std::size_t most_pairs = pairs_of(most_series);
using PairsOfSeries = std::array<Pair, most_pairs>;

constexpr double log_two_pi = 1.8378770664093454836;

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

namespace {

// The regression on the whitened columns: what is left of y, and of β.
struct Regression {
  CoefficientMatrix covariance;  // [1] of β: (B'B + 1/prior)^-1
  Coefficients beta;
  double log_likelihood;
};

Regression regression_of(const CoefficientMatrix& products, const Coefficients& with_y, double y_squared,
                         double log_variances, double seen, const std::vector<double>& prior) {
  CoefficientMatrix information = products;
  double log_prior = 0;
  for (std::size_t j = 0; j < prior.size(); ++j) {
    information(static_cast<Index>(j), static_cast<Index>(j)) += 1 / prior[j];
    log_prior += elementary::log(prior[j]);
  }
  const Eigen::LLT<CoefficientMatrix> factor(information);
  Regression r{.covariance = factor.solve(CoefficientMatrix::Identity(with_y.size(), with_y.size())),
               .beta = factor.solve(with_y),
               .log_likelihood = 0};
  double log_determinant = log_variances + log_prior;  // of the covariance of y
  for (Index j = 0; j < with_y.size(); ++j) log_determinant += 2 * elementary::log(factor.matrixLLT()(j, j));
  r.log_likelihood = -0.5 * (seen * log_two_pi + y_squared - r.beta.dot(with_y) + log_determinant);
  return r;
}

using SeriesMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_series, most_series>;

// Of each two series, over all observations; four of these at once, as the sums are kept in memory.
SeriesMatrix products_of(const double* white, std::size_t observations, std::size_t series) {
  const std::size_t row = 2 * pairs_of(series);
  std::array<PairsOfSeries, most_series> sums{};  // of each with those before it and itself
  constexpr std::size_t at_once = 4;
  std::size_t k = 0;
  for (; k + at_once <= observations; k += at_once) {
    const double *const a = white + k * row, *const b = a + row, *const c = b + row, *const d = c + row;
    for (std::size_t j = 0; j < series; ++j)
      for (std::size_t i = 0; i <= j; i += 2)
        sums[j][i / 2] +=
            (a[j] * pair_at(a + i) + b[j] * pair_at(b + i)) + (c[j] * pair_at(c + i) + d[j] * pair_at(d + i));
  }
  for (; k < observations; ++k) {
    const double* const a = white + k * row;
    for (std::size_t j = 0; j < series; ++j)
      for (std::size_t i = 0; i <= j; i += 2) sums[j][i / 2] += a[j] * pair_at(a + i);
  }
  const auto count = static_cast<Index>(series);
  SeriesMatrix products(count, count);
  for (Index j = 0; j < count; ++j)
    for (Index i = 0; i <= j; ++i)
      products(i, j) = products(j, i) = sums[static_cast<std::size_t>(j)][static_cast<std::size_t>(i / 2)][i % 2];
  return products;
}

// y and the columns in the filter.
template <int M>
class SeriesFilter {
 public:
  // What they add at each observation, over its deviation, and what is expected of their states there, are put to these places.
  SeriesFilter(std::size_t columns, double* white, double* predicted)
      : columns_(columns), white_(white), predicted_(predicted) {}

  void meet(const double* h, double y, double noise_gain, const chain::Step<M>& step) {
    constexpr std::size_t G = M - 1;
    const TransitionInPairs<M> A(step.of_g, step.of_e);
    const PairOfStates<M> gain = spread<M>(step.gain);
    const Pair D = both(noise_gain), scale = both(step.scale);
    double *white = white_, *predicted = predicted_;
    const auto filter = [&](PairOfStates<M>& state, Pair v) {
      state = A * state;
      for (std::size_t i = 0; i < M; ++i, predicted += 2) put(state[i], predicted);
      if constexpr (G > 0) v -= state[0];
      v -= D * state[G];
      for (std::size_t i = 0; i < M; ++i) state[i] += gain[i] * v;
      put(scale * v, white);
      white += 2;
    };
    for (std::size_t b = 0; b < columns_ / 2; ++b) filter(states_[b], pair_at(h + 2 * b));
    filter(states_[columns_ / 2], columns_ % 2 == 1 ? Pair{h[columns_ - 1], y} : Pair{y, 0});
    white_ = white;
    predicted_ = predicted;
  }

 private:
  std::array<PairOfStates<M>, most_pairs> states_{};
  std::size_t columns_;
  double *white_, *predicted_;
};

}  // namespace

Chain::Chain(const Observations& observations, Kernel kernel, const Hyperparameters& at)
    : observations_(observations), kernel_(kernel), at_(at) {
  require_domain(observations, kernel, at);
  const std::size_t n = observations.all.size();
  const std::size_t columns = observations.prior.size(), series = 1 + columns, pairs = pairs_of(series);
  effort_spent += n * series;
  white_ = KeptArray<double>(2 * pairs * n);
  elementary::LogProduct deviations;
  double seen = 0;
  matern::with_order_of(kernel, [&](auto order) {
    constexpr int M = decltype(order)::value + 1;
    const auto p = parameters_of(kernel, at);
    chain::Steps<M> steps{.steps = KeptArray<chain::Step<M>>(n), .rate = p.rate};
    find_transitions<M>(observations, p, steps);
    predicted_ = KeptArray<double>(n * M * 2 * pairs);
    Covariances<M> covariances(p);
    SeriesFilter<M> filter(columns, white_.data(), predicted_.data());
    for (std::size_t k = 0; k < n; ++k) {
      const Observation& observation = observations.all[k];
      auto& step = steps.steps[k];
      covariances.meet(observation, step);
      filter.meet(observations.columns[k].data(), is_seen(observation) ? observations.values[k] : 0,
                  observation.noise_gain, step);
      if (is_seen(observation)) {
        deviations.multiply(step.deviation);
        seen += 1;
      }
    }
    steps_ = std::move(steps);
  });
  const auto p = static_cast<Index>(columns);
  const SeriesMatrix products = products_of(white_.data(), n, series);
  const auto r = regression_of(products.topLeftCorner(p, p), products.col(p).head(p), products(p, p),
                               2 * deviations.value(), seen, observations.prior);
  log_likelihood_ = r.log_likelihood;
  beta_ = by_readings_ = r.beta;
  covariance_ = r.covariance;
  if (observations.pull.size() > 0) beta_ += covariance_ * observations.pull;
}

namespace {

// A further series in the filter: what it adds at each observation, over its deviation, and what was expected of g there.
template <int M>
void filter_one(const Observations& observations, const chain::Steps<M>& steps, std::span<const double> series,
                std::span<double> white, std::span<double> expected) {
  constexpr std::size_t G = M - 1;
  Few<M> m{};
  for (std::size_t k = 0; k < series.size(); ++k) {
    const auto& step = steps.steps[k];
    m = carried<M>(step.of_g, step.of_e, m);
    const double g = G > 0 ? m[0] : 0;
    if (!expected.empty()) expected[k] = g;
    const double v = series[k] - g - observations.all[k].noise_gain * m[G];
    for (std::size_t i = 0; i < M; ++i) m[i] += step.gain[i] * v;
    white[k] = step.scale * v;
  }
}

}  // namespace

void Chain::whiten(std::span<const double> series, std::span<double> out) const {
  effort_spent += series.size();
  std::visit([&](const auto& steps) { filter_one(observations_, steps, series, out, {}); }, steps_);
}

void Chain::whiten(std::span<const Eight> series, std::span<Eight> out) const {
  constexpr std::size_t lanes = std::tuple_size_v<Eight>;
  effort_spent += lanes * series.size();
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        constexpr std::size_t G = M - 1;
        std::array<Eight, M> m{}, next;
        for (std::size_t k = 0; k < series.size(); ++k) {
          const auto& step = steps.steps[k];
          next = {};
          for (std::size_t i = 0; i < G; ++i)
            for (std::size_t j = 0; j < G; ++j)
              for (std::size_t l = 0; l < lanes; ++l) next[i][l] += step.of_g.at_[i * G + j] * m[j][l];
          for (std::size_t l = 0; l < lanes; ++l) next[G][l] = step.of_e * m[G][l];
          m = next;
          const double gain_of_noise = observations_.all[k].noise_gain, scale = step.scale;
          Eight v = series[k];
          for (std::size_t l = 0; l < lanes; ++l) v[l] -= (G > 0 ? m[0][l] : 0) + gain_of_noise * m[G][l];
          for (std::size_t i = 0; i < M; ++i)
            for (std::size_t l = 0; l < lanes; ++l) m[i][l] += step.gain[i] * v[l];
          for (std::size_t l = 0; l < lanes; ++l) out[k][l] = v[l] * scale;
        }
      },
      steps_);
}

Chain::Means Chain::means_of(std::span<const double> values) const {
  const std::size_t n = values.size();
  effort_spent += 3 * n;
  Means means{.f = std::vector<double>(n), .beta = {}};
  std::vector<double> rest(values.begin(), values.end()), white(n), expected(n);
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        constexpr std::size_t G = M - 1;
        filter_one(observations_, steps, rest, white, {});
        const Eigen::Map<const Eigen::VectorXd> whitened(white.data(), static_cast<Index>(n));
        Coefficients told = (whitened_columns() * whitened).head(static_cast<Index>(observations_.prior.size()));
        if (observations_.pull.size() > 0) told += observations_.pull;
        means.beta = covariance_ * told;
        for (std::size_t k = 0; k < n; ++k) {
          means.f[k] = observations_.columns[k].dot(means.beta);
          rest[k] -= means.f[k];
        }
        if constexpr (G == 0) return;
        filter_one(observations_, steps, rest, white, expected);
        Few<M> r{};  // as in smoothed()
        for (std::size_t k = n; k-- > 0;) {
          const auto& step = steps.steps[k];
          if (is_seen(observations_.all[k])) {
            double sum = step.scale * white[k];
            for (std::size_t i = 0; i < M; ++i) sum -= step.gain[i] * r[i];
            r[0] += sum;
            r[G] += observations_.all[k].noise_gain * sum;
          }
          means.f[k] += expected[k] + numbers_of<M>(product<M>(r, predicted_at(step)))[0];
          r = carried<M>(transposed(step.of_g), step.of_e, r);
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
  const std::size_t n = observations_.all.size();
  const std::size_t series = 1 + observations_.prior.size();
  std::vector<SmoothedObservation> result(n);
  std::size_t first_place = 0;  // that is no reading: before it no variance is asked for
  while (first_place < n && observations_.all[first_place].is_reading()) ++first_place;
  const std::size_t columns = series - 1, pairs = pairs_of(series);
  PairsOfSeries together{};  // y less what the columns explain
  std::array<PairsOfSeries, max_columns> covariance{};
  together[columns / 2][columns % 2] = 1;
  for (std::size_t c = 0; c < columns; ++c) {
    together[c / 2][c % 2] = -beta_[static_cast<Index>(c)];
    for (std::size_t d = 0; d < columns; ++d)
      covariance[c][d / 2][d % 2] = covariance_(static_cast<Index>(c), static_cast<Index>(d));
  }
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        constexpr std::size_t G = M - 1;
        // What the observations from here on say of the state: together, column by column, and how precisely.
        Few<M> r{};
        std::array<PairOfStates<M>, most_pairs> of_columns{};
        StateMatrix<M> N{};
        for (std::size_t k = n; k-- > 0;) {
          const auto& step = steps.steps[k];
          const Observation& observation = observations_.all[k];
          const bool variances = k >= first_place;
          const double* const white = white_.data() + k * 2 * pairs;
          const double* const predicted = predicted_.data() + k * M * 2 * pairs;
          Pair white_together{};
          PairOfStates<M> expected{};
          for (std::size_t b = 0; b < pairs; ++b) {
            white_together += pair_at(white + 2 * b) * together[b];
            for (std::size_t i = 0; i < M; ++i) expected[i] += pair_at(predicted + 2 * (b * M + i)) * together[b];
          }
          // r <- H v/s + (1 - K H)' r, and so for N
          if (is_seen(observation)) {
            const double D = observation.noise_gain;
            const double sum = step.scale * sum_of(white_together) - dot<M>(step.gain, r);
            if (G > 0) r[0] += sum;
            r[G] += D * sum;
            if (variances) {
              const PairOfStates<M> gain = spread<M>(step.gain);
              for (std::size_t b = 0; b < pairs; ++b) {
                PairOfStates<M>& state = of_columns[b];
                Pair u = both(step.scale) * pair_at(white + 2 * b);
                for (std::size_t i = 0; i < M; ++i) u -= gain[i] * state[i];
                if (G > 0) state[0] += u;
                state[G] += both(D) * u;
              }
              const Row<M> N_gain = product<M>(step.gain, N);
              const Few<M> H = seen_of_state<M>(D), Ng = numbers_of<M>(N_gain);
              const Row<M> H_row = row_of<M>(H);
              const double g = dot<M>(step.gain, Ng) + step.scale * step.scale;
              for (std::size_t b = 0; b < pairs_of(M); ++b)
                for (std::size_t i = 0; i < M; ++i) N[b][i] += (g * H[i] - Ng[i]) * H_row[b] - H[i] * N_gain[b];
            }
          }
          const StateMatrix<M> P = predicted_at(step);
          const Few<M> by_later = numbers_of<M>(product<M>(r, P));
          const auto mean_of = [&](std::size_t i) { return sum_of(expected[i]) + by_later[i]; };
          const Coefficients& h = observations_.columns[k];
          result[k].e = mean_of(G);
          result[k].f = h.dot(beta_) + (G > 0 ? mean_of(0) : 0);
          if constexpr (G > 1) result[k].slope = steps.rate * mean_of(1);
          result[k].variance = not_a_number;
          if (!observation.is_reading()) {
            double own = 0;  // variance at given β
            PairsOfSeries left{};
            for (std::size_t c = 0; c < columns; ++c) left[c / 2][c % 2] = h[static_cast<Index>(c)];
            if constexpr (G > 0) {
              Row<M> of_g;
              for (std::size_t b = 0; b < pairs_of(M); ++b) of_g[b] = P[b][0];
              const Few<M> Pg = numbers_of<M>(of_g);
              own = Pg[0] - dot<M>(Pg, numbers_of<M>(product<M>(Pg, N)));
              const PairOfStates<M> known = spread<M>(Pg);
              for (std::size_t b = 0; b < pairs; ++b) {
                left[b] -= pair_at(predicted + 2 * b * M);
                for (std::size_t j = 0; j < M; ++j) left[b] -= known[j] * of_columns[b][j];
              }
            }
            Pair of_beta{};
            for (std::size_t c = 0; c < columns; ++c) {
              Pair sum{};
              for (std::size_t b = 0; b < pairs; ++b) sum += covariance[c][b] * left[b];
              of_beta += left[c / 2][c % 2] * sum;
            }
            result[k].variance = own + sum_of(of_beta);
          }
          if (k == 0) break;
          const TransitionInPairs<M> back = TransitionInPairs<M>(step.of_g, step.of_e).transposed();
          r = carried<M>(transposed(step.of_g), step.of_e, r);
          if (k <= first_place) continue;
          for (std::size_t b = 0; b < pairs; ++b) of_columns[b] = back * of_columns[b];
          N = back * transposed<M>(back * N);
        }
      },
      steps_);
  if (const auto* steps = std::get_if<chain::Steps<2>>(&steps_)) {
    // Between two observations the mean of an exponential kernel is a sum of exponentials, which bends at each of them.
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

namespace {

// The slope of a transition to the distance, in units of 1/rate; of e none.
template <int M>
TransitionInPairs<M> by_distance(const chain::Step<M>& step) {
  if constexpr (M == 1)
    return {};
  else
    return {product(matern::companion<M - 1>(), step.of_g), 0};
}

}  // namespace

template <int M>
LikelihoodGradient Chain::gradient_of(const chain::Steps<M>& steps, std::span<const double> wavelengths) const {
  constexpr std::size_t G = M - 1;
  const std::size_t n = observations_.all.size();
  const std::size_t columns = observations_.prior.size(), series = 1 + columns, pairs = pairs_of(series);
  effort_spent += n * 2 * series;
  const Parameters parameters = parameters_of(kernel_, at_);
  const StateMatrix<M> limit = limit_of<M>(parameters);
  // -2 ln p(y) = Σ ln s + v' Q v/s + ..., s being the variance of what an observation adds to the series and v what it adds: derivatives by the
  // adjoints of their states, of the covariance of these, and of what is known where nothing is seen.
  std::array<PairsOfSeries, 2 * most_pairs> Q{};
  Q[columns][columns / 2][columns % 2] = 1;
  for (std::size_t c = 0; c < columns; ++c) {
    const auto i = static_cast<Index>(c);
    Q[columns][c / 2][c % 2] = Q[c][columns / 2][columns % 2] = -by_readings_[i];
    for (std::size_t d = 0; d < columns; ++d) {
      const auto j = static_cast<Index>(d);
      Q[c][d / 2][d % 2] = by_readings_[i] * by_readings_[j] + covariance_(i, j);
    }
  }
  std::array<PairOfStates<M>, most_pairs> by_states{};
  StateMatrix<M> by_covariance{}, by_limit{};
  double by_correlation = 0, by_log_length = 0;
  LikelihoodGradient result{.value = log_likelihood_, .hyperparameters = {}, .log_wavelengths = {}};
  for (std::size_t k = n; k-- > 0;) {
    const Observation& observation = observations_.all[k];
    const auto& step = steps.steps[k];
    const std::size_t one_before = k > 0 ? k - 1 : 0;
    const auto& before = steps.steps[one_before];
    const double* const white = white_.data() + k * 2 * pairs;
    const double* const white_before = white_.data() + one_before * 2 * pairs;
    const double* predicted = predicted_.data() + one_before * M * 2 * pairs;
    const TransitionInPairs<M> back = TransitionInPairs<M>(step.of_g, step.of_e).transposed();
    const TransitionInPairs<M> stretched = by_distance(step);  // F A, the slope of A
    const Few<M> H = seen_of_state<M>(observation.noise_gain);
    const PairOfStates<M> gain = spread<M>(step.gain), gain_before = spread<M>(before.gain);
    const Pair deviation = both(step.deviation), twice_scale = both(2 * step.scale), D = both(H[G]);
    const Pair deviation_before = both(before.deviation);
    PairsOfSeries by_series;
    std::array<Pair, 2 * most_pairs> own;
    for (std::size_t c = 0; c < 2 * pairs; ++c) own[c] = both(white[c]);
    Pair by_form{}, by_stretch{}, by_e{};  // of v' Q v/s, and of the states' transition
    PairOfStates<M> by_gains{};
    for (std::size_t b = 0; b < pairs; ++b) {
      PairOfStates<M> by_state = by_states[b];
      Pair weighted{};
      for (std::size_t c = 0; c < 2 * pairs; c += 2) weighted += own[c] * Q[c][b] + own[c + 1] * Q[c + 1][b];
      const Pair white_v = pair_at(white + 2 * b), v = deviation * white_v;
      by_form += white_v * weighted;
      Pair by_v = twice_scale * weighted;
      for (std::size_t i = 0; i < M; ++i) {
        by_gains[i] += v * by_state[i];
        by_v += gain[i] * by_state[i];
      }
      by_series[b] = by_v;
      if (G > 0) by_state[0] -= by_v;
      by_state[G] -= D * by_v;
      // What was known of the states after the observation before.
      const Pair learnt = deviation_before * pair_at(white_before + 2 * b);
      PairOfStates<M> known;
      for (std::size_t i = 0; i < M; ++i, predicted += 2) known[i] = pair_at(predicted) + gain_before[i] * learnt;
      by_e += by_state[G] * known[G];
      known = stretched * known;
      for (std::size_t i = 0; i < G; ++i) by_stretch += by_state[i] * known[i];
      by_states[b] = back * by_state;
    }
    if (is_seen(observation)) {
      // d cos(2πx/λ)/d ln λ = (2πx/λ) sin, and of sin minus that of cos
      for (std::size_t wave = 0; wave < wavelengths.size(); ++wave) {
        const std::size_t cosine = columns - 2 * (wavelengths.size() - wave), sine = cosine + 1;
        const double phase = 2 * std::numbers::pi * observation.place / wavelengths[wave];
        const double* const h = observations_.columns[k].data();
        result.log_wavelengths[wave] -=
            0.5 * phase * (by_series[cosine / 2][cosine % 2] * h[sine] - by_series[sine / 2][sine % 2] * h[cosine]);
      }
      // P - K s K', K = P H'/s, s = H P H' + variance
      Few<M> by_gain;
      for (std::size_t i = 0; i < M; ++i) by_gain[i] = sum_of(by_gains[i]);
      const double precision = step.scale * step.scale;
      const Few<M> with_gain = numbers_of<M>(product<M>(step.gain, by_covariance));
      const double by_variance =
          (1 - sum_of(by_form) - dot<M>(by_gain, step.gain)) * precision + dot<M>(step.gain, with_gain);
      Few<M> across;
      for (std::size_t i = 0; i < M; ++i)
        across[i] = 0.5 * (by_gain[i] * precision + by_variance * H[i]) - with_gain[i];
      const Row<M> H_row = row_of<M>(H), across_row = row_of<M>(across);
      for (std::size_t b = 0; b < pairs_of(M); ++b)
        for (std::size_t i = 0; i < M; ++i) by_covariance[b][i] += across[i] * H_row[b] + H[i] * across_row[b];
    }
    if (k == 0) break;
    StateMatrix<M> away = predicted_at(before);  // from what is known where nothing is seen
    Few<M> learnt;                               // of it by the observation before
    for (std::size_t i = 0; i < M; ++i) learnt[i] = before.deviation * before.gain[i];
    const Row<M> learnt_row = row_of<M>(learnt);
    for (std::size_t b = 0; b < pairs_of(M); ++b)
      for (std::size_t i = 0; i < M; ++i) away[b][i] -= limit[b][i] + learnt[i] * learnt_row[b];
    // limit + A (P - limit) A', and A of the states
    const StateMatrix<M> half = transposed<M>(back * by_covariance), through = back * half;
    const StateMatrix<M> moved = stretched * away;
    Pair by_A{};
    for (std::size_t b = 0; b < pairs_of(M); ++b)
      for (std::size_t i = 0; i < M; ++i) {
        by_limit[b][i] += by_covariance[b][i] - through[b][i];
        by_A += half[b][i] * moved[b][i];
      }
    by_covariance = through;
    const double distance = observation.place - observations_.all[k - 1].place;
    by_log_length -= parameters.rate * distance * (2 * sum_of(by_A) + sum_of(by_stretch));
    if (observation.rows == 1 || (observation.rows > 1 && parameters.correlation > 0)) {
      double by_power = sum_of(by_e);
      for (std::size_t i = 0; i < M; ++i) by_power += 2 * half[i / 2][G][i % 2] * away[G / 2][i][G % 2];
      const double slope = observation.rows == 1 ? 1 : observation.rows * step.of_e / parameters.correlation;
      by_correlation += by_power * slope;
    }
  }
  double by_log_roughness = 0;
  for (std::size_t i = 0; i < G; ++i)
    for (std::size_t j = 0; j < G; ++j)
      by_log_roughness += 2 * limit[j / 2][i][j % 2] * (by_limit[j / 2][i] + by_covariance[j / 2][i])[j % 2];
  const double by_log_noise = 2 * limit[G / 2][G][G % 2] * (by_limit[G / 2][G] + by_covariance[G / 2][G])[G % 2];
  result.hyperparameters = {-0.5 * by_log_noise, -0.5 * by_correlation, -0.5 * by_log_roughness, -0.5 * by_log_length};
  return result;
}

}  // namespace flexslip
