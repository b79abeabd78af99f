#include "inference/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "data/names.h"
#include "inference/matern.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"

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

// The states of many series at once, a row for each number of the state.
template <int M>
class States {
 public:
  static constexpr int G = M - 1;

  explicit States(std::size_t series) : n_(series), m_(static_cast<std::size_t>(M) * series, 0.0), next_(m_) {}

  void advance(const Square<M>& A) {
    for (int i = 0; i < G; ++i)
      for (std::size_t c = 0; c < n_; ++c) {
        double sum = A(i, 0) * row(0)[c];
        for (int k = 1; k < G; ++k) sum = sum + A(i, k) * row(k)[c];
        next_[static_cast<std::size_t>(i) * n_ + c] = sum;
      }
    for (std::size_t c = 0; c < n_; ++c) next_[static_cast<std::size_t>(G) * n_ + c] = A(G, G) * row(G)[c];
    m_.swap(next_);
  }

  // By what an observation differs from what was expected, for one series.
  double innovation(double value, double D, std::size_t c) const {
    if constexpr (G > 0) return value - row(0)[c] - D * row(G)[c];
    return value - D * row(G)[c];
  }
  void learn(const std::array<double, M>& gain, double v, std::size_t c) {
    for (int i = 0; i < M; ++i) row(i)[c] = row(i)[c] + gain[static_cast<std::size_t>(i)] * v;
  }
  const std::vector<double>& all() const { return m_; }

 private:
  double* row(int i) { return m_.data() + static_cast<std::size_t>(i) * n_; }
  const double* row(int i) const { return m_.data() + static_cast<std::size_t>(i) * n_; }

  std::size_t n_;
  std::vector<double> m_, next_;
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

void require(bool ok, const char* name, double value) {
  if (!ok) throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + " is out of range");
}

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

std::size_t counting(Kernel kernel) { return kernel == Kernel::none ? 2 : 4; }

}  // namespace

Hyperparameters hyperparameters_of(const Theta& theta) {
  return {.noise = elementary::exp(theta.values[0]),
          .correlation = max_correlation / (1 + elementary::exp(-theta.values[1])),
          .roughness = elementary::exp(theta.values[2]),
          .length = elementary::exp(theta.values[3])};
}

ThetaPrior ThetaPrior::of(double range, double noise) {
  // Roughness that explained what is noise would leave none: second differences say how much there is, to a factor.
  constexpr double min_of_seen = 0.2;
  const double min_noise = std::max(0.0005, min_of_seen * noise);
  const double log_noise = elementary::log(min_noise), log_range = elementary::log(range);
  return {.mean = {elementary::log(0.03), -1, elementary::log(0.03), elementary::log(range / 10)},
          .deviation = {1, 1.5, 1, 1.2},
          .least = {log_noise, -6, elementary::log(0.001), log_range - 6},
          .greatest = {std::max(elementary::log(0.5), log_noise + 1), 6, elementary::log(0.6), log_range + 1}};
}

Theta ThetaPrior::usual(std::span<const double> log_wavelengths) const {
  Theta theta{};
  std::copy(mean.begin(), mean.end(), theta.values.begin());
  for (const double value : log_wavelengths) theta.values[4 + theta.waves++] = value;
  return theta;
}

void ThetaPrior::bound(Theta& theta) const {
  for (std::size_t i = 0; i < 4; ++i) theta.values[i] = std::clamp(theta.values[i], least[i], greatest[i]);
}

double ThetaPrior::log_density(Kernel kernel, const Theta& theta) const {
  double sum = 0;
  for (std::size_t i = 0; i < counting(kernel); ++i) {
    const double z = (theta.values[i] - mean[i]) / deviation[i];
    sum -= 0.5 * z * z;
  }
  return sum;
}

double ThetaPrior::log_scale(Kernel kernel) const {
  double sum = 0;
  for (std::size_t i = 0; i < counting(kernel); ++i)
    sum -= elementary::log(deviation[i]) + 0.5 * elementary::log(2 * std::numbers::pi);
  return sum;
}

