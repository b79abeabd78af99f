// Polynomials through values at the Chebyshev-Lobatto points of [-1, 1].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "numerics/elementary.h"

namespace flexslip {

// Linear maps from values at the nodes -cos(π j/n), j = 0, ..., n, to coefficients. n is the
// degree; the nodes include both ends.
template <std::size_t degree>
class Interpolant {
 public:
  using Values = std::array<double, degree + 1>;

  static double node(std::size_t j) { return maps().node[j]; }
  // The coefficients of T_0, ..., T_n.
  static Values chebyshev(const Values& at_nodes) { return apply(maps().chebyshev, at_nodes); }
  // The Bernstein coefficients on [-1, 1]. The polynomial lies between their minimum and maximum.
  // It has at most as many zeros as they have changes of sign (Descartes).
  static Values bernstein(const Values& at_nodes) { return apply(maps().bernstein, at_nodes); }

 private:
  using Matrix =
      // one row per node, so that the sums of all coefficients run in parallel
      std::array<Values, degree + 1>;

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
      // cos(π i/n), with the argument reduced to one turn.
      const auto cosine = [&](std::size_t i) {
        return elementary::sine_and_cosine(std::numbers::pi * real(i % (2 * degree)) / real(degree)).cosine;
      };
      for (std::size_t j = 0; j <= degree; ++j) node[j] = -cosine(j);
      for (std::size_t k = 0; k <= degree; ++k)
        for (std::size_t j = 0; j <= degree; ++j)
          chebyshev[j][k] = (k % 2 == 0 ? 2.0 : -2.0) / real(degree) * half_at_end(j) * half_at_end(k) * cosine(k * j);
      // T_k = Σ_i (-1)^(k-i) C(2k, 2i)/C(k, i) B_i^k, raised from degree k to degree n.
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
