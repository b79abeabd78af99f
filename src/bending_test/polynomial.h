// Polynomials on [-1, 1] or [0, 1], by their Chebyshev or Bernstein coefficients, and their zeros.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace flexslip {

struct ValueAndSlope {
  double value, slope;
};

// A Chebyshev series at t in [-1, 1] (Clenshaw).
template <std::size_t size>
double series_at(const std::array<double, size>& c, double t) {
  double b1 = 0;
  double b2 = 0;
  for (std::size_t k = size - 1; k > 0; --k) b2 = std::exchange(b1, c[k] + 2 * t * b1 - b2);
  return c[0] + t * b1 - b2;
}

// The same with its derivative, which is Σ c_k k U_{k-1}.
template <std::size_t size>
ValueAndSlope series_slope_at(const std::array<double, size>& c, double t) {
  double b1 = 0;
  double b2 = 0;
  double d1 = 0;
  double d2 = 0;
  for (std::size_t k = size - 1; k > 0; --k) {
    d2 = std::exchange(d1, static_cast<double>(k) * c[k] + 2 * t * d1 - d2);
    b2 = std::exchange(b1, c[k] + 2 * t * b1 - b2);
  }
  return {c[0] + t * b1 - b2, d1};
}

// The integral of a series that vanishes at -1, times `scale`.
template <std::size_t size>
std::array<double, size + 1> integrated(const std::array<double, size>& c, double scale) {
  std::array<double, size + 1> integral{};
  const auto coefficient = [&](std::size_t k) { return k < size ? c[k] : 0.0; };
  double at_start = 0;
  for (std::size_t k = 1; k <= size; ++k) {
    const double lower = k == 1 ? 2 * c[0] : coefficient(k - 1);
    integral[k] = scale * (lower - coefficient(k + 1)) / (2 * static_cast<double>(k));
    at_start += k % 2 ? -integral[k] : integral[k];
  }
  integral[0] = -at_start;
  return integral;
}

// A Bernstein polynomial and its derivative at t in [0, 1] (de Casteljau).
template <std::size_t size>
ValueAndSlope bernstein_at(std::array<double, size> b, double t) {
  double slope = 0;
  for (std::size_t n = size - 1; n > 0; --n) {
    if (n == 1) slope = static_cast<double>(size - 1) * (b[1] - b[0]);
    for (std::size_t i = 0; i < n; ++i) b[i] += t * (b[i + 1] - b[i]);
  }
  return {b[0], slope};
}

template <std::size_t size>
int sign_changes(const std::array<double, size>& b) {
  int changes = 0;
  for (std::size_t i = 0; i + 1 < size; ++i) changes += (b[i] < 0) != (b[i + 1] < 0);
  return changes;
}

// The zero of f(x), which gives a ValueAndSlope, between two points at which it has opposite signs.
// Method:     Newton's iteration from x, kept between the points, until a step is `close` or shorter: that doubles the digits once more.
template <class Function>
double zero_between(Function f, double low, double high, double x, bool rising, double close) {
  for (int iteration = 0; iteration < 60; ++iteration) {
    const auto [value, slope] = f(x);
    if (value == 0) return x;
    ((value < 0) == rising ? low : high) = x;
    double next = x - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - x);
    x = next;
    if (step <= close) break;
  }
  return x;
}

}  // namespace flexslip
