// Polynomials through values at the Chebyshev-Lobatto points of [-1, 1].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

#include "numerics/elementary.h"

namespace flexslip {

// Linear maps from values at the nodes -cos(π j/n), j = 0, ..., n, where n is the degree; these include both ends.
template <std::size_t degree>
class Interpolant {
 public:
  using Values = std::array<double, degree + 1>;

  static double node(std::size_t j) { return maps().node[j]; }
  // Coefficients of T_0, ..., T_n.
  static Values chebyshev(const Values& at_nodes) {
    const Sums sums = sums_of(maps().chebyshev, at_nodes);
    Values c;
    std::copy_n(sums.begin(), c.size(), c.begin());
    return c;
  }
  // Bernstein coefficients on [-1, 1]: the polynomial lies between the least and the greatest of them, and has no more zeros than
  // they have changes of sign (Descartes).
  static Values bernstein(const Values& at_nodes) {
    const Sums sums = sums_of(maps().bernstein, at_nodes);
    Values b;
    for (std::size_t i = 0; i < half; ++i) {
      b[degree - i] = sums[2 * i] - sums[2 * i + 1];
      b[i] = sums[2 * i] + sums[2 * i + 1];
    }
    return b;
  }

 private:
  // What is even of the values about the middle and what is odd, each mapped by itself, which are half the products: in turn, a row for each node up to
  // the middle, which, where it is a node, counts once.
  static constexpr std::size_t below = (degree + 1) / 2, half = degree / 2 + 1;
  using Sums = std::array<double, 2 * half>;
  using Map = std::array<Sums, half>;

  static Sums sums_of(const Map& map, const Values& values) {
    Sums sums{};
    for (std::size_t j = 0; j < half; ++j) {
      const double mirrored = values[degree - j];
      const double even = j < below ? values[j] + mirrored : mirrored, odd = values[j] - mirrored;
      for (std::size_t i = 0; i < half; ++i) {
        sums[2 * i] += map[j][2 * i] * even;
        sums[2 * i + 1] += map[j][2 * i + 1] * odd;
      }
    }
    return sums;
  }

  struct Maps {
    Values node{};
    Map chebyshev{}, bernstein{};

    Maps() {
      const auto real = [](std::size_t i) { return static_cast<double>(i); };
      const auto binomial = [&](std::size_t n, std::size_t r) {
        double value = 1;
        for (std::size_t i = 1; i <= r; ++i) value = value * real(n - r + i) / real(i);
        return value;
      };
      std::array<Values, degree + 1> to_chebyshev{}, to_bernstein{};  // a row for each node
      const auto half_at_end = [](std::size_t i) { return i == 0 || i == degree ? 0.5 : 1.0; };
      // The cosine of π i/n, of an argument within a turn.
      const auto cosine = [&](std::size_t i) {
        return elementary::sine_and_cosine(std::numbers::pi * real(i % (2 * degree)) / real(degree)).cosine;
      };
      for (std::size_t j = 0; j <= degree; ++j) node[j] = -cosine(j);
      for (std::size_t k = 0; k <= degree; ++k)
        for (std::size_t j = 0; j <= degree; ++j)
          to_chebyshev[j][k] =
              (k % 2 == 0 ? 2.0 : -2.0) / real(degree) * half_at_end(j) * half_at_end(k) * cosine(k * j);
      // T_k = Σ_i (-1)^(k-i) C(2k, 2i)/C(k, i) B_i^k, raised from degree k to the full one.
      for (std::size_t i = 0; i <= degree; ++i)
        for (std::size_t k = 0; k <= degree; ++k) {
          double from_k = 0;
          for (std::size_t r = i + k > degree ? i + k - degree : 0; r <= std::min(i, k); ++r)
            from_k += ((k - r) % 2 == 0 ? 1.0 : -1.0) * binomial(2 * k, 2 * r) * binomial(degree - k, i - r);
          for (std::size_t j = 0; j <= degree; ++j)
            to_bernstein[j][i] += from_k / binomial(degree, i) * to_chebyshev[j][k];
        }
      // Of T_k, as even or odd as k; of B_i, the mirror image of B_(n-i).
      for (std::size_t j = 0; j < half; ++j) {
        std::copy(to_chebyshev[j].begin(), to_chebyshev[j].end(), chebyshev[j].begin());
        for (std::size_t i = 0; i < half; ++i) {
          bernstein[j][2 * i] = 0.5 * (to_bernstein[j][i] + to_bernstein[j][degree - i]);
          bernstein[j][2 * i + 1] = 0.5 * (to_bernstein[j][i] - to_bernstein[j][degree - i]);
        }
      }
    }
  };

  static const Maps& maps() {
    static const Maps value;
    return value;
  }
};

}  // namespace flexslip
