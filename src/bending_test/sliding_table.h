// A sliding curve sampled: as a table of work and lengths for the price of a few polynomials, and on the fixed ladder of fits.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

// A sliding curve sampled along the way that the fibre slides.
//
// The way is x = σ = √(S - 1) (Fibre::way) for a fibre drawn in and x = -σ for one let out, so that x rises on either. In σ the curve has no
// singularity at its start: dw/dσ -> √15/6 and F -> 48 w.

inline double direction_of(Sliding sliding) { return sliding == Sliding::in ? 1 : -1; }
double way_at(const Fibre& fibre, Sliding sliding, double S);  // [√L]

struct CurveSample {
  bool exists;     // false beyond the end of the branch; then nothing else is valid
  RigPoint point;  // its stage_slope is infinite at S = 1
  double slope;    // [√L] dG/dx
  double scale;    // [√L] size of its terms
};

// A point of the way, to the accuracy of Fibre::state_slopes, and with it where the branch ends. The friction is that met on the way.
CurveSample sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x);
// Many; on rollers or with a thickness by the table over lengths, slopes to this, relative to their scale, whose branch may end some 1e-12 from that
// of the states.
inline constexpr double tabulated_error = 1e-9;
std::vector<CurveSample> samples_at(const Friction& friction, const Rig& rig, Sliding sliding,
                                    std::span<const double> x);
// The one of those, bit by bit.
CurveSample tabulated_sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x);

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
  // Method:     stage position, force and the power of friction as Chebyshev polynomials of degree 16 in √(S - 1) (Fibre::way), on cells of a
  //             quarter of the shortest period of the roughness, halved where it has kinks. A cell is computed when it is first met.
  // Cost:       0.1 µs; 4 µs for each new cell.
  SlidingWork work(double S_from, double S_to);

 private:
  static constexpr std::size_t degree = 16;
  using Series = std::array<double, degree + 1>;  // Chebyshev coefficients
  using Integral = std::array<double, degree + 2>;

  // A stretch of σ (Fibre::way).
  struct Piece {
    double from, to;           // [√L]
    Integral stage, friction;  // [EI/L] work, from the lower end of the piece
    SlidingWork before;        // from the lower end of the cell to this piece
  };
  using Cell = std::vector<Piece>;

  struct Sample {
    bool exists = false;
    double stage = 0, F = 0;
    double friction = 0, max_friction = 0;  // [EI/L/√L] power per σ, and that of a friction of 1
    double error = 0;                       // of all of them, relative
  };

  Sample sample_at(double sigma) const;
  void fill(Cell& cell, double from, double to, Sample greatest, int halvings) const;
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

// The sliding curve on a fixed ladder of lengths, and what a test measures of it: fits run thousands of curves over the same lengths.
// Results that are reported are computed by rig.h.

inline constexpr double longest_ladder = 2.1;  // [L] before the branch ends, whatever the friction

class SlidingLadder {
 public:
  // Lengths evenly spaced in √(S - 1) (Fibre::way) from 1 to S_max, their largest distance being S_step; of a specimen with a thickness those
  // before it slides in count as 1.
  // Domain:     1 < S_max <= longest_ladder, 0 < S_step; std::invalid_argument otherwise.
  SlidingLadder(double S_max, double S_step, const Fibre& fibre = {});

  std::span<const double> lengths() const { return S_; }  // [L]

  // The sliding curve of a friction profile given at those lengths, to the accuracy of the table (fibre/state_table.h). Values outside
  // [0, table_q.greatest] count as the nearest bound.
  StateArrays curve(std::span<const double> mu) const;

 private:
  Fibre fibre_;
  std::vector<double> S_;
  std::vector<double> shallow_;  // [L] deflections before it slides in, of the first lengths
};

// A test in which the stage only advances, on a curve given at a ladder of lengths: the force [EI/L^2] at each stage position, that of the last
// length if the curve does not reach it.
// Method:     the running maximum of the stage position G = w + compliance F, as in rig.h, interpolated by cubics between the lengths.
// Domain:     stages rising; w and F of one length, at least 4.
// Max error:  set by the ladder: with n lengths a period, about 60/n^4 of the height of a tooth.
std::vector<double> measured_curve(std::span<const double> w, std::span<const double> F, double compliance,
                                   std::span<const double> stages);

}  // namespace flexslip
