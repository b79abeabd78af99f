#include "inference/state_pairs.h"

#include <cmath>

#include <doctest/doctest.h>

namespace flexslip {
namespace {

template <int M>
double number(const StateMatrix<M>& X, std::size_t i, std::size_t j) {
  return X[j / 2][i][j % 2];
}

// Some numbers, no two alike.
double some(std::size_t i, std::size_t j) {
  return std::sin(1.0 + 3.7 * static_cast<double>(i) + 1.9 * static_cast<double>(j));
}

template <int M>
StateMatrix<M> some_matrix() {
  StateMatrix<M> X{};
  for (std::size_t i = 0; i < M; ++i)
    for (std::size_t j = 0; j < M; ++j) X[j / 2][i][j % 2] = some(i, j);
  return X;
}

// Each product beside the same sums of single numbers.
template <int M>
void check_products() {
  constexpr double rounding = 1e-14;
  const StateMatrix<M> X = some_matrix<M>(), X_transposed = transposed<M>(X);
  Square<M - 1> of_g{};
  Square<M> A{};
  for (std::size_t i = 0; i + 1 < M; ++i)
    for (std::size_t j = 0; j + 1 < M; ++j) A.at_[i * M + j] = of_g.at_[i * (M - 1) + j] = some(i + 11, j);
  A.at_[M * M - 1] = 0.3;
  const TransitionInPairs<M> transition(of_g, 0.3);
  const StateMatrix<M> AX = transition * X, A_transposed_X = transition.transposed() * X;
  Few<M> v;
  for (std::size_t i = 0; i < M; ++i) v[i] = some(i, 20);
  const Few<M> vX = numbers_of<M>(product<M>(v, X));
  for (std::size_t i = 0; i < M; ++i) {
    double along = 0;
    for (std::size_t j = 0; j < M; ++j) {
      CHECK(number<M>(X_transposed, i, j) == number<M>(X, j, i));
      double sum = 0, of_transposed = 0;
      for (std::size_t k = 0; k < M; ++k) {
        sum += A.at_[i * M + k] * number<M>(X, k, j);
        of_transposed += A.at_[k * M + i] * number<M>(X, k, j);
      }
      CHECK(std::abs(number<M>(AX, i, j) - sum) < rounding);
      CHECK(std::abs(number<M>(A_transposed_X, i, j) - of_transposed) < rounding);
      along += v[j] * number<M>(X, j, i);
    }
    CHECK(std::abs(vX[i] - along) < rounding);
    CHECK(numbers_of<M>(row_of<M>(v))[i] == v[i]);
  }
}

}  // namespace

TEST_CASE("oracle: products of states by pairs are those of single numbers, for each size of state") {
  check_products<1>();
  check_products<2>();
  check_products<3>();
  check_products<4>();
  check_products<6>();
}

}  // namespace flexslip
