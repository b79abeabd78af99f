// Tables of Ψ, for work that needs many states to 12 digits; also on rollers or with a thickness.
//
// Piecewise Chebyshev interpolation of w/σ and F/σ in σ = √(S - 1) and q, in which Ψ is smooth down
// to the straight specimen. The tables are independent of friction law and rig, and their cells are
// filled on demand (cell_table.h). Reduced variables as in elastica.h; arrays as in batch.h, except
// for the accuracy.
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

// The range of interpolation: 0 < σ < table_sigma, q in [table_q.least, table_q.greatest). Outside,
// and near the end of the branch, states are computed as in batch.h.
inline constexpr double table_sigma = 1.05;  // [√L] S up to 2.1
struct FrictionRange {
  double least, greatest;  // [1]
};
inline constexpr FrictionRange table_q{-2, 4};

// Domain:     as fibre_states.
// Max error:  relative, 1e-12 in w; in F 1e-12 times its condition number (elastica.h).
// Cost:       about 10 ns a state; 4 µs for the first in a cell.
StateArrays tabulated_states(const FibrePoints& points);

// The same with the derivatives of the interpolants.
// Max error:  of w and F as above; of X_S 1e-10 of max(|X_S|, |X|/(S - 1)), of X_q 1e-10 of
//             max(|X_q|, |X|/(1 + |q|)); for X = F times the condition number of F.
// Cost:       about 20 ns a state.
SlopeArrays tabulated_states_slopes(const FibrePoints& points);

// Tables of the states on one pair of supports (supported_state.h). Over deflection and friction: S
// - 1 with F, θ0 with Pn, and U with the curvature. Over length and friction: w with F, if the two
// states that share a length are far enough apart for polynomials.
//
// Reduced variables. Values outside a table are computed. Thread-safe.

class SupportedTables {
 public:
  // Domain:     as state_on_supports; not knife edges without a thickness.
  explicit SupportedTables(const Supports& on);

  // The tables of the sixteen most recent supports are shared.
  static std::shared_ptr<const SupportedTables> of(const Supports& supports);

  // [L] The smallest length at zero friction, to first order.
  static double least_length(const Supports& supports) { return 1 - 3.75 * supports.half_depth * supports.half_depth; }
  // [L], [EI/L^2] Deflection and force at this length.
  double least_w() const { return 1.25 * supports.half_depth; }
  double least_F() const { return beam_stiffness * least_w(); }

  // w - least_w and F - least_F over length (the smallest counts as 1) and friction.
  const CellTable& by_length() const { return by_length_; }

  // A pair of quantities with their slopes in w [L] and q: first, second, first_w, first_q,
  // second_w, second_q; for one state (without the heap) or many. NaN without a state: beyond
  // deepest_on_supports or largest_q, or where extrapolation beyond the branch fails.
  // Max error:  as Fibre::state_slopes.
  using PairSlope = std::array<double, 6>;
  struct PairSlopes {
    std::array<std::vector<double>, 6> columns;
    explicit PairSlopes(std::size_t n);
    std::array<double*, 6> data();
  };
  // [L] S - 1, [EI/L^2] F
  PairSlopes sliding(std::span<const double> w, std::span<const double> q) const;
  // [rad] θ0, [EI/L^2] Pn
  PairSlopes contacts(std::span<const double> w, std::span<const double> q) const;
  PairSlope sliding(double w, double q) const;
  PairSlope contacts(double w, double q) const;
  struct Bending {
    double U, curvature;  // [EI/L], [1/L] at midspan
  };
  Bending bending(double w, double q) const;
  // [1/L]
  std::vector<double> curvatures(std::span<const double> w, std::span<const double> q) const;
  std::vector<double> forces(std::span<const double> w,
                             std::span<const double> q) const;  // [EI/L^2] F, as by sliding

  // [L] Deflections at lengths S, the larger of two. Newton's iteration from w as a guess (NaN for
  // none), because the length is convex in the deflection. NaN without a state. Beyond the end of
  // the branch the extrapolated force is negative.
  std::vector<double> deflections(std::span<const double> S, std::span<const double> q) const;
  std::vector<double> deflections(std::span<const double> S, std::span<const double> q, std::vector<double> w) const;
  double deflection(double S, double q) const;

  const Supports supports;
  // [L] the smallest length in by_length
  const double smooth_from;

 private:
  using Field = double SupportedState::*;
  struct Step {
    double w;
    bool is_last;
  };
  // The end of the branch at a friction, rounded up by its error; infinite if beyond
  // deepest_on_supports.
  struct BranchEnd {
    double w, slid;  // [L]
  };
  static constexpr std::size_t ends = 49;  // frictions, evenly spaced over the tables

  double guessed_deflection(double S, double q) const;
  double shallow_deflection(double S) const;
  Step step_from(double w, double S, double q, double slid, double slid_w) const;
  double beyond(double S, double q) const;
  BranchEnd branch_end(double q) const;
  BranchEnd end_at(std::size_t index) const;
  SupportedState state(double w, double q) const;
  SupportedState state(double w, double q, PhaseAndSpan& from) const;
  // The states at all nodes of a cell, shared by the three tables over deflection.
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
  mutable std::map<std::pair<double, double>, CellStates> solved_;  // key: the first node
  mutable std::array<std::once_flag, ends> end_known_;
  mutable std::array<BranchEnd, ends> ends_{};
};

}  // namespace flexslip
