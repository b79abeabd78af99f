// Friction along the fibre as a random process: a Matérn process about a mean that is linear in what is sought, and its kernels as state-space
// models: g and its derivatives, each in units of the rate of the kernel.
//
// A place x on the fibre is its distance from the middle of the fibre seen, in spans: x = (S - S_middle)/2, so that λ is the period in x.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <string_view>

#include "numerics/elementary.h"

namespace flexslip {

// How smooth the roughness is: a path of `exponential` (Matérn 1/2) has no slope, one of `matern_3_2` one, of `matern_5_2` two derivatives.
enum class Kernel { none, exponential, matern_3_2, matern_5_2 };

inline constexpr std::array all_kernels{Kernel::none, Kernel::exponential, Kernel::matern_3_2, Kernel::matern_5_2};

std::string_view name_of(Kernel kernel);

// What the process and the noise of a record are like.
struct Hyperparameters {
  double noise;        // [EI/L^2] standard deviation σ of one force reading
  double correlation;  // [1] ρ of the errors of readings one row apart, in [0, 0.95)
  double roughness;    // [1] standard deviation σ_g of μ about its mean; without a kernel not used
  double length;       // [L] correlation length ℓ along the fibre; likewise
};

// A square matrix of a few numbers, and products of it: what Eigen takes seconds to compile, source by source.

// Of numbers of whatever kind; of no value until it is given one.
template <int M, class T>
struct Square {
  std::array<T, static_cast<std::size_t>(M) * M> at_;
  constexpr T& operator()(int i, int j) { return at_[place(i, j)]; }
  constexpr const T& operator()(int i, int j) const { return at_[place(i, j)]; }
  static constexpr std::size_t place(int i, int j) {
    return static_cast<std::size_t>(i) * M + static_cast<std::size_t>(j);
  }
};

template <int M>
using Few = std::array<double, static_cast<std::size_t>(M)>;

// Of M terms, paired: a + b, a + (b + c), (a + b) + (c + d), as Eigen sums them.
template <int M, class Term>
double paired_sum(const Term& term, int first = 0) {
  if constexpr (M == 1)
    return term(first);
  else
    return paired_sum<M / 2>(term, first) + paired_sum<M - M / 2>(term, first + M / 2);
}

template <int M>
double dot(const Few<M>& a, const Few<M>& b) {
  return paired_sum<M>([&](int i) { return a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(i)]; });
}

template <int M>
Few<M> product(const Square<M, double>& A, const Few<M>& v) {
  Few<M> out;
  for (int i = 0; i < M; ++i)
    out[static_cast<std::size_t>(i)] = paired_sum<M>([&](int j) { return A(i, j) * v[static_cast<std::size_t>(j)]; });
  return out;
}

template <int M>
Square<M, double> product(const Square<M, double>& A, const Square<M, double>& B) {
  Square<M, double> out;
  for (int i = 0; i < M; ++i)
    for (int j = 0; j < M; ++j) out(i, j) = paired_sum<M>([&](int k) { return A(i, k) * B(k, j); });
  return out;
}

template <int M>
Square<M, double> transposed(const Square<M, double>& A) {
  Square<M, double> out;
  for (int i = 0; i < M; ++i)
    for (int j = 0; j < M; ++j) out(i, j) = A(j, i);
  return out;
}

}  // namespace flexslip

namespace flexslip::matern {

// The rate [1/L] of a kernel of correlation length 1.
constexpr double rate_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::none:
      return 0;
    case Kernel::exponential:
      return 1;
    case Kernel::matern_3_2:
      return std::numbers::sqrt3;
    case Kernel::matern_5_2:
      break;
  }
  return 2.2360679774997896964;  // √5
}

inline double exp(double a) { return elementary::exp(a); }

// Over the distance a in units of 1/rate: exp(F a), F being the companion matrix of (1 + d/da)^G.
template <int G, class T>
Square<G, T> transition_over(const T& a) {
  const T decay = exp(T(0) - a);
  Square<G, T> A;
  if constexpr (G == 1) {
    A(0, 0) = decay;
  } else if constexpr (G == 2) {
    A(0, 0) = decay * (T(1) + a);
    A(0, 1) = decay * a;
    A(1, 0) = T(0) - decay * a;
    A(1, 1) = decay * (T(1) - a);
  } else {
    const T half = T(0.5) * a * a;
    A(0, 0) = decay * (T(1) + a + half);
    A(0, 1) = decay * (a + T(2) * half);
    A(0, 2) = decay * half;
    A(1, 0) = T(0) - decay * half;
    A(1, 1) = decay * (T(1) + a - T(2) * half);
    A(1, 2) = decay * (a - half);
    A(2, 0) = decay * (half - a);
    A(2, 1) = decay * (T(2) * half - T(3) * a);
    A(2, 2) = decay * (T(1) - T(2) * a + half);
  }
  return A;
}

// The covariance of a stationary process of variance 1 and its derivatives.
template <int G>
constexpr Square<G, double> stationary() {
  Square<G, double> P{};
  P(0, 0) = 1;
  if constexpr (G == 2) P(1, 1) = 1;
  if constexpr (G == 3) {
    P(1, 1) = 1.0 / 3;
    P(2, 2) = 1;
    P(0, 2) = P(2, 0) = -1.0 / 3;
  }
  return P;
}

// ∫ k from 0 to R, and ∫ (R - r) k: what averages of the process need. k is the kernel of variance 1 over r = rate · distance.
struct KernelIntegrals {
  double of_kernel, of_tapered;
};
inline KernelIntegrals integrals_to(double R, Kernel kernel) {
  const double E = elementary::exp(-R);
  switch (kernel) {
    case Kernel::none:
      return {0, 0};
    case Kernel::exponential:
      return {1 - E, R - 1 + E};
    case Kernel::matern_3_2:
      return {2 - (2 + R) * E, 2 * R - 3 + (R + 3) * E};
    case Kernel::matern_5_2:
      break;
  }
  return {8.0 / 3 - E * (8.0 / 3 + R * (5.0 / 3 + R / 3)), 8 * R / 3 - 5 + E * (5 + R * (7.0 / 3 + R / 3))};
}

}  // namespace flexslip::matern
