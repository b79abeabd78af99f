// The states of a filter by pairs, of two series or of two columns of a covariance: two numbers that every processor adds and multiplies at once.
// A state of M numbers is g and its derivatives, M - 1 of them, then e; g and e go on by themselves.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "numerics/few.h"

namespace flexslip {

using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

inline Pair pair_at(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof(Pair));
  return pair;
}
inline void put(Pair pair, double* to) { std::memcpy(to, &pair, sizeof(Pair)); }
inline Pair both(double value) { return Pair{value, value}; }
inline double sum_of(Pair pair) { return pair[0] + pair[1]; }

constexpr std::size_t pairs_of(std::size_t count) { return (count + 1) / 2; }

template <int M>
using PairOfStates = std::array<Pair, static_cast<std::size_t>(M)>;

template <int M>
PairOfStates<M> spread(const Few<M>& factors) {
  PairOfStates<M> pairs;
  for (std::size_t i = 0; i < M; ++i) pairs[i] = both(factors[i]);
  return pairs;
}

// A vector along the columns of a matrix of states; of an odd number the last pair ends with a zero.
template <int M>
using Row = std::array<Pair, pairs_of(M)>;

template <int M>
Row<M> row_of(const Few<M>& numbers) {
  Row<M> row{};
  for (std::size_t i = 0; i < M; ++i) row[i / 2][i % 2] = numbers[i];
  return row;
}
template <int M>
Few<M> numbers_of(const Row<M>& row) {
  Few<M> numbers;
  for (std::size_t i = 0; i < M; ++i) numbers[i] = row[i / 2][i % 2];
  return numbers;
}

// A matrix of M rows and columns, by pairs of columns.
template <int M>
using StateMatrix = std::array<PairOfStates<M>, pairs_of(M)>;

template <int M>
StateMatrix<M> transposed(const StateMatrix<M>& matrix) {
  StateMatrix<M> out;
  for (std::size_t b = 0; b < pairs_of(M); ++b)
    for (std::size_t i = 0; i < M; ++i) {
      const PairOfStates<M>& from = matrix[i / 2];
      out[b][i] = Pair{from[2 * b][i % 2], 2 * b + 1 < M ? from[2 * b + 1][i % 2] : 0};
    }
  return out;
}

// v' X, of a symmetric X as well X v.
template <int M>
Row<M> product(const Few<M>& v, const StateMatrix<M>& X) {
  Row<M> row{};
  for (std::size_t i = 0; i < M; ++i)
    for (std::size_t b = 0; b < pairs_of(M); ++b) row[b] += v[i] * X[b][i];
  return row;
}

// A matrix under which g and e do not mix.
template <int M>
class TransitionInPairs {
 public:
  TransitionInPairs() = default;
  TransitionInPairs(const Square<M - 1>& of_g, double of_e) : of_e_(both(of_e)) {
    for (std::size_t at = 0; at < G * G; ++at) of_g_[at] = both(of_g.at_[at]);
  }

  TransitionInPairs transposed() const {
    TransitionInPairs out;
    for (std::size_t i = 0; i < G; ++i)
      for (std::size_t j = 0; j < G; ++j) out.of_g_[i * G + j] = of_g_[j * G + i];
    out.of_e_ = of_e_;
    return out;
  }

  PairOfStates<M> operator*(const PairOfStates<M>& state) const {
    PairOfStates<M> next;
    for (std::size_t i = 0; i < G; ++i) {
      Pair sum = of_g_[i * G] * state[0];
      for (std::size_t k = 1; k < G; ++k) sum += of_g_[i * G + k] * state[k];
      next[i] = sum;
    }
    next[G] = of_e_ * state[G];
    return next;
  }
  StateMatrix<M> operator*(const StateMatrix<M>& matrix) const {
    StateMatrix<M> out;
    for (std::size_t b = 0; b < pairs_of(M); ++b) out[b] = *this * matrix[b];
    return out;
  }

 private:
  static constexpr std::size_t G = M - 1;
  std::array<Pair, G * G> of_g_{};
  Pair of_e_{};
};

}  // namespace flexslip
