// A sliding curve as a table: work along it, and the length at a stage position, for the price of a few polynomials.
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "bending_test/rig.h"

namespace flexslip {

// Farther than that no specimen reaches: one that is drawn in so far slips through its supports.
inline constexpr double longest_sliding = 100;  // [L]

struct SlidingWork {
  double stage = 0;     // [EI/L] ∫ F dG, of the force on the stage position that holds the fibre
  double friction = 0;  // [EI/L] ∫ q Pn dS, and what bending axis loses as it leaves the span (fibre.h)
  SlidingWork& operator+=(const SlidingWork& other) {
    stage += other.stage;
    friction += other.friction;
    return *this;
  }
  friend SlidingWork operator*(double factor, const SlidingWork& work) {
    return {factor * work.stage, factor * work.friction};
  }
};

class SlidingTable {
 public:
  SlidingTable(const Friction& friction, const Rig& rig, Sliding sliding);

  // The work done from one length to another, in either order.
  // Domain:     lengths in [1, longest_sliding] between which the curve exists; std::invalid_argument otherwise.
  // Max error:  1e-12 of the work on the cells it touches, and what rounding does to friction: 2^-50 dμ/dS, relative to μ.
  // Method:     Chebyshev polynomials of degree 16 in √(S - 1) (Fibre::way), integrated, on cells of a quarter of the shortest period of the
  //             roughness, halved where it has kinks. A cell is computed when it is first met.
  // Cost:       0.2 µs; 10 µs for each new cell.
  SlidingWork work(double S_from, double S_to);

  // The length at which G = stage, between two lengths between which G rises with S and takes that value.
  // Domain:     as work().
  // Max error:  1e-12 of G: a guess for point_at_stage (rig.h).
  double length_at_stage(double stage, double S_from, double S_to);

 private:
  static constexpr std::size_t degree = 16;
  using Series = std::array<double, degree + 1>;  // Chebyshev coefficients
  using Integral = std::array<double, degree + 2>;

  // A stretch of σ (Fibre::way).
  struct Piece {
    double from, to;           // [√L]
    Series G;                  // [L]
    Integral stage, friction;  // from the lower end of the piece
    SlidingWork before;        // from the lower end of the cell to this piece
  };
  using Cell = std::vector<Piece>;

  struct Sample {
    double G;
    SlidingWork power;  // per σ
    double noise;       // of power
  };

  Sample sample_at(double sigma) const;
  void fill(Cell& cell, double from, double to, double scale, int halvings) const;
  const Cell& cell(std::size_t i);
  std::size_t cell_of(double S);
  static const Piece& piece_at(const Cell& cell, double sigma);
  static SlidingWork up_to(const Cell& cell, double sigma);

  Friction friction_;
  Rig rig_;
  double direction_;
  std::vector<double> edges_{1.0};  // [L] as far as lengths have been met
  std::unordered_map<std::size_t, Cell> cells_;
};

}  // namespace flexslip
