#include "inference/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

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
Square<M> limit_of(const Parameters& p) {
  constexpr int G = M - 1;
  Square<M> limit{};
  if constexpr (G > 0) {
    constexpr auto P = matern::stationary<G>();
    for (int i = 0; i < G; ++i)
      for (int j = 0; j < G; ++j) limit(i, j) = p.roughness * p.roughness * P(i, j);
  }
  limit(G, G) = p.noise * p.noise;
  return limit;
}

// The filter's covariances: what it knows of the state before each observation.
template <int M>
class Covariances {
 public:
  static constexpr int G = M - 1;

  explicit Covariances(const Parameters& p) : p_(p), limit_(limit_of<M>(p)), P_(limit_) {}

  // To an observation from the one before.
  void advance(double distance, double rows) {
    if constexpr (G > 0) {
      const auto A = matern::transition_over<G>(p_.rate * distance);
      for (int i = 0; i < G; ++i)
        for (int j = 0; j < G; ++j) A_(i, j) = A(i, j);
    }
    A_(G, G) = rows == 0 ? 1 : rows == 1 ? p_.correlation : power(rows);
    Square<M> half;  // A (P - P of the limit), which ends where nothing is known
    for (int i = 0; i < M; ++i)
      for (int j = 0; j < M; ++j) {
        double sum = 0;
        if (i < G) {
          for (int k = 0; k < G; ++k) sum += A_(i, k) * (P_(k, j) - limit_(k, j));
        } else {
          sum = A_(G, G) * (P_(G, j) - limit_(G, j));
        }
        half(i, j) = sum;
      }
    for (int i = 0; i < M; ++i)
      for (int j = i; j < M; ++j) {
        double sum = limit_(i, j);
        if (j < G) {
          for (int k = 0; k < G; ++k) sum += half(i, k) * A_(j, k);
        } else {
          sum += half(i, G) * A_(G, G);
        }
        P_(i, j) = P_(j, i) = sum;
      }
  }

  // The variance of what an observation adds, and what it tells of the state.
  double observe(double D, double variance, Few<M>& gain) {
    Few<M> PH;
    for (int i = 0; i < M; ++i) PH[at(i)] = G > 0 ? P_(i, 0) + D * P_(i, G) : D * P_(i, G);
    const double innovation = (G > 0 ? PH[0] + D * PH[at(G)] : D * PH[at(G)]) + variance;
    for (int i = 0; i < M; ++i) gain[at(i)] = PH[at(i)] / innovation;
    for (int i = 0; i < M; ++i)
      for (int j = i; j < M; ++j) P_(i, j) = P_(j, i) = P_(i, j) - gain[at(i)] * PH[at(j)];
    return innovation;
  }

  const Square<M>& covariance() const { return P_; }
  const Square<M>& transition() const { return A_; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  double power(double rows) const {
    return p_.correlation > 0 ? elementary::exp(rows * elementary::log(p_.correlation)) : 0;
  }

  Parameters p_;
  Square<M> limit_, P_, A_{};
};

// A number for y and for each column. Local arrays, which nothing else can point to, and sums in four parts: compilers make vectors of both.
constexpr std::size_t most_series = max_columns + 1;
using Series = std::array<double, most_series>;

double dot(const double* a, const double* b, std::size_t n) {
  std::array<double, 4> parts{};
  std::size_t c = 0;
  for (; c + 4 <= n; c += 4)
    for (std::size_t part = 0; part < 4; ++part) parts[part] += a[c + part] * b[c + part];
  double sum = (parts[0] + parts[2]) + (parts[1] + parts[3]);
  for (; c < n; ++c) sum += a[c] * b[c];
  return sum;
}
double dot(const Series& a, const Series& b, std::size_t n) { return dot(a.data(), b.data(), n); }

void add(Series& to, double factor, const Series& what, std::size_t n) {
  for (std::size_t c = 0; c < n; ++c) to[c] += factor * what[c];
}

// All states A times themselves; g and e do not mix.
template <int M>
void carry(std::array<Series, static_cast<std::size_t>(M)>& states, const Square<M>& A, std::size_t n) {
  constexpr std::size_t G = M - 1;
  for (std::size_t c = 0; c < n; ++c) {
    Few<M> next;
    for (std::size_t i = 0; i < G; ++i) {
      next[i] = A.at_[i * M] * states[0][c];
      for (std::size_t k = 1; k < G; ++k) next[i] += A.at_[i * M + k] * states[k][c];
    }
    next[G] = A.at_[G * M + G] * states[G][c];
    for (std::size_t i = 0; i < M; ++i) states[i][c] = next[i];
  }
}

// The states of many series at once, a row for each number of the state.
template <int M>
class States {
 public:
  static constexpr std::size_t G = M - 1;