double ThetaPrior::slope(const Theta& theta, std::size_t i) const {
  return -(theta.values[i] - mean[i]) / (deviation[i] * deviation[i]);
}

namespace {

using Series = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_columns + 1, 1>;
using SeriesMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_columns + 1, max_columns + 1>;

// Of each two series, over all observations.
SeriesMatrix products_of(const Eigen::MatrixXd& white) {
  const auto series = static_cast<std::size_t>(white.rows());
  constexpr std::size_t most = max_columns + 1;
  std::array<double, most * most> sums{};
  for (Index k = 0; k < white.cols(); ++k) {
    const double* const at = white.col(k).data();
    for (std::size_t j = 0; j < series; ++j)
      for (std::size_t i = 0; i <= j; ++i) sums[j * most + i] += at[i] * at[j];
  }
  SeriesMatrix products(white.rows(), white.rows());
  for (std::size_t j = 0; j < series; ++j)
    for (std::size_t i = 0; i <= j; ++i) {
      const auto row = static_cast<Index>(i), column = static_cast<Index>(j);
      products(row, column) = products(column, row) = sums[j * most + i];
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
  white_ = Eigen::MatrixXd::Zero(static_cast<Index>(series), static_cast<Index>(n));
  elementary::LogProduct variances;
  double seen = 0;
  with_state_of<void>(kernel, [&](auto size) {
    constexpr int M = decltype(size)::value;
    const auto p = parameters_of(kernel, at);
    chain::Steps<M> steps{.steps = std::vector<chain::Step<M>>(n), .rate = p.rate};
    Covariances<M> covariances(p);
    States<M> states(series);
    predicted_.resize(n * M * series);
    for (std::size_t k = 0; k < n; ++k) {
      const Observation& observation = observations.all[k];
      auto& step = steps.steps[k];
      if (k > 0) {
        covariances.advance(observation.place - observations.all[k - 1].place, observation.rows);
        states.advance(covariances.transition());
        step.transition = covariances.transition().at_;
      }
      step.predicted = covariances.covariance().at_;
      std::copy(states.all().begin(), states.all().end(),
                predicted_.begin() + static_cast<std::ptrdiff_t>(k * M * series));
      if (!is_seen(observation)) {
        step.innovation = infinity;
        step.gain = {};
        continue;
      }
      step.innovation = covariances.observe(observation.noise_gain, observation.variance, step.gain);
      const double scale = 1 / std::sqrt(step.innovation);
      variances.multiply(step.innovation);
      seen += 1;
      for (std::size_t c = 0; c < series; ++c) {
        const double value = c == 0 ? observations.values[k] : observations.columns[k][static_cast<Index>(c - 1)];
        const double v = states.innovation(value, observation.noise_gain, c);
        states.learn(step.gain, v, c);
        white_(static_cast<Index>(c), static_cast<Index>(k)) = v * scale;
      }
    }
    steps_ = std::move(steps);
  });
  const auto p = static_cast<Index>(columns);
  const SeriesMatrix products = products_of(white_);
  const auto r = regression_of(products.bottomRightCorner(p, p), products.col(0).tail(p), products(0, 0),
                               variances.value(), seen, observations.prior);
  log_likelihood_ = r.log_likelihood;
  log_determinant_ = r.log_determinant;
  beta_ = by_readings_ = r.beta;
  covariance_ = covariance_of(r);
  if (observations.pull.size() > 0) beta_ += covariance_ * observations.pull;
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
                    step.transition[Square<M>::place(i, j)] * m[static_cast<std::size_t>(j)];
            next[G] = step.transition[Square<M>::place(G, G)] * m[G];
            m = next;
          }
          if (!is_seen(observations_.all[k])) {
            out[k] = 0;
            continue;
          }
          const double v = series[k] - (G > 0 ? m[0] : 0) - observations_.all[k].noise_gain * m[G];
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
  const auto p = static_cast<Index>(observations_.prior.size());
  const Eigen::VectorXd products = white_ * whitened;
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
  std::array<double, max_columns + 1> together{};  // y less what the columns explain
  together[0] = 1;
  for (std::size_t c = 1; c < series; ++c) together[c] = -beta_[static_cast<Index>(c - 1)];
  std::visit(
      [&]<int M>(const chain::Steps<M>& steps) {
        constexpr int G = M - 1;
        // What the observations from here on say of the state: together, column by column, and how precisely.
        Few<M> r{};
        std::array<std::array<double, max_columns + 1>, M> of_columns{}, carried{};
        std::array<double, max_columns + 1> u{}, left{};
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
            double sum = 0;
            for (std::size_t c = 0; c < series; ++c) sum += white[c] * together[c];
            sum *= scale;
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
            double sum = 0;
            for (std::size_t c = 0; c < series; ++c) sum += predicted[i * series + c] * together[c];
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
              for (std::size_t d = 1; d < series; ++d)
                own += left[c] * left[d] * covariance_(static_cast<Index>(c - 1), static_cast<Index>(d - 1));
            result[k].variance = own;
          }
          if (k == 0) break;
          const Square<M> A{step.transition}, A_transposed = transposed(A);
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
  const Index series = white_.rows(), p = series - 1;
  effort_spent += n * static_cast<std::size_t>(2 * series);
  const Parameters parameters = parameters_of(kernel_, at_);
  const Square<M> limit = limit_of<M>(parameters);
  // -2 ln p(y) = Σ ln s + v' Q v/s + ..., s being the variance of what an observation adds to the series and v what it adds: derivatives by the
  // adjoints of their states, of the covariance of these, and of what is known where nothing is seen.
  SeriesMatrix Q(series, series);
  Q(0, 0) = 1;
  Q.row(0).tail(p) = -by_readings_.transpose();
  Q.col(0).tail(p) = -by_readings_;
  Q.bottomRightCorner(p, p) = by_readings_ * by_readings_.transpose() + covariance_;
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, M, 0, max_columns + 1, M>;
  Columns by_states = Columns::Zero(series, M), carried(series, M), known(series, M);
  Square<M> by_covariance{}, by_limit{};
  Series v(series), by_v(series), weighted(series);
  double by_correlation = 0, by_log_length = 0;
  LikelihoodGradient result{.value = log_likelihood_, .hyperparameters = {}, .log_wavelengths = {}};
  for (std::size_t k = n; k-- > 0;) {
    const Observation& observation = observations_.all[k];
    const auto column = static_cast<Index>(k);
    const auto& step = steps.steps[k];
    if (is_seen(observation)) {
      const double size = std::sqrt(step.innovation);
      v = size * white_.col(column);
      weighted.setZero();
      for (Index j = 0; j < series; ++j) weighted += white_(j, column) * Q.col(j);
      by_v = 2 / size * weighted;
      Few<M> by_gain;
      for (int i = 0; i < M; ++i) {
        const auto at = static_cast<std::size_t>(i);
        by_gain[at] = v.dot(by_states.col(i));
        by_v += step.gain[at] * by_states.col(i);
      }
      if (G > 0) by_states.col(0) -= by_v;
      by_states.col(G) -= observation.noise_gain * by_v;
      // d cos(2πx/λ)/d ln λ = (2πx/λ) sin, and of sin minus that of cos
      for (std::size_t wave = 0; wave < wavelengths.size(); ++wave) {
        const Index cosine = p - 2 * static_cast<Index>(wavelengths.size() - wave);
        const double phase = 2 * std::numbers::pi * observation.place / wavelengths[wave];
        const Coefficients& h = observations_.columns[k];
        result.log_wavelengths[wave] -= 0.5 * phase * (by_v[1 + cosine] * h[cosine + 1] - by_v[2 + cosine] * h[cosine]);
      }
      // P - K s K', K = P H'/s, s = H P H' + variance
      const Few<M> with_gain = product(by_covariance, step.gain);
      const double by_variance = (1 - white_.col(column).dot(weighted) - dot<M>(by_gain, step.gain)) / step.innovation +
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
    known = Eigen::Map<const Columns>(predicted_.data() + (column - 1) * M * series, series, M);
    Square<M> away{before.predicted};  // from what is known where nothing is seen
    for (std::size_t i = 0; i < away.at_.size(); ++i) away.at_[i] -= limit.at_[i];
    if (is_seen(observations_.all[k - 1])) {
      v = std::sqrt(before.innovation) * white_.col(column - 1);
      for (int i = 0; i < M; ++i) {
        const double gain = before.gain[static_cast<std::size_t>(i)];
        known.col(i) += gain * v;
        for (int j = 0; j < M; ++j) away(i, j) -= before.innovation * gain * before.gain[static_cast<std::size_t>(j)];
      }
    }
    // limit + A (P - limit) A', and A of the states
    const Square<M> A{step.transition}, A_transposed = transposed(A);
    const Square<M> half = product(by_covariance, A), through = product(A_transposed, half);
    for (std::size_t i = 0; i < through.at_.size(); ++i) by_limit.at_[i] += by_covariance.at_[i] - through.at_[i];
    by_covariance = through;
    Square<M> by_A = product(half, away);
    carried.setZero();
    for (int i = 0; i < M; ++i)
      for (int j = 0; j < M; ++j) {
        if ((i < G) != (j < G)) continue;  // g and e do not mix
        by_A(i, j) = 2 * by_A(i, j) + by_states.col(i).dot(known.col(j));
        carried.col(j) += A(i, j) * by_states.col(i);
      }
    by_states.swap(carried);
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

// The process drawn beforehand, at given β: g and e at each observation.
template <int M>
void draw_states(const Observations& observations, const Parameters& p, NormalSource& normal, Drawn& drawn) {
  constexpr int G = M - 1;
  constexpr int size = G > 0 ? G : 1;
  using Matrix = Square<size>;
  const Square<M> of_all = limit_of<M>(p);
  Matrix limit{};
  for (int i = 0; i < G; ++i)
    for (int j = 0; j < G; ++j) limit(i, j) = of_all(i, j);
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
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    const Observation& observation = observations.all[k];
    if (k > 0) {
      if constexpr (G > 0) {
        const Matrix A = matern::transition_over<G>(p.rate * (observation.place - observations.all[k - 1].place));
        Matrix added = product(product(A, limit), transposed(A));
        for (std::size_t i = 0; i < added.at_.size(); ++i) added.at_[i] = limit.at_[i] - added.at_[i];
        g = product(A, g);
        const auto more = some(added);
        for (std::size_t i = 0; i < size; ++i) g[i] += more[i];
      }
      if (observation.rows > 0) {
        const double kept = p.correlation > 0 ? elementary::exp(observation.rows * elementary::log(p.correlation)) : 0;
        e = kept * e + std::sqrt(1 - kept * kept) * p.noise * normal();
      }
    }
    drawn.f[k] += g[0];
    drawn.values[k] = drawn.f[k] + observation.noise_gain * e +
                      (is_seen(observation) ? std::sqrt(observation.variance) * normal() : 0);
  }
}

}  // namespace

double NormalSource::operator()() {
  const auto uniform = [&] { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2 * elementary::log(uniform()));
  return radius * elementary::sine_and_cosine(2 * std::numbers::pi * uniform()).cosine;
}

Drawn draw_from_prior(const Observations& observations, Kernel kernel, const Hyperparameters& at,
                      NormalSource& normal) {
  require_domain(observations, kernel, at);
  const std::size_t n = observations.all.size();
  Drawn drawn{.beta = Coefficients(static_cast<Index>(observations.prior.size())),
              .f = std::vector<double>(n),
              .values = std::vector<double>(n)};
  for (std::size_t j = 0; j < observations.prior.size(); ++j)
    drawn.beta[static_cast<Index>(j)] = std::sqrt(observations.prior[j]) * normal();
  for (std::size_t k = 0; k < n; ++k) drawn.f[k] = observations.columns[k].dot(drawn.beta);
  with_state_of<void>(
      kernel, [&](auto M) { draw_states<decltype(M)::value>(observations, parameters_of(kernel, at), normal, drawn); });
  return drawn;
}

}  // namespace flexslip
