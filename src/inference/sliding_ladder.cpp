#include "inference/sliding_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "fibre/elastica.h"

namespace flexslip {
namespace {

// tan of half the angle of friction: in it Ψ is smooth enough for the degree used (its singularities lie at ±i).
double half_angle_tangent(double q) { return q / (1 + std::sqrt(1 + q * q)); }

// Chebyshev coefficients of a function sampled at the n Chebyshev points of the first kind.
std::vector<double> chebyshev_coefficients(const std::vector<double>& samples) {
  const auto n = samples.size();
  std::vector<double> coefficients(n);
  for (std::size_t k = 0; k < n; ++k) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      sum += samples[j] * std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(j) + 0.5) /
                                   static_cast<double>(n));
    coefficients[k] = (k == 0 ? 1.0 : 2.0) / static_cast<double>(n) * sum;
  }
  return coefficients;
}

double chebyshev_sum(std::span<const double> coefficients, double x) {
  double b1 = 0;
  double b2 = 0;
  for (std::size_t k = coefficients.size(); k-- > 1;) {
    const double b0 = coefficients[k] + 2 * x * b1 - b2;
    b2 = b1;
    b1 = b0;
  }
  return coefficients[0] + x * b1 - b2;
}

// Coefficients in powers of t in [0, t_max] of a polynomial given in Chebyshev form.
std::vector<double> power_coefficients(const std::vector<double>& chebyshev, double t_max) {
  const auto n = chebyshev.size();
  std::vector<double> previous(n, 0.0), current(n, 0.0), result(n, 0.0);
  // T_k as polynomials in x = 2 t/t_max - 1, by their recurrence, directly in powers of τ = t/t_max.
  previous[0] = 1;
  current[0] = -1;
  if (n > 1) current[1] = 2;
  for (std::size_t k = 0; k < n; ++k) {
    const auto& T = k == 0 ? previous : current;
    for (std::size_t i = 0; i < n; ++i) result[i] += chebyshev[k] * T[i];
    if (k == 0) continue;
    std::vector<double> next(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      next[i] += -2 * current[i] - previous[i];
      if (i > 0) next[i] += 4 * current[i - 1];
    }
    previous = current;
    current = next;
  }
  double scale = 1;
  for (auto& value : result) {
    value *= scale;
    scale /= t_max;
  }
  return result;
}

}  // namespace

SlidingMap::SlidingMap(double S_max, double S_step, double mu_max) : mu_max_(mu_max) {
  if (!(S_max > 1 && S_max <= 2.1))
    throw std::invalid_argument("S_max must lie in (1, 2.1], not " + std::to_string(S_max));
  if (!(S_step > 0)) throw std::invalid_argument("S_step must be positive, not " + std::to_string(S_step));
  if (!(mu_max > 0 && mu_max <= 5))
    throw std::invalid_argument("mu_max must lie in (0, 5], not " + std::to_string(mu_max));
  const double sigma_max = std::sqrt(S_max - 1);
  const auto n = static_cast<std::size_t>(std::ceil(2 * sigma_max * sigma_max / S_step)) + 2;
  sigma_step_ = sigma_max / static_cast<double>(n - 1);
  S_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double sigma = sigma_step_ * static_cast<double>(i);
    S_[i] = 1 + sigma * sigma;
  }

  // w/σ and F/σ at a product grid of Chebyshev points in σ and t, then as powers of t at each length.
  constexpr std::size_t sigma_points = 28;
  constexpr std::size_t t_points = degree + 1;
  const double t_max = half_angle_tangent(mu_max);
  const auto point = [](std::size_t j, std::size_t count) {
    return std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(count));
  };
  std::array<std::vector<std::vector<double>>, 2> in_powers;  // [quantity][power][σ coefficient]
  std::array<std::vector<std::vector<double>>, 2> samples;
  for (auto& quantity : samples) quantity.assign(sigma_points, std::vector<double>(t_points));
  for (std::size_t i = 0; i < sigma_points; ++i) {
    const double sigma = 0.5 * sigma_max * (1 + point(i, sigma_points));
    for (std::size_t j = 0; j < t_points; ++j) {
      const double t = 0.5 * t_max * (1 + point(j, t_points));
      const auto state = fibre_state(1 + sigma * sigma, 2 * t / (1 - t * t));
      samples[0][i][j] = state.w / sigma;
      samples[1][i][j] = state.F / sigma;
    }
  }
  w_.resize(t_points * n);
  F_.resize(t_points * n);
  for (std::size_t quantity = 0; quantity < 2; ++quantity) {
    std::vector<std::vector<double>> columns(t_points, std::vector<double>(sigma_points));
    for (std::size_t i = 0; i < sigma_points; ++i) {
      const auto powers = power_coefficients(chebyshev_coefficients(samples[quantity][i]), t_max);
      for (std::size_t p = 0; p < t_points; ++p) columns[p][i] = powers[p];
    }
    auto& rows = quantity == 0 ? w_ : F_;
    for (std::size_t p = 0; p < t_points; ++p) {
      const auto coefficients = chebyshev_coefficients(columns[p]);
      for (std::size_t i = 0; i < n; ++i) {
        const double fraction = static_cast<double>(i) / static_cast<double>(n - 1);
        rows[p * n + i] = sigma_max * fraction * chebyshev_sum(coefficients, 2 * fraction - 1);
      }
    }
  }
}

