// A short segment of a sliding curve, given by values at polynomial nodes. The tracer searches it
// for folds, and forces are later determined from the same values.
#pragma once

#include <cstddef>

#include "numerics/interpolant.h"

namespace flexslip {

// Values at the Chebyshev-Lobatto points between two values of the sliding coordinate x
// (sliding_table.h); NaN without a state.
struct CurvePiece {
  static constexpr std::size_t degree = 12;
  // smooth scales of friction (friction.h): half the shortest period
  static constexpr double longest = 2;
  using Polynomial = Interpolant<degree>;
  using Values = Polynomial::Values;

  double from, to;  // [√L] of x, rising
  Values q;         // [1]
  Values stage;     // [L]
  Values F;         // [EI/L^2]

  double coordinate_at(double t) const { return 0.5 * (from + to) + 0.5 * (to - from) * t; }  // t in [-1, 1]
  double coordinate_of(std::size_t node) const {
    return node == 0 ? from : node == degree ? to : coordinate_at(Polynomial::node(node));
  }
  double place_of(double x) const { return (2 * x - from - to) / (to - from); }  // t
};

}  // namespace flexslip