  explicit States(std::size_t series) : n_(series) {}

  void advance(const Square<M>& A) { carry(m_, A, n_); }

  // From what an observation differs from what was expected, which takes the place of its values.
  void learn(Series& values, double D, const Few<M>& gain) {
    if constexpr (G > 0) add(values, -1, m_[0], n_);
    add(values, -D, m_[G], n_);
    for (std::size_t i = 0; i < M; ++i) add(m_[i], gain[i], values, n_);
  }
  double* copy_to(double* out) const {
    for (const Series& row : m_)
      for (std::size_t c = 0; c < n_; ++c) *out++ = row[c];
    return out;
  }

 private:
  std::size_t n_;
  std::array<Series, M> m_{};
};

// What a function makes of the size of the state.
template <class Result, class Function>
Result with_state_of(Kernel kernel, Function function) {
  switch (kernel) {
    case Kernel::none:
      return function(std::integral_constant<int, 1>());
    case Kernel::exponential:
      return function(std::integral_constant<int, 2>());
    case Kernel::matern_3_2:
      return function(std::integral_constant<int, 3>());
    case Kernel::matern_5_2:
      return function(std::integral_constant<int, 4>());
    case Kernel::matern_9_2:
      break;
  }
  return function(std::integral_constant<int, 6>());
}

constexpr double log_two_pi = 1.8378770664093454836;

}  // namespace