SlidingMap::Curve SlidingMap::curve(std::span<const double> mu) const {
  const auto n = S_.size();
  std::vector<double> t(n);
  for (std::size_t i = 0; i < n; ++i) t[i] = half_angle_tangent(std::clamp(mu[i], 0.0, mu_max_));
  Curve curve{std::vector<double>(w_.end() - static_cast<std::ptrdiff_t>(n), w_.end()),
              std::vector<double>(F_.end() - static_cast<std::ptrdiff_t>(n), F_.end())};
  for (std::size_t p = degree; p-- > 0;)
    for (std::size_t i = 0; i < n; ++i) {
      curve.w[i] = curve.w[i] * t[i] + w_[p * n + i];
      curve.F[i] = curve.F[i] * t[i] + F_[p * n + i];
    }
  return curve;
}

SlidingMap::Curve SlidingMap::slopes(std::span<const double> mu) const {
  const auto n = S_.size();
  std::vector<double> t(n);
  for (std::size_t i = 0; i < n; ++i) t[i] = half_angle_tangent(std::clamp(mu[i], 0.0, mu_max_));
  Curve slopes{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  for (std::size_t p = degree; p > 0; --p) {
    const auto power = static_cast<double>(p);
    for (std::size_t i = 0; i < n; ++i) {
      slopes.w[i] = slopes.w[i] * t[i] + power * w_[p * n + i];
      slopes.F[i] = slopes.F[i] * t[i] + power * F_[p * n + i];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    // dt/dq of the half-angle tangent, (1 - t^2)^2/(2 (1 + t^2))
    const double t2 = t[i] * t[i];
    const double t_q = (1 - t2) * (1 - t2) / (2 * (1 + t2));
    slopes.w[i] *= t_q;
    slopes.F[i] *= t_q;
  }
  return slopes;
}

namespace {

// The cubic over one cell through two values with slopes from the values around (central differences).
struct Cubic {
  double value, d0, c2, c3;
  Cubic(std::span<const double> y, std::size_t i) {
    const auto last = y.size() - 1;
    const double rise = y[i + 1] - y[i];
    value = y[i];
    d0 = i > 0 ? 0.5 * (y[i + 1] - y[i - 1]) : rise;
    const double d1 = i + 1 < last ? 0.5 * (y[i + 2] - y[i]) : rise;
    c2 = 3 * rise - 2 * d0 - d1;
    c3 = d0 + d1 - 2 * rise;
  }
  double at(double x) const { return value + x * (d0 + x * (c2 + x * c3)); }
  double slope(double x) const { return d0 + x * (2 * c2 + x * 3 * c3); }
  // The greatest of its second derivative in [0, 1].
  double curvature() const { return std::max(std::abs(2 * c2), std::abs(2 * c2 + 6 * c3)); }
  // Where it is greatest in [0, 1].
  double peak() const {
    if (d0 <= 0) return 0;
    if (slope(1) >= 0) return 1;
    // the slope changes sign once from + to -
    const double root = std::sqrt(std::max(c2 * c2 - 3 * d0 * c3, 0.0));
    return std::clamp(d0 / (root - c2), 0.0, 1.0);
  }
};

}  // namespace

MeasuredCurve measured_curve(std::span<const double> w, std::span<const double> F, double compliance,
                             std::span<const double> stages) {
  const auto n = w.size();
  std::vector<double> G(n);
  for (std::size_t i = 0; i < n; ++i) G[i] = w[i] + compliance * F[i];
  MeasuredCurve result;
  result.F.reserve(stages.size());
  std::size_t cell = 0;
  double passed = 0;  // fraction of the cell that the running maximum has passed
  for (const double stage : stages) {
    double x = 1;
    for (; cell + 1 < n; ++cell, passed = 0) {
      // Where both ends of a cell fall short of the stage position, G can reach it between them only if it turns over there.
      const bool short_of = G[cell + 1] < stage && G[cell] < stage;
      const bool turns_here = G[cell + 1] < G[cell] && (cell == 0 || G[cell - 1] < G[cell]);
      const bool turns_next = cell + 2 < n && G[cell] < G[cell + 1] && G[cell + 2] < G[cell + 1];
      if (short_of && !turns_here && !turns_next) continue;
      const Cubic cubic(G, cell);
      const double peak = cubic.peak();
      if (cubic.at(peak) < stage || peak < passed) continue;
      // G rises from `passed` to the peak: Newton's iteration within these bounds
      double low = passed;
      double high = peak;
      x = std::clamp((stage - cubic.value) / (cubic.at(peak) - cubic.value) * peak, low, high);
      for (int iteration = 0; iteration < 20; ++iteration) {
        const double miss = cubic.at(x) - stage;
        (miss < 0 ? low : high) = x;
        const double newton = x - miss / cubic.slope(x);
        const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
        // Newton's error after a step d is d² G''/2G': below 1e-6 of a cell it is less than that of the interpolation.
        const double d = next - x;
        const bool done = std::abs(d) < 1e-6 || (next == newton && d * d * cubic.curvature() < 1e-6 * cubic.slope(x));
        x = next;
        if (done) break;
      }
      passed = x;
      break;
    }
    const std::size_t i = std::min(cell, n - 2);
    const Cubic force(F, i);
    const Cubic position(G, i);
    result.F.push_back(force.at(x));
    result.cell.push_back(i);
    result.fraction.push_back(x);
    result.F_slope.push_back(force.slope(x));
    result.G_slope.push_back(position.slope(x));
  }
  return result;
}

}  // namespace flexslip
