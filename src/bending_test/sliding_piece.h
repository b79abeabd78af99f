// A short stretch of sliding as polynomials: force and stage position at any of its points for the price of a few products.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "bending_test/curve_piece.h"
#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

// The pieces between points of the way x, each from one point to the next. The friction is that met on the way.
// Domain:     at least two points, rising.
// Max error:  of the values as the table (fibre/state_table.h).
// Cost:       about 0.4 µs each.
std::vector<CurvePiece> pieces_between(const Friction& friction, const Rig& rig, Sliding sliding,
                                       std::span<const double> x);

// A piece, or a part of one, on which the stage rises.
class SlidingPiece {
 public:
  // Domain:     piece.from <= from < to <= piece.to; std::invalid_argument otherwise.
  SlidingPiece(const CurvePiece& piece, const Rig& rig, double from, double to);
  SlidingPiece(const CurvePiece& piece, const Rig& rig) : SlidingPiece(piece, rig, piece.from, piece.to) {}

  // Are there states all along the piece? If not, the force has fallen to zero, and nothing else is valid.
  bool exists() const { return exists_; }

  // An estimate of the error of the force, relative to the greatest: the last two coefficients of its polynomial.
  double error() const { return error_; }

  double force_from() const { return force_from_; }  // [EI/L^2]
  double force_to() const { return force_to_; }      // [EI/L^2]
  double stage_to() const { return stage_to_; }      // [L]

  // ∫ F dw [EI/L]
  double work() const;

  // The force at a stage position; that at an end for one beyond.
  double force_at(double stage) const;

  // Where the force turns from rising to falling or back, in the order of the way.
  struct Turn {
    double way;    // [√L] x
    double stage;  // [L]
    double F;      // [EI/L^2]
  };
  struct Turns {
    std::array<Turn, CurvePiece::degree> at;
    std::size_t count;
    std::size_t size() const { return count; }
    const Turn* begin() const { return at.data(); }
    const Turn* end() const { return at.data() + count; }
  };
  Turns turns() const;

 private:
  CurvePiece piece_;
  double begin_, end_;                // in [-1, 1] of the piece
  double compliance_;                 // [L^3/EI]
  CurvePiece::Values stage_{}, F_{};  // Chebyshev coefficients
  bool exists_;
  double error_ = 0;
  double force_from_ = 0, force_to_ = 0, stage_from_ = 0, stage_to_ = 0;
};

}  // namespace flexslip
