// Matérn kernels as state-space models: the state is g and its derivatives, in units of the rate of
// the kernel.
//
// The place x of a point is its distance from the middle of the observed length, in spans: x = (S -
// S_middle)/2, so that λ is the period in x.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "inference/kernel.h"
#include "numerics/elementary.h"
#include "numerics/few.h"

namespace flexslip::matern {

// The size G of the state of a kernel: g and G - 1 derivatives.
constexpr int order_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::none:
      return 0;
    case Kernel::exponential:
      return 1;
    case Kernel::matern_3_2:
      return 2;
    case Kernel::matern_9_2:
      break;
  }
  return 5;
}

// Calls a function with the order of a kernel as a constant.
template <class Function>
void with_order_of(Kernel kernel, Function function) {
  switch (kernel) {
    case Kernel::none:
      return function(std::integral_constant<int, 0>());
    case Kernel::exponential:
      return function(std::integral_constant<int, 1>());
    case Kernel::matern_3_2:
      return function(std::integral_constant<int, 2>());
    case Kernel::matern_9_2:
      break;
  }
  return function(std::integral_constant<int, 5>());
}

// The rate [1/L] of a kernel of correlation length 1.
inline double rate_of(Kernel kernel) { return std::sqrt(2.0 * order_of(kernel) - 1); }

// The matrix F of dX = F X da without noise, a in units of 1/rate: the companion matrix of (1 +
// d/da)^G.
template <int G>
constexpr Square<G> companion() {
  Square<G> F{};
  double binomial = 1;
  for (int j = 0; j < G; ++j) {
    if (j > 0) F(j - 1, j) = 1;
    F(G - 1, j) -= binomial;
    binomial = binomial * (G - j) / (j + 1);
  }
  return F;
}

// exp(F a) from the powers of F + 1, which end at G - 1; decay is exp(-a).
template <int G>
Square<G> transition_over(double a, double decay) {
  constexpr auto powers = [] {
    std::array<Square<G>, static_cast<std::size_t>(G)> all{};  // of F + 1, over the factorials of their exponents
    Square<G> nilpotent = companion<G>();
    for (int i = 0; i < G; ++i) all[0](i, i) = 1, nilpotent(i, i) += 1;
    for (int n = 1; n < G; ++n)
      for (int i = 0; i < G; ++i)
        for (int j = 0; j < G; ++j)
          for (int k = 0; k < G; ++k)
            all[static_cast<std::size_t>(n)](i, j) +=
                all[static_cast<std::size_t>(n - 1)](i, k) * nilpotent(k, j) / static_cast<double>(n);
    return all;
  }();
  Square<G> A;
  for (std::size_t at = 0; at < A.at_.size(); ++at) {
    double sum = powers[G - 1].at_[at];
    for (std::size_t n = G - 1; n-- > 0;) sum = sum * a + powers[n].at_[at];
    A.at_[at] = decay * sum;
  }
  return A;
}

// The covariance of a stationary process of variance 1 and its derivatives.
template <int G>
constexpr Square<G> stationary() {
  Square<G> P{};
  double moment = 1;  // of the spectrum, (1 + ω²)^-G
  for (int half = 0; half < G; ++half) {
    if (half > 0) moment *= (2.0 * half - 1) / (2.0 * (G - half) - 1);
    for (int i = 0; i < G; ++i)
      if (const int j = 2 * half - i; j >= 0 && j < G) P(i, j) = (i - half) % 2 == 0 ? moment : -moment;
  }
  return P;
}

// ∫ k and ∫ (R - r) k from 0 to R, for averages of the process; k is the kernel of variance 1, r =
// rate · distance.
struct KernelIntegrals {
  double of_kernel, of_tapered;
};
inline KernelIntegrals integrals_to(double R, Kernel kernel) {
  const int last = order_of(kernel) - 1;  // exponent in k = exp(-r) Σ c_n r^n
  KernelIntegrals integrals{0, 0};
  const double decay = elementary::exp(-R);
  double c = 1, factorial = 1, power = 1, series = 1;  // c_n, n!, R^n / n!, and the sum of these
  for (int n = 0; n <= last; ++n) {
    if (n > 0) {
      c *= 2.0 * (last - n + 1) / (n * (2.0 * last - n + 1));
      factorial *= n;
      power *= R / n;
      series += power;
    }
    const double whole = factorial * (1 - decay * series);  // ∫ r^n exp(-r)
    const double next = (n + 1) * (whole - decay * factorial * power * R / (n + 1));
    integrals.of_kernel += c * whole;
    integrals.of_tapered += c * (R * whole - next);
  }
  return integrals;
}

}  // namespace flexslip::matern