std::string_view name_of(Kernel kernel) {
  return name_in_order<Kernel::matern_9_2>(kernel, {"none", "exponential", "matern_3_2", "matern_5_2", "matern_9_2"});
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

Regression regression_of(const CoefficientMatrix& products, const Coefficients& with_y, double y_squared,
                         double log_variances, double seen, const std::vector<double>& prior) {
  Regression r;
  r.information = products;
  double log_prior = 0;
  for (std::size_t j = 0; j < prior.size(); ++j) {
    r.information(static_cast<Index>(j), static_cast<Index>(j)) += 1 / prior[j];
    log_prior += elementary::log(prior[j]);
  }
  r.factor.compute(r.information);
  r.beta = r.factor.solve(with_y);
  r.log_determinant = log_variances + log_prior;
  for (Index j = 0; j < r.information.rows(); ++j) r.log_determinant += 2 * elementary::log(r.factor.matrixLLT()(j, j));
  r.log_likelihood = -0.5 * (seen * log_two_pi + y_squared - r.beta.dot(with_y) + r.log_determinant);
  return r;
}

CoefficientMatrix covariance_of(const Regression& regression) {
  const Index p = regression.beta.size();
  return regression.factor.solve(CoefficientMatrix::Identity(p, p));
}

namespace {

using SeriesMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_columns + 1, max_columns + 1>;

// Of each two series, over all observations; four of these at once, as the sums are kept in memory.
SeriesMatrix products_of(const Eigen::Map<const Eigen::MatrixXd>& white) {
  const auto series = static_cast<std::size_t>(white.rows());
  std::array<Series, most_series> sums{};
  constexpr Index at_once = 4;
  Index k = 0;
  for (; k + at_once <= white.cols(); k += at_once) {
    const double* const a = white.col(k).data();
    const double *const b = a + series, *const c = b + series, *const d = c + series;
    for (std::size_t j = 0; j < series; ++j)
      for (std::size_t i = 0; i <= j; ++i)
        sums[j][i] = sums[j][i] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + d[i] * d[j];
  }
  for (; k < white.cols(); ++k) {
    const double* const a = white.col(k).data();
    for (std::size_t j = 0; j < series; ++j)
      for (std::size_t i = 0; i <= j; ++i) sums[j][i] += a[i] * a[j];
  }
  SeriesMatrix products(white.rows(), white.rows());
  for (std::size_t j = 0; j < series; ++j)
    for (std::size_t i = 0; i <= j; ++i) {
      const auto row = static_cast<Index>(i), column = static_cast<Index>(j);
      products(row, column) = products(column, row) = sums[j][i];
    }
  return products;
}

}  // namespace

Chain::Chain(const Observations& observations, Kernel kernel, const Hyperparameters& at)
    : observations_(observations), kernel_(kernel), at_(at) {
  require_domain(observations, kernel, at);
  const std::size_t n = observations.all.size();
  const std::size_t columns = observations.prior.size();
  const std::size_t series = 1 + columns;
  effort_spent += n * series;
  white_ = KeptArray<double>(series * n);
  elementary::LogProduct variances;
  double seen = 0;
  with_state_of<void>(kernel, [&](auto size) {
    constexpr int M = decltype(size)::value;
    const auto p = parameters_of(kernel, at);
    chain::Steps<M> steps{.steps = KeptArray<chain::Step<M>>(n), .rate = p.rate};
    Covariances<M> covariances(p);
    States<M> states(series);
    predicted_ = KeptArray<double>(n * M * series);
    double* predicted = predicted_.data();
    for (std::size_t k = 0; k < n; ++k) {
      const Observation& observation = observations.all[k];
      auto& step = steps.steps[k];
      if (k > 0) {
        covariances.advance(observation.place - observations.all[k - 1].place, observation.rows);
        states.advance(covariances.transition());
      }
      step.transition = covariances.transition().at_;
      step.predicted = covariances.covariance().at_;
      predicted = states.copy_to(predicted);
      if (!is_seen(observation)) {
        step.innovation = infinity;
        step.gain = {};
        std::fill_n(white_.data() + k * series, series, 0.0);
        continue;
      }
      step.innovation = covariances.observe(observation.noise_gain, observation.variance, step.gain);
      const double scale = 1 / std::sqrt(step.innovation);
      variances.multiply(step.innovation);
      seen += 1;
      Series v;
      v[0] = observations.values[k];
      const double* const h = observations.columns[k].data();
      for (std::size_t c = 0; c < columns; ++c) v[1 + c] = h[c];
      states.learn(v, observation.noise_gain, step.gain);
      double* const white = white_.data() + k * series;
      for (std::size_t c = 0; c < series; ++c) white[c] = v[c] * scale;
    }
    steps_ = std::move(steps);
  });
  const auto p = static_cast<Index>(columns);
  const SeriesMatrix products = products_of(whitened_columns());
  const auto r = regression_of(products.bottomRightCorner(p, p), products.col(0).tail(p), products(0, 0),
                               variances.value(), seen, observations.prior);
  log_likelihood_ = r.log_likelihood;
  log_determinant_ = r.log_determinant;
  beta_ = by_readings_ = r.beta;
  covariance_ = covariance_of(r);
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
    if (k > 0) {
      Few<M> next{};
      for (std::size_t i = 0; i < G; ++i)
        for (std::size_t j = 0; j < G; ++j) next[i] += step.transition[i * M + j] * m[j];
      next[G] = step.transition[G * M + G] * m[G];
      m = next;
    }
    const double g = G > 0 ? m[0] : 0;
    if (!expected.empty()) expected[k] = g;
    if (!is_seen(observations.all[k])) {
      white[k] = 0;
      continue;
    }
    const double v = series[k] - g - observations.all[k].noise_gain * m[G];
    for (std::size_t i = 0; i < M; ++i) m[i] += step.gain[i] * v;
    white[k] = v / std::sqrt(step.innovation);
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
          if (k > 0) {
            next = {};
            for (std::size_t i = 0; i < M; ++i)
              for (std::size_t j = i < G ? 0 : G; j < (i < G ? G : M); ++j)  // g and e do not mix
                for (std::size_t l = 0; l < lanes; ++l) next[i][l] += step.transition[i * M + j] * m[j][l];
            m = next;
          }
          if (!is_seen(observations_.all[k])) {
            out[k] = {};
            continue;
          }
          const double gain_of_noise = observations_.all[k].noise_gain, scale = 1 / std::sqrt(step.innovation);
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
        Coefficients told = (whitened_columns() * whitened).tail(static_cast<Index>(observations_.prior.size()));
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
            double sum = white[k] / std::sqrt(step.innovation);
            for (std::size_t i = 0; i < M; ++i) sum -= step.gain[i] * r[i];
            r[0] += sum;
            r[G] += observations_.all[k].noise_gain * sum;
          }
          means.f[k] += expected[k];
          for (std::size_t j = 0; j < M; ++j) means.f[k] += step.predicted[j] * r[j];
          if (k > 0) r = product(transposed(Square<M>{step.transition}), r);
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
  const Coefficients left = a - products.tail(p);
  const Coefficients with_beta = covariance_ * left;
  return {.mean = a.dot(beta_) + products[0] - products.tail(p).dot(beta_),
          .variance = variance - whitened.squaredNorm() + left.dot(with_beta),
          .with_beta = with_beta};
}

