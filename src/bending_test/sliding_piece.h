// A short stretch of sliding in as polynomials: force and stage position at any of its points for the price of a few products.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

class SlidingPiece {
 public:
  // Domain:     1 <= S_from < S_to; std::invalid_argument otherwise.
  // Method:     Chebyshev polynomials of degree 12 in √(S - 1) through the states at their nodes.
  // Cost:       2 µs.
  SlidingPiece(const Friction& friction, const Rig& rig, double S_from, double S_to);

  // Are there states all the way? If not, the force has fallen to zero, and nothing else is valid.
  bool exists() const { return exists_; }

  // An estimate of the error of the force, relative to the greatest: the last two coefficients of its polynomial.
  double error() const { return error_; }

  double force_from() const { return F_at_.front(); }      // [EI/L^2]
  double force_to() const { return F_at_.back(); }         // [EI/L^2]
  double stage_from() const { return stage_at_.front(); }  // [L]
  double stage_to() const { return stage_at_.back(); }     // [L]

  // ∫ F dw [EI/L]
  double work() const;

  // The force at a stage position, between those at the ends, where it is exact; the stage must rise along the piece.
  double force_at(double stage) const;

  // Where the force turns from rising to falling or back, in the order of the way.
  struct Turn {
    double stage;  // [L]
    double F;      // [EI/L^2]
  };
  std::vector<Turn> turns() const;

  static constexpr std::size_t degree = 12;
  using Values = std::array<double, degree + 1>;

 private:
  Values stage_at_{}, F_at_{}, w_at_{};  // at the nodes
  Values stage_, F_;                     // Chebyshev coefficients
  double error_ = 0;
  bool exists_ = true;
};

}  // namespace flexslip
