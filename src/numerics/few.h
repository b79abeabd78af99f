// Vectors and square matrices of a few numbers, and their products. Eigen's would take seconds to
// compile in each source.
#pragma once

#include <array>
#include <cstddef>

namespace flexslip {

template <int M>
struct Square {
  std::array<double, static_cast<std::size_t>(M) * M> at_;
  constexpr double& operator()(int i, int j) { return at_[place(i, j)]; }
  constexpr double operator()(int i, int j) const { return at_[place(i, j)]; }
  static constexpr std::size_t place(int i, int j) {
    return static_cast<std::size_t>(i) * M + static_cast<std::size_t>(j);
  }
};

template <int M>
using Few = std::array<double, static_cast<std::size_t>(M)>;

// The sum of M terms in pairs: a + b, a + (b + c), (a + b) + (c + d). Eigen sums in this order.
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
Square<M> product(const Square<M>& A, const Square<M>& B) {
  Square<M> out;
  for (int i = 0; i < M; ++i)
    for (int j = 0; j < M; ++j) out(i, j) = paired_sum<M>([&](int k) { return A(i, k) * B(k, j); });
  return out;
}

template <int M>
Square<M> transposed(const Square<M>& A) {
  Square<M> out;
  for (int i = 0; i < M; ++i)
    for (int j = 0; j < M; ++j) out(i, j) = A(j, i);
  return out;
}

}  // namespace flexslip