std::vector<SmoothedObservation> Chain::smoothed() const {
  const std::size_t n = observations_.all.size();
  const std::size_t series = 1 + observations_.prior.size();
  std::vector<SmoothedObservation> result(n);
  std::size_t first_place = 0;  // that is no reading: before it no variance is asked for
  while (first_place < n && observations_.all[first_place].is_reading()) ++first_place;
  Series together{};  // y less what the columns explain
  together[0] = 1;
  for (std::size_t c = 1; c < series; ++c) together[c] = -beta_[static_cast<Index>(c - 1)];
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        constexpr int G = M - 1;
        // What the observations from here on say of the state: together, column by column, and how precisely.
        Few<M> r{};
        std::array<Series, M> of_columns{};
        Series u{}, left{};
        Square<M> N{};
        for (std::size_t k = n; k-- > 0;) {
          const auto& step = steps.steps[k];
          const Observation& observation = observations_.all[k];
          const bool variances = k >= first_place;
          const double* const white = white_.data() + k * series;
          const double* const predicted = predicted_.data() + k * M * series;
          if (is_seen(observation)) {
            // r <- H v/s + (1 - K H)' r, and so for N
            const double scale = 1 / std::sqrt(step.innovation);
            double sum = scale * dot(white, together.data(), series);
            for (std::size_t i = 0; i < M; ++i) sum -= step.gain[i] * r[i];
            if (G > 0) r[0] += sum;
            r[G] += observation.noise_gain * sum;
            if (variances) {
              for (std::size_t c = 1; c < series; ++c) u[c] = white[c] * scale;
              for (std::size_t i = 0; i < M; ++i)
                for (std::size_t c = 1; c < series; ++c) u[c] -= step.gain[i] * of_columns[i][c];
              for (std::size_t c = 1; c < series; ++c) {
                if (G > 0) of_columns[0][c] += u[c];
                of_columns[G][c] += observation.noise_gain * u[c];
              }
              Few<M> H{};
              if (G > 0) H[0] = 1;
              H[G] = observation.noise_gain;  // of e, which is all there is without a kernel
              const Few<M> Ng = product(N, step.gain);
              const double g = dot<M>(step.gain, Ng) + 1 / step.innovation;
              for (std::size_t i = 0; i < M; ++i)
                for (std::size_t j = 0; j < M; ++j) N.at_[i * M + j] += g * H[i] * H[j] - H[i] * Ng[j] - Ng[i] * H[j];
            }
          }
          const auto mean_of = [&](std::size_t i) {
            double sum = dot(predicted + i * series, together.data(), series);
            for (std::size_t j = 0; j < M; ++j) sum += step.predicted[i * M + j] * r[j];
            return sum;
          };
          const Coefficients& h = observations_.columns[k];
          result[k].e = mean_of(G);
          result[k].f = h.dot(beta_) + (G > 0 ? mean_of(0) : 0);
          if constexpr (G > 1) result[k].slope = steps.rate * mean_of(1);
          result[k].variance = not_a_number;
          if (!observation.is_reading()) {
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
              own += left[c] * dot(&left[1], covariance_.col(static_cast<Index>(c - 1)).data(), series - 1);
            result[k].variance = own;
          }
          if (k == 0) break;
          const Square<M> A{step.transition}, A_transposed = transposed(A);
          r = product(A_transposed, r);
          if (k <= first_place) continue;
          carry(of_columns, A_transposed, series);
          N = product(product(A_transposed, N), A);
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

template <int M>
LikelihoodGradient Chain::gradient_of(const chain::Steps<M>& steps, std::span<const double> wavelengths) const {
  constexpr int G = M - 1;
  const std::size_t n = observations_.all.size();
  const auto series = 1 + observations_.prior.size();
  effort_spent += n * 2 * series;
  const Parameters parameters = parameters_of(kernel_, at_);
  const Square<M> limit = limit_of<M>(parameters);
  // -2 ln p(y) = Σ ln s + v' Q v/s + ..., s being the variance of what an observation adds to the series and v what it adds: derivatives by the
  // adjoints of their states, of the covariance of these, and of what is known where nothing is seen.
  std::array<Series, most_series> Q{};
  Q[0][0] = 1;
  for (std::size_t c = 1; c < series; ++c) {
    Q[0][c] = Q[c][0] = -by_readings_[static_cast<Index>(c - 1)];
    for (std::size_t d = 1; d < series; ++d) {
      const auto i = static_cast<Index>(c - 1), j = static_cast<Index>(d - 1);
      Q[c][d] = by_readings_[i] * by_readings_[j] + covariance_(i, j);
    }
  }
  std::array<Series, M> by_states{}, known;
  Square<M> by_covariance{}, by_limit{};
  Series v, by_v, white, weighted;
  double by_correlation = 0, by_log_length = 0;
  LikelihoodGradient result{.value = log_likelihood_, .hyperparameters = {}, .log_wavelengths = {}};
  for (std::size_t k = n; k-- > 0;) {
    const Observation& observation = observations_.all[k];
    const auto& step = steps.steps[k];
    if (is_seen(observation)) {
      const double size = std::sqrt(step.innovation);
      for (std::size_t c = 0; c < series; ++c) {
        white[c] = white_.data()[k * series + c];
        weighted[c] = 0;
      }
      for (std::size_t c = 0; c < series; ++c) add(weighted, white[c], Q[c], series);
      for (std::size_t c = 0; c < series; ++c) {
        v[c] = size * white[c];
        by_v[c] = 2 / size * weighted[c];
      }
      Few<M> by_gain;
      for (std::size_t i = 0; i < M; ++i) {
        by_gain[i] = dot(v, by_states[i], series);
        add(by_v, step.gain[i], by_states[i], series);
      }
      if (G > 0) add(by_states[0], -1, by_v, series);
      add(by_states[G], -observation.noise_gain, by_v, series);
      // d cos(2πx/λ)/d ln λ = (2πx/λ) sin, and of sin minus that of cos
      for (std::size_t wave = 0; wave < wavelengths.size(); ++wave) {
        const std::size_t cosine = series - 2 * (wavelengths.size() - wave);
        const double phase = 2 * std::numbers::pi * observation.place / wavelengths[wave];
        const double* const h = observations_.columns[k].data() - 1;
        result.log_wavelengths[wave] -= 0.5 * phase * (by_v[cosine] * h[cosine + 1] - by_v[cosine + 1] * h[cosine]);
      }
      // P - K s K', K = P H'/s, s = H P H' + variance
      const Few<M> with_gain = product(by_covariance, step.gain);
      const double by_variance = (1 - dot(white, weighted, series) - dot<M>(by_gain, step.gain)) / step.innovation +
                                 dot<M>(step.gain, with_gain);
      Few<M> H{};
      if (G > 0) H[0] = 1;
      H[G] = observation.noise_gain;  // of e, which is all there is without a kernel
      Few<M> across;
      for (std::size_t i = 0; i < M; ++i)
        across[i] = 0.5 * (by_gain[i] / step.innovation + by_variance * H[i]) - with_gain[i];
      for (int i = 0; i < M; ++i)
        for (int j = 0; j < M; ++j) {
          const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
          by_covariance(i, j) += across[a] * H[b] + H[a] * across[b];
        }
    }
    if (k == 0) break;
    const auto& before = steps.steps[k - 1];
    const double* const predicted = predicted_.data() + (k - 1) * M * series;
    for (std::size_t i = 0; i < M; ++i)
      for (std::size_t c = 0; c < series; ++c) known[i][c] = predicted[i * series + c];
    Square<M> away{before.predicted};  // from what is known where nothing is seen
    for (std::size_t i = 0; i < away.at_.size(); ++i) away.at_[i] -= limit.at_[i];
    if (is_seen(observations_.all[k - 1])) {
      const double size = std::sqrt(before.innovation);
      for (std::size_t c = 0; c < series; ++c) v[c] = size * white_.data()[(k - 1) * series + c];
      for (int i = 0; i < M; ++i) {
        const double gain = before.gain[static_cast<std::size_t>(i)];
        add(known[static_cast<std::size_t>(i)], gain, v, series);
        for (int j = 0; j < M; ++j) away(i, j) -= before.innovation * gain * before.gain[static_cast<std::size_t>(j)];
      }
    }
    // limit + A (P - limit) A', and A of the states
    const Square<M> A{step.transition}, A_transposed = transposed(A);
    const Square<M> half = product(by_covariance, A), through = product(A_transposed, half);
    for (std::size_t i = 0; i < through.at_.size(); ++i) by_limit.at_[i] += by_covariance.at_[i] - through.at_[i];
    by_covariance = through;
    Square<M> by_A = product(half, away);
    for (int i = 0; i < M; ++i)
      for (int j = 0; j < M; ++j) {
        if ((i < G) != (j < G)) continue;  // g and e do not mix
        by_A(i, j) =
            2 * by_A(i, j) + dot(by_states[static_cast<std::size_t>(i)], known[static_cast<std::size_t>(j)], series);
      }
    carry(by_states, A_transposed, series);
    if constexpr (G > 0) {
      constexpr auto F = matern::companion<G>();
      const double distance = observation.place - observations_.all[k - 1].place;
      double sum = 0;  // of F A, the slope of A
      for (int i = 0; i < G; ++i)
        for (int j = 0; j < G; ++j) {
          double slope = 0;
          for (int m = 0; m < G; ++m) slope += F(i, m) * A(m, j);
          sum += slope * by_A(i, j);
        }
      by_log_length -= parameters.rate * distance * sum;
    }
    if (observation.rows == 1) by_correlation += by_A(G, G);
    if (observation.rows > 1 && parameters.correlation > 0)
      by_correlation += by_A(G, G) * observation.rows * A(G, G) / parameters.correlation;
  }
  double by_log_roughness = 0;
  for (int i = 0; i < G; ++i)
    for (int j = 0; j < G; ++j) by_log_roughness += 2 * limit(i, j) * (by_limit(i, j) + by_covariance(i, j));
  const double by_log_noise = 2 * limit(G, G) * (by_limit(G, G) + by_covariance(G, G));
  result.hyperparameters = {-0.5 * by_log_noise, -0.5 * by_correlation, -0.5 * by_log_roughness, -0.5 * by_log_length};
  return result;
}

namespace {

// L, of which L L' is a covariance; none where rounding leaves it none.
template <int G>
Square<G> root_of(Square<G> L, double roughness) {
  for (int i = 0; i < G; ++i) L(i, i) += 1e-14 * roughness * roughness;  // rounding makes no variance negative
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
  with_state_of<void>(kernel, [&](auto size) {
    constexpr int M = decltype(size)::value, G = M - 1;
    const Parameters p = parameters_of(kernel, at);
    if constexpr (G > 0) {
      const Square<M> of_all = limit_of<M>(p);
      Square<G> limit{};
      for (int i = 0; i < G; ++i)
        for (int j = 0; j < G; ++j) limit(i, j) = of_all(i, j);
      const auto add = [&](const Square<G>& transition, const Square<G>& added) {
        const Square<G> root = root_of(added, p.roughness);
        steps_.insert(steps_.end(), transition.at_.begin(), transition.at_.end());
        steps_.insert(steps_.end(), root.at_.begin(), root.at_.end());
      };
      for (std::size_t k = 0; k < observations.all.size(); ++k) {
        if (k == 0) {
          add({}, limit);
          continue;
        }
        const auto A = matern::transition_over<G>(p.rate * (observations.all[k].place - observations.all[k - 1].place));
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
