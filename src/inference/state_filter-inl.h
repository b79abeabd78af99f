// The Kalman filter whose state is a Matérn process, its derivatives and an AR(1) process: over doubles, or over numbers that carry derivatives.
// Part of chain.cpp, likelihood_gradient.cpp and prior_draw.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "fibre/elementary.h"
#include "inference/looks.h"
#include "inference/matern.h"

namespace flexslip {
namespace {

using Eigen::Index;
using matern::exp;
inline double log(double a) { return elementary::log(a); }
inline double value_of(double a) { return a; }

template <class T>
struct Parameters {
  T noise, correlation, roughness, rate;
};

Parameters<double> numbers_of(Kernel kernel, const Hyperparameters& at) {
  return {at.noise, at.correlation, kernel == Kernel::none ? 0 : at.roughness,
          kernel == Kernel::none ? 0 : matern::rate_of(kernel) / at.length};
}

// The filter's covariances: what it knows of the state before each look. G numbers of g, then e.
template <int M, class T>
class Covariances {
 public:
  static constexpr int G = M - 1;

  explicit Covariances(const Parameters<T>& p) : p_(p) {
    const T variance = p.roughness * p.roughness;
    A_.at_.fill(T(0));
    limit_.at_.fill(T(0));
    if constexpr (G > 0) {
      constexpr auto P = matern::stationary<G>();
      for (int i = 0; i < G; ++i)
        for (int j = 0; j < G; ++j) limit_(i, j) = variance * P(i, j);
    }
    limit_(G, G) = p.noise * p.noise;
    P_ = limit_;
  }

  // To a look from the one before.
  void advance(double distance, double rows) {
    if constexpr (G > 0) {
      const auto A = matern::transition_over<(G > 0 ? G : 1), T>(p_.rate * distance);
      for (int i = 0; i < G; ++i)
        for (int j = 0; j < G; ++j) A_(i, j) = A(i, j);
    }
    A_(G, G) = rows == 0 ? T(1) : rows == 1 ? p_.correlation : power(rows);
    Square<M, T> half;  // A (P - P of the limit), which ends where nothing is known
    for (int i = 0; i < M; ++i)
      for (int j = 0; j < M; ++j) {
        T sum(0);
        if (i < G) {
          for (int k = 0; k < G; ++k) sum = sum + A_(i, k) * (P_(k, j) - limit_(k, j));
        } else {
          sum = A_(G, G) * (P_(G, j) - limit_(G, j));
        }
        half(i, j) = sum;
      }
    for (int i = 0; i < M; ++i)
      for (int j = i; j < M; ++j) {
        T sum = limit_(i, j);
        if (j < G) {
          for (int k = 0; k < G; ++k) sum = sum + half(i, k) * A_(j, k);
        } else {
          sum = sum + half(i, G) * A_(G, G);
        }
        P_(i, j) = P_(j, i) = sum;
      }
  }

  // The variance of what a look adds, and what it tells of the state.
  T look(double D, double variance, std::array<T, M>& gain) {
    std::array<T, M> PH;
    for (int i = 0; i < M; ++i) PH[at(i)] = G > 0 ? P_(i, 0) + D * P_(i, G) : D * P_(i, G);
    T innovation = (G > 0 ? PH[0] + D * PH[at(G)] : D * PH[at(G)]) + variance;
    for (int i = 0; i < M; ++i) gain[at(i)] = PH[at(i)] / innovation;
    for (int i = 0; i < M; ++i)
      for (int j = i; j < M; ++j) P_(i, j) = P_(j, i) = P_(i, j) - gain[at(i)] * PH[at(j)];
    return innovation;
  }

  const Square<M, T>& covariance() const { return P_; }
  const Square<M, T>& transition() const { return A_; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  T power(double rows) const { return value_of(p_.correlation) > 0 ? exp(T(rows) * log(p_.correlation)) : T(0); }

  Parameters<T> p_;
  Square<M, T> limit_, P_, A_;
};

// The states of many series at once, a row for each number of the state.
template <int M, class T>
class States {
 public:
  static constexpr int G = M - 1;

  explicit States(std::size_t series) : n_(series), m_(static_cast<std::size_t>(M) * series, T(0)), next_(m_) {}

  void advance(const Square<M, T>& A) {
    for (int i = 0; i < G; ++i)
      for (std::size_t c = 0; c < n_; ++c) {
        T sum = A(i, 0) * row(0)[c];
        for (int k = 1; k < G; ++k) sum = sum + A(i, k) * row(k)[c];
        next_[static_cast<std::size_t>(i) * n_ + c] = sum;
      }
    for (std::size_t c = 0; c < n_; ++c) next_[static_cast<std::size_t>(G) * n_ + c] = A(G, G) * row(G)[c];
    m_.swap(next_);
  }

  // What a look differs from what was expected, for one series.
  T innovation(double value, double D, std::size_t c) const {
    if constexpr (G > 0) return value - row(0)[c] - D * row(G)[c];
    return value - D * row(G)[c];
  }
  void learn(const std::array<T, M>& gain, const T& v, std::size_t c) {
    for (int i = 0; i < M; ++i) row(i)[c] = row(i)[c] + gain[static_cast<std::size_t>(i)] * v;
  }
  const std::vector<T>& all() const { return m_; }

 private:
  T* row(int i) { return m_.data() + static_cast<std::size_t>(i) * n_; }
  const T* row(int i) const { return m_.data() + static_cast<std::size_t>(i) * n_; }

  std::size_t n_;
  std::vector<T> m_, next_;
};

// What a function makes of the size of the state.
template <class Result, class Function>
Result with_state_of(Kernel kernel, Function function) {
  switch (kernel) {
    case Kernel::none:
      return function(std::integral_constant<int, 1>());
    case Kernel::exponential:
      return function(std::integral_constant<int, 2>());
    case Kernel::matern_3_2:
      return function(std::integral_constant<int, 3>());
    case Kernel::matern_5_2:
      break;
  }
  return function(std::integral_constant<int, 4>());
}

}  // namespace
}  // namespace flexslip
