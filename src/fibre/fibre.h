// The fibre on its supports: one map Ψ for whatever the supports are.
//
// On knife edges, of a specimen without thickness, it is that of elastica.h, bit by bit. On rollers, or with a thickness, that of
// supported_state.h by tables (state_table.h) built where they are asked for; S then is Σ, what has been drawn in along the surface past the
// contacts of the straight fibre, plus the span: what slides, what sticks, and what a snap jumps in. Copies share the tables.
//
// With a thickness the surface slides outwards first, so that two states belong to a length below 1 and just above: here a length means the
// more bent one. States are told apart by their deflection.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "fibre/batch.h"
#include "fibre/batch_inverse.h"
#include "fibre/elastica.h"
#include "fibre/supported_state.h"
#include "numerics/elementary.h"

namespace flexslip {

class SupportedTables;

class Fibre {
 public:
  Fibre() = default;
  // Domain: as state_on_supports.
  explicit Fibre(const Supports& supports);

  bool on_edges() const { return tables_ == nullptr; }
  const Supports& supports() const;
  // [1] Of friction that is computed.
  double max_friction() const { return on_edges() ? largest_q : largest_q_on_supports; }

  // As fibre_state and its kin. Domain besides, if not on edges: deflections up to deepest_on_supports.
  // Max error:  if not on edges, for w <= 0.35 and q in [-0.8, 2]: relative, 1e-12 in w, F, theta0, Pn and U; of slopes 1e-9 of the larger of |X_S|
  //             and |X|/w, of X_q likewise of |X_q| and |X|/(1 + |q|) (tests/fibre/fibre_test.cpp).
  // Cost:       if not on edges, about 0.5 µs, tabulated_states of many some 40 ns each (bench/speed), and 0.3 ms for a new cell; 10 µs and
  //             more for q beyond [-2, 4).
  FibreState state(double S, double q) const;
  FibreStateSlopes state_slopes(double S, double q) const;
  // The same of a state whose deflection is known, to the error of that: what it saves is to look for it.
  FibreStateSlopes state_slopes(double S, double q, double w) const;
  FibreState state_from_force(double w, double F) const;

  StateArrays states(const FibrePoints& points) const;
  SlopeArrays states_slopes(const FibrePoints& points) const;
  StateArrays tabulated_states(const FibrePoints& points) const;
  SlopeArrays tabulated_states_slopes(const FibrePoints& points) const;
  // The one state of those, bit by bit, in memory of its own; on edges that of states_slopes.
  struct TabulatedSlopes {
    double w, F, w_S, w_q, F_S, F_q;
  };
  TabulatedSlopes tabulated_state_slopes(double S, double q) const;
  // The same but for the last of the branch: if not on edges, NaN within a cell of the table (0.024 of the way, 1/8 of q) from its end, where
  // hardly any force is left and each state costs 0.1 ms.
  SlopeArrays states_slopes_before_branch_end(const FibrePoints& points) const;
  InverseArrays states_from_forces(std::span<const double> w, std::span<const double> F) const;
  InverseArrays tabulated_states_from_forces(std::span<const double> w, std::span<const double> F) const;

  // The state that is bent so far, on either side of the least length; its energy stands in a table of its own, and is NaN here. Slopes are those along w
  // at fixed q, and in q at fixed w.
  // Domain:     not on edges; 0 <= w; the straight fibre has q = 0.
  struct DeflectionState {
    FibreState state;
    double slid;  // [L] S - 1, with the digits that S loses
    double S_w, S_q, F_w, F_q, theta0_w, theta0_q, Pn_w, Pn_q;
    void move_by(double dq);  // along the tangent, the deflection as it is; an error of dq²
  };
  DeflectionState at_deflection(double w, double q) const;
  DeflectionState at_deflection_without_contacts(
      double w, double q) const;  // the same in half the time: θ0 and Pn are NaN, unless w = 0
  DeflectionState add_contacts(DeflectionState drawn_in) const;  // which adds them
  FibreState state_at_deflection(double w, double q) const;      // with its energy
  // [EI/L^2] Its force alone, of many. Domain and accuracy as bent, none of them on edges too; NaN where there is no state with a force.
  std::vector<double> forces_at_deflections(std::span<const double> w, std::span<const double> q) const;

  // [L] By how much the length between the contacts changes with friction at a deflection, of many; NaN where there is no state. Not on edges.
  std::vector<double> length_friction_derivatives(std::span<const double> w, std::span<const double> q) const;

