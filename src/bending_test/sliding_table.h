// Samples of a sliding curve: a table of work and lengths at low cost, and the fixed lengths of
// fits.
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

// Samples of a sliding curve.
//
// The coordinate is x = σ = √(S - 1) (Fibre::sliding_coordinate) for sliding in and x = -σ for
// sliding out, so that x always increases. In σ the curve is smooth at its start: dw/dσ -> √15/6
// and F -> 48 w.

inline double direction_of(Sliding sliding) { return sliding == Sliding::in ? 1 : -1; }
double coordinate_at(const Fibre& fibre, Sliding sliding, double S);  // [√L]

struct CurveSample {
  bool exists;     // false beyond the end of the branch; the other fields are then invalid
  RigPoint point;  // its stage_slope is infinite at S = 1
  double slope;    // [√L] dG/dx
  double scale;    // [√L] size of its terms
};

// The sample at x, with the accuracy of Fibre::state_slopes. The friction is a function of the
// sliding length.
CurveSample sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x);
// Many samples. On rollers or with a thickness they come from the table over lengths. Slopes then
// have this error relative to their scale, and the end of the branch an error of about 1e-12.
inline constexpr double tabulated_error = 1e-9;
std::vector<CurveSample> samples_at(const Friction& friction, const Rig& rig, Sliding sliding,
                                    std::span<const double> x);
// One of these samples, bit for bit.
CurveSample tabulated_sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x);

// [L] A longer specimen slips through its supports.
inline constexpr double longest_sliding = 100;

struct SlidingWork {
  double stage = 0;  // [EI/L] ∫ F dG
  // [EI/L] ∫ q Pn dS, and the bending energy of the axis that leaves the span (fibre.h)
  double friction = 0;
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

  // The work between two lengths, in either order.
  // Domain:     lengths in [1, longest_sliding] between which the curve exists;
  //             std::invalid_argument otherwise.
  // Max error:  1e-12 of the work in the cells involved, plus the rounding of friction, 2^-50 dμ/dS
  //             relative to μ.
  // Method:     stage position, force and friction power as Chebyshev polynomials of degree 16 in
  //             the sliding coordinate. A cell has a quarter of the shortest period of friction and
  //             is halved at kinks. Cells are filled on demand.
  // Cost:       0.1 µs; 4 µs for each new cell.
  SlidingWork work(double S_from, double S_to);

 private:
  static constexpr std::size_t degree = 16;
  using Series = std::array<double, degree + 1>;  // Chebyshev coefficients
  using Integral = std::array<double, degree + 2>;

  // An interval of the sliding coordinate σ.
  struct Piece {
    double from, to;           // [√L]
    Integral stage, friction;  // [EI/L] work from the lower end of the piece
    SlidingWork before;        // from the lower end of the cell to this piece
  };
  using Cell = std::vector<Piece>;

  struct Sample {
    bool exists = false;
    double stage = 0, F = 0;
    double friction = 0, max_friction = 0;  // [EI/L/√L] power per σ, and power of a friction of 1
    double error = 0;                       // relative error of all
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
  std::vector<double> edges_{1.0};  // [L] up to the largest length needed
  std::unordered_map<std::size_t, Cell> cells_;
};

// A sliding curve at fixed lengths, for fits that compute thousands of curves. Reported results are
// computed by rig.h.

inline constexpr double longest_ladder = 2.1;  // [L] below the end of the branch for any friction

class SlidingLadder {
 public:
  // Lengths from 1 to S_max, evenly spaced in the sliding coordinate, at most S_step apart. With a
  // thickness, lengths before sliding in count as 1.
  // Domain:     1 < S_max <= longest_ladder, 0 < S_step; std::invalid_argument otherwise.
  SlidingLadder(double S_max, double S_step, const Fibre& fibre = {});

  std::span<const double> lengths() const { return S_; }  // [L]

  // The sliding curve for friction values at these lengths, limited to [0, table_q.greatest], with
  // the accuracy of the table (fibre/state_table.h).
  StateArrays curve(std::span<const double> mu) const;

 private:
  Fibre fibre_;
  std::vector<double> S_;
  std::vector<double> shallow_;  // [L] deflections of the first lengths, before sliding in
};

// [EI/L^2] The force at stage positions of a loading, from a curve at fixed lengths; beyond its
// end, the last force.
// Domain:     stages rising; w and F of equal length, at least 4.
// Max error:  about 60/n^4 of the height of a tooth, with n lengths a period.
// Method:     the running maximum of G = w + compliance F, as in rig.h, with cubic interpolation.
std::vector<double> measured_curve(std::span<const double> w, std::span<const double> F, double compliance,
                                   std::span<const double> stages);

}  // namespace flexslip
