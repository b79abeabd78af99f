// A short sliding segment, approximated by polynomials that give force and stage position at any
// point in a few multiplications.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "bending_test/curve_piece.h"
#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

// The pieces between successive values of the sliding coordinate x. The friction is a function of
// the sliding length.
// Domain:     at least two points, rising.
// Max error:  the error of the tables (fibre/state_table.h).
// Cost:       about 0.4 µs each.
std::vector<CurvePiece> pieces_between(const Friction& friction, const Rig& rig, Sliding sliding,
                                       std::span<const double> x);

// A piece, or a part of one, with a rising stage.
class SlidingPiece {
 public:
  // Domain:     piece.from <= from < to <= piece.to; std::invalid_argument otherwise.
  SlidingPiece(const CurvePiece& piece, const Rig& rig, double from, double to);
  SlidingPiece(const CurvePiece& piece, const Rig& rig) : SlidingPiece(piece, rig, piece.from, piece.to) {}

  // True if every point of the segment has an equilibrium state. If false, the force reaches zero
  // within it and the other members are invalid.
  bool exists() const { return exists_; }

  // The estimated error of the force relative to its maximum: the last two coefficients of its
  // polynomial.
  double error() const { return error_; }

  double force_from() const { return force_from_; }  // [EI/L^2]
  double force_to() const { return force_to_; }      // [EI/L^2]
  double stage_to() const { return stage_to_; }      // [L]

  // ∫ F dw [EI/L]
  double work() const;

  // The force at a stage position; beyond an end, the force there.
  double force_at(double stage) const;

  // A maximum or minimum of the force, in the sliding direction.
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
