// Polynomials: their values, slopes and roots, interpolants through values and slopes, series of Chebyshev's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "numerics/elementary.h"

namespace flexslip {

// Polynomials on [-1, 1] or [0, 1], by their Chebyshev or Bernstein coefficients, and their zeros.

struct ValueAndSlope {
  double value, slope;
};

// The cubic over [0, 1] through two values with their slopes (Hermite), written from its beginning.
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

template <std::size_t size>
std::array<double, size - 1> derivative(const std::array<double, size>& c) {
  std::array<double, size - 1> slope{};
  for (std::size_t k = size - 1; k > 0; --k)
    slope[k - 1] = 2 * static_cast<double>(k) * c[k] + (k + 1 < size - 1 ? slope[k + 1] : 0);
  slope[0] *= 0.5;
  return slope;
}

// The product of two series, up to so many terms.
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

// The same polynomial over the first and over the second half.
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

// Polynomials through values at the Chebyshev-Lobatto points of [-1, 1].

// Linear maps from values at the nodes -cos(π j/n), j = 0, ..., n, where n is the degree; these include both ends.
template <std::size_t degree>
class Interpolant {
 public:
  using Values = std::array<double, degree + 1>;

  static double node(std::size_t j) { return maps().node[j]; }
  // Coefficients of T_0, ..., T_n.
  static Values chebyshev(const Values& at_nodes) { return apply(maps().chebyshev, at_nodes); }
  // Bernstein coefficients on [-1, 1]: the polynomial lies between the least and the greatest of them, and has no more zeros than
  // they have changes of sign (Descartes).
  static Values bernstein(const Values& at_nodes) { return apply(maps().bernstein, at_nodes); }

 private:
  using Matrix = std::array<Values, degree + 1>;  // a row for each node: sums of many coefficients side by side

  static Values apply(const Matrix& map, const Values& values) {
    Values result{};
    for (std::size_t j = 0; j <= degree; ++j)
      for (std::size_t i = 0; i <= degree; ++i) result[i] += map[j][i] * values[j];
    return result;
  }

  struct Maps {
    Values node{};
    Matrix chebyshev{};
    Matrix bernstein{};

    Maps() {
      const auto real = [](std::size_t i) { return static_cast<double>(i); };
      const auto binomial = [&](std::size_t n, std::size_t r) {
        double value = 1;
        for (std::size_t i = 1; i <= r; ++i) value = value * real(n - r + i) / real(i);
        return value;
      };
      const auto half_at_end = [](std::size_t i) { return i == 0 || i == degree ? 0.5 : 1.0; };
      // The cosine of π i/n, of an argument within a turn.
      const auto cosine = [&](std::size_t i) {
        return elementary::sine_and_cosine(std::numbers::pi * real(i % (2 * degree)) / real(degree)).cosine;
      };
      for (std::size_t j = 0; j <= degree; ++j) node[j] = -cosine(j);
      for (std::size_t k = 0; k <= degree; ++k)
        for (std::size_t j = 0; j <= degree; ++j)
          chebyshev[j][k] = (k % 2 == 0 ? 2.0 : -2.0) / real(degree) * half_at_end(j) * half_at_end(k) * cosine(k * j);
      // T_k = Σ_i (-1)^(k-i) C(2k, 2i)/C(k, i) B_i^k, raised from degree k to the full one.
      for (std::size_t i = 0; i <= degree; ++i)
        for (std::size_t k = 0; k <= degree; ++k) {
          double from_k = 0;
          for (std::size_t r = i + k > degree ? i + k - degree : 0; r <= std::min(i, k); ++r)
            from_k += ((k - r) % 2 == 0 ? 1.0 : -1.0) * binomial(2 * k, 2 * r) * binomial(degree - k, i - r);
          for (std::size_t j = 0; j <= degree; ++j) bernstein[j][i] += from_k / binomial(degree, i) * chebyshev[j][k];
        }
    }
  };

  static const Maps& maps() {
    static const Maps value;
    return value;
  }
};

}  // namespace flexslip
