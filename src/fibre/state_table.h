// Ψ tabulated: for work that needs very many states and no more than 12 digits of each; likewise on supports.
//
// Piecewise Chebyshev interpolation of w/σ and F/σ in σ = √(S - 1) and q: in these Ψ is smooth down to the straight fibre, and nothing of
// the friction law or the rig is in it. It is built cell by cell, where it is asked for (cell_table.h). Reduced variables as in elastica.h; arrays and their
// properties as in batch.h, but for the accuracy.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "fibre/batch.h"
#include "fibre/cell_table.h"
#include "fibre/supported_state.h"
#include "numerics/beam.h"

namespace flexslip {

// Where states are interpolated: 0 < σ < table_sigma, q in [table_q.least, table_q.greatest); beyond, and where the branch ends nearby, they are computed as by batch.h.
inline constexpr double table_sigma = 1.05;  // [√L] S up to 2.1
struct FrictionRange {
  double least, greatest;  // [1]
};
inline constexpr FrictionRange table_q{-2, 4};

// Domain:     as fibre_states.
// Max error:  relative, 1e-12 in w; in F 1e-12 times its condition number (elastica.h).
// Cost:       about 10 ns a state; 4 µs for the first in a cell.
StateArrays tabulated_states(const FibrePoints& points);

// With the derivatives of the interpolants.
// Max error:  of w and F as above; of X_S 1e-10 of the larger of |X_S| and |X|/(S - 1), of X_q 1e-10 of the larger of |X_q| and
//             |X|/(1 + |q|); for X = F that times the condition number of F.
// Cost:       about 20 ns a state.
SlopeArrays tabulated_states_slopes(const FibrePoints& points);

// The states of one pair of supports (supported_state.h) tabulated: S - 1 with F, θ0 with Pn, and U with the curvature, over deflection and friction; and w
// with F over length and friction, where the two lengths of a friction that are alike are far enough away for polynomials.
//
// Reduced variables. Where a table has nothing its values are computed. May be asked from several threads at once.

class SupportedTables {
 public:
  // Domain: as state_on_supports, and not edges of a specimen without thickness.
  explicit SupportedTables(const Supports& on);

  // Those of the sixteen supports that were asked for last are shared.
  static std::shared_ptr<const SupportedTables> of(const Supports& supports);

  // [L] The least length that a friction of zero lets slide back to, to first order.
  static double least_length(const Supports& supports) { return 1 - 3.75 * supports.half_depth * supports.half_depth; }
  // [L], [EI/L^2] The deflection and the force there.
  double least_w() const { return 1.25 * supports.half_depth; }
  double least_F() const { return beam_stiffness * least_w(); }

  // w - least_w and F - least_F over lengths, 1 for the least, and frictions.
  const CellTable& by_length() const { return by_length_; }

  // A pair of quantities with their slopes along w [L] and in q: first, second, first_w, first_q, second_w, second_q; of one state (no memory of the
  // heap), of many. NaN where there is no state: beyond deepest_on_supports or largest_q, or where none is led on to beyond the branch, with a force below 0. Max error: as Fibre::state_slopes.
  using PairSlope = std::array<double, 6>;
  struct PairSlopes {
    std::array<std::vector<double>, 6> columns;
    explicit PairSlopes(std::size_t n);
    std::array<double*, 6> data();
  };
  PairSlopes sliding(std::span<const double> w, std::span<const double> q) const;   // [L] S - 1, [EI/L^2] F
  PairSlopes contacts(std::span<const double> w, std::span<const double> q) const;  // [rad] θ0, [EI/L^2] Pn
  PairSlope sliding(double w, double q) const;
  PairSlope contacts(double w, double q) const;
  struct Bending {
    double U, curvature;  // [EI/L], [1/L] at midspan
  };
  Bending bending(double w, double q) const;
  std::vector<double> curvatures(std::span<const double> w, std::span<const double> q) const;  // [1/L] likewise
  std::vector<double> forces(std::span<const double> w,
                             std::span<const double> q) const;  // [EI/L^2] F, as that of sliding

  // [L] Deflections of lengths S, the more bent ones: by Newton's iteration, from a guess for each where there is one (w; NaN: none), as the length is
  // convex in the deflection. NaN where there is no state; beyond the end of the branch, where one is led on to, its force
  // is below 0.
  std::vector<double> deflections(std::span<const double> S, std::span<const double> q) const;
  std::vector<double> deflections(std::span<const double> S, std::span<const double> q, std::vector<double> w) const;
  double deflection(double S, double q) const;

  const Supports supports;
  // [L] The length from which on by_length has states, where it has them at all.
  const double smooth_from;

 private:
  using Field = double SupportedState::*;
  struct Step {
    double w;
    bool is_last;
  };
  // Where the branch of a friction ends, to its error above; infinite if not before deepest_on_supports.
  struct BranchEnd {
    double w, slid;  // [L]
  };
  static constexpr std::size_t ends = 49;  // frictions evenly over those of the tables

  double guessed_deflection(double S, double q) const;
  double shallow_deflection(double S) const;
  Step step_from(double w, double S, double q, double slid, double slid_w) const;
  double beyond(double S, double q) const;
  BranchEnd branch_end(double q) const;
  BranchEnd end_at(std::size_t index) const;
  SupportedState state(double w, double q) const;
  SupportedState state(double w, double q, PhaseAndSpan& from) const;
  // Of all nodes of a cell, for the three tables over deflection and friction alike.
  using CellStates = std::vector<SupportedState>;
  const CellStates& cell_states(std::span<const double> w, std::span<const double> q) const;
  CellTable::Source source(Field first, Field second) const;
  CellTable::Pair pair_by_length(std::span<const double> x, std::span<const double> q) const;
  PairSlopes slopes(const CellTable& table, Field first, Field second, std::span<const double> w,
                    std::span<const double> q) const;
  PairSlope slopes(const CellTable& table, Field first, Field second, double w, double q) const;
  void fill_slopes(const CellTable& table, Field first, Field second, std::span<const double> w,
                   std::span<const double> q, const std::array<double*, 6>& columns) const;

  CellTable sliding_, contacts_, bent_, by_length_;
  mutable std::mutex solving_;
  mutable std::map<std::pair<double, double>, CellStates> solved_;  // by the first node
  mutable std::array<std::once_flag, ends> end_known_;
  mutable std::array<BranchEnd, ends> ends_{};
};

}  // namespace flexslip