  // [L] The length of axis between the contacts, at which friction is looked up.
  double length_between_contacts(const FibreState& state) const {
    const double radius = supports().radius;
    return radius > 0 ? state.S - 2 * radius * state.theta0 : state.S;
  }

  // [L] Of axis between the verticals through the supports, as a camera sees it; NaN from an upright slope on.
  double imaged_length(const FibreState& state) const;

  // The length between the contacts with its slopes, led on beyond the end of the branch. NaN where there is nothing to lead on to.
  struct Contact {
    double length, length_S, length_q;
  };
  Contact contact(double S, double q) const;
  // The same at many, to the errors of tabulated_states; NaN as well where the branch has ended.
  struct ContactArrays {
    std::vector<double> length, length_S, length_q;
  };
  ContactArrays contacts(const FibrePoints& points) const;

  // A coordinate of the way that the fibre slides, in which its curves have no singularity: σ = √(S - Σ0), Σ0 being the least length of the
  // fibre hardly bent, 1 on edges. S >= 1.
  double sliding_coordinate(double S) const { return std::sqrt(S - least_length_); }
  double length_at(double sigma) const { return least_length_ + sigma * sigma; }
  double least_length() const { return least_length_; }
  bool slides_inward_only() const {
    return least_length_ == 1;
  }  // no thickness: what slides only slides in as the fibre is bent

  // [EI/L^2] The bending that axis loses as it leaves the span, by length of it: κ0²/2, of the curvature that friction at the surface forces on it.
  double bending_energy_lost_at_contact(const FibreState& state) const {
    const double couple = state.q * state.Pn * supports().half_depth;
    return 0.5 * couple * couple;
  }

  // As curvature_at_midspan.
  double curvature_at_midspan(const FibreState& state) const;
  // Those of many lengths, whose deflections are known; NaN where there is no state.
  std::vector<double> curvatures_at_midspan(const FibrePoints& points, std::span<const double> w) const;

 private:
  bool is_straight(double S) const { return S == 1 && slides_inward_only(); }
  enum class NearBranchEnd { computed, left_out };

  std::vector<double> relative_to_least_length(const FibrePoints& points) const;
  template <std::size_t n_columns>
  void complete(const FibrePoints& points, const std::array<double*, n_columns>& columns, NearBranchEnd end) const;
  StateArrays states_by_length(const FibrePoints& points) const;
  SlopeArrays slopes_by_length(const FibrePoints& points, NearBranchEnd end) const;
  SlopeArrays slopes_by_deflection(std::span<const double> S, std::span<const double> q,
                                   std::span<const double> w) const;

  std::shared_ptr<const SupportedTables> tables_;
  double least_length_ = 1;  // [L] Σ0
  double smooth_from_ = 1;   // [L] from which on the table by length is used
};

// Where along the specimen the contacts are, as it is drawn in over rollers.
//
// The fibre is drawn in and rolls on at once: at first the contacts roll outwards faster than it is drawn in, so that the axis between them
// becomes shorter, and later longer. How far they have travelled along the specimen only grows (theory.md, "Rollers and thickness").

class ContactPath {
 public:
  // On edges: a length drawn in is the length between the contacts.
  ContactPath() = default;

  // At a constant friction, for lengths Σ of about [S_least, S_most], linear beyond.
  // Domain:     1 < S_least < S_most, where the fibre has states; on edges that of edges.
  // Max error:  1e-6 of the length, for the friction stated.
  ContactPath(const Fibre& fibre, double q, double S_least, double S_most);

  // [L] Rising: the length between the contacts once it grows, and mirrored at the least length before.
  double at(double S) const;
  double slope(double S) const;  // dξ/dΣ >= 0

  // [L] Σ at which it has come so far.
  double sliding_length_at(double travel) const;

  // Do the contacts roll outwards faster than the fibre is drawn in?
  bool contact_moves_outward_at(double travel) const { return travel < turn_; }
  // [L] The length between the contacts.
  double length_at(double travel) const { return contact_moves_outward_at(travel) ? 2 * turn_ - travel : travel; }

 private:
  struct Value {
    double length, slope;  // [L], dℓ/dσ
  };
  Value value(double sigma) const;

  Fibre fibre_;                             // for its coordinate σ
  double first_ = 0, last_ = 0, step_ = 0;  // of σ
  std::vector<Value> knots_;                // none on edges
  double turn_at_ = 0;                      // σ of the least length
  double turn_ = -infinity;                 // [L] of it
};

}  // namespace flexslip
