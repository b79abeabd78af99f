// A square matrix of a few numbers, and products of it: what Eigen takes seconds to compile, source by source.
#pragma once

#include <array>
#include <cstddef>

namespace flexslip {

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
