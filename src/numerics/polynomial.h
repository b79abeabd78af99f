// Polynomials on [-1, 1] or [0, 1] by their Chebyshev or Bernstein coefficients: values, slopes,
// zeros; and cubics.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace flexslip {

struct ValueAndSlope {
  double value, slope;
};

// The cubic over [0, 1] through two values with two slopes (Hermite), in powers of t.
struct Cubic {
  double value, slope, c2, c3;
  Cubic(double from, double to, double slope_from, double slope_to)
      : value(from),
        slope(slope_from),
        c2(3 * (to - from) - 2 * slope_from - slope_to),
        c3(slope_from + slope_to - 2 * (to - from)) {}

  ValueAndSlope at(double t) const {
    return {value + t * (slope + t * (c2 + t * c3)), slope + t * (2 * c2 + t * 3 * c3)};
  }
};

// The value of a Chebyshev series at t in [-1, 1] (Clenshaw).
template <std::size_t size>
double series_at(const std::array<double, size>& c, double t) {
  double b1 = 0;
  double b2 = 0;
  for (std::size_t k = size - 1; k > 0; --k) b2 = std::exchange(b1, c[k] + 2 * t * b1 - b2);
  return c[0] + t * b1 - b2;
}

// The same at several points, four in parallel.
template <std::size_t size, std::size_t points>
std::array<double, points> series_at(const std::array<double, size>& c, const std::array<double, points>& t) {
  constexpr std::size_t width = 4;
  static_assert(points % width == 0);
  std::array<double, points> values;
  for (std::size_t first = 0; first < points; first += width) {
    std::array<double, width> twice, b1{}, b2{};
    for (std::size_t i = 0; i < width; ++i) twice[i] = 2 * t[first + i];
    for (std::size_t k = size - 1; k > 0; --k)
      for (std::size_t i = 0; i < width; ++i) b2[i] = std::exchange(b1[i], c[k] + twice[i] * b1[i] - b2[i]);
    for (std::size_t i = 0; i < width; ++i) values[first + i] = c[0] + t[first + i] * b1[i] - b2[i];
  }
  return values;
}

// The value and the derivative, Σ c_k k U_{k-1}.
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

// The integral of a series, times `scale`. It is 0 at -1.
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

template <std::size_t size>
std::array<double, size - 1> derivative(const std::array<double, size>& c) {
  std::array<double, size - 1> slope{};
  for (std::size_t k = size - 1; k > 0; --k)
    slope[k - 1] = 2 * static_cast<double>(k) * c[k] + (k + 1 < size - 1 ? slope[k + 1] : 0);
  slope[0] *= 0.5;
  return slope;
}

// The product of two series, truncated to `terms` terms.
template <std::size_t terms, std::size_t a_size, std::size_t b_size>
std::array<double, terms> product(const std::array<double, a_size>& a, const std::array<double, b_size>& b) {
  static_assert(terms >= a_size && terms >= b_size);
  std::array<double, terms> sum{};
  for (std::size_t i = 0; i < a_size; ++i)
    for (std::size_t j = 0; j < b_size; ++j) {
      const double half = 0.5 * a[i] * b[j];
      if (i + j < terms) sum[i + j] += half;
      sum[i > j ? i - j : j - i] += half;
    }
  return sum;
}

// The value and the derivative of a Bernstein polynomial at t in [0, 1] (de Casteljau).
template <std::size_t size>
ValueAndSlope bernstein_at(std::array<double, size> b, double t) {
  double slope = 0;
  for (std::size_t n = size - 1; n > 0; --n) {
    if (n == 1) slope = static_cast<double>(size - 1) * (b[1] - b[0]);
    for (std::size_t i = 0; i < n; ++i) b[i] += t * (b[i + 1] - b[i]);
  }
  return {b[0], slope};
}

// The Bernstein coefficients of the same polynomial on the first half and on the second.
template <std::size_t size>
std::array<std::array<double, size>, 2> bernstein_halves(const std::array<double, size>& b) {
  std::array<double, size> first, second = b;
  for (std::size_t n = size; n > 0; --n) {
    first[size - n] = second[0];
    for (std::size_t i = 0; i + 1 < n; ++i) second[i] = 0.5 * (second[i] + second[i + 1]);
  }
  return {first, second};
}

template <std::size_t size>
int sign_changes(const std::array<double, size>& b) {
  int changes = 0;
  for (std::size_t i = 0; i + 1 < size; ++i) changes += (b[i] < 0) != (b[i + 1] < 0);
  return changes;
}

}  // namespace flexslip
