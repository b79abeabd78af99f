// A slender specimen on its two supports: the map Ψ from (S, q) to (w, F) for any supports.
//
// On knife edges without a thickness, Ψ is elastica.h, bit for bit. On rollers or with a
// thickness it is supported_state.h, from tables (state_table.h) filled on demand. S is
// then the sliding length Σ: the span plus the length of surface that slid in past the contacts of
// the straight specimen. Copies share the tables.
//
// With a thickness the surface first slides outwards, so two states share each length just below
// and above 1. Functions of S return the state with the larger deflection; functions of w are
// unambiguous.
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
  // [1] limit of the friction
  double max_friction() const { return on_edges() ? largest_q : largest_q_on_supports; }

  // The state at S and q, with the functions of elastica.h and batch.h.
  // Domain:     as fibre_state; on rollers or with a thickness also w <= deepest_on_supports.
  // Max error:  on rollers or with a thickness, for w <= 0.35 and q in [-0.8, 2]: relative 1e-12 in
  //             w, F, theta0, Pn and U; of X_S 1e-9 of max(|X_S|, |X|/w), of X_q 1e-9 of max(|X_q|,
  //             |X|/(1 + |q|)) (tests/fibre/fibre_test.cpp).
  // Cost:       on rollers or with a thickness 0.5 µs, tabulated_states 40 ns (bench/speed), 0.3 ms
  //             for a new cell; 10 µs and more for q outside [-2, 4).
  FibreState state(double S, double q) const;
  FibreStateSlopes state_slopes(double S, double q) const;
  // The same with a known deflection, which saves the search for w; as accurate as w.
  FibreStateSlopes state_slopes(double S, double q, double w) const;
  FibreState state_from_force(double w, double F) const;

  StateArrays states(const FibrePoints& points) const;
  SlopeArrays states_slopes(const FibrePoints& points) const;
  StateArrays tabulated_states(const FibrePoints& points) const;
  SlopeArrays tabulated_states_slopes(const FibrePoints& points) const;
  // One state of tabulated_states_slopes, bit for bit, without the heap; on knife edges, of
  // states_slopes.
  struct TabulatedSlopes {
    double w, F, w_S, w_q, F_S, F_q;
  };
  TabulatedSlopes tabulated_state_slopes(double S, double q) const;
  // As tabulated_states_slopes, but on rollers or with a thickness NaN within a table cell (0.024
  // of σ, 1/8 of q) of the end of the branch. There the force is nearly zero and a state costs 0.1
  // ms.
  SlopeArrays states_slopes_before_branch_end(const FibrePoints& points) const;
  InverseArrays states_from_forces(std::span<const double> w, std::span<const double> F) const;
  InverseArrays tabulated_states_from_forces(std::span<const double> w, std::span<const double> F) const;

  // The state at a deflection, on either side of the smallest length. U is NaN; use
  // state_at_deflection for the energy. X_w is at fixed q, and X_q at fixed w.
  // Domain:     rollers or a thickness; w >= 0; q = 0 at w = 0.
  struct DeflectionState {
    FibreState state;
    double slid;  // [L] S - 1, without cancellation
    double S_w, S_q, F_w, F_q, theta0_w, theta0_q, Pn_w, Pn_q;
    void move_by(double dq);  // changes q at fixed w, to first order
  };
  DeflectionState at_deflection(double w, double q) const;
  // Half the time: without θ0 and Pn, which are NaN unless w = 0.
  DeflectionState at_deflection_without_contacts(double w, double q) const;
  DeflectionState add_contacts(DeflectionState at) const;    // adds θ0 and Pn
  FibreState state_at_deflection(double w, double q) const;  // with the energy
  // [EI/L^2] Forces only, also on knife edges (Domain and Max error as at_deflection); NaN without
  // a state.
  std::vector<double> forces_at_deflections(std::span<const double> w, std::span<const double> q) const;

  // [L] Derivatives of the length between the contacts with respect to q at fixed w. NaN without a
  // state. Not on knife edges.
  std::vector<double> length_friction_derivatives(std::span<const double> w, std::span<const double> q) const;

  // [L] The length of the axis between the contacts, which determines the friction coefficient.
  double length_between_contacts(const FibreState& state) const {
    const double radius = supports().radius;
    return radius > 0 ? state.S - 2 * radius * state.theta0 : state.S;
  }

  // [L] The length of the axis between the vertical planes through the supports, as a camera sees
  // it. NaN once the specimen is vertical at a support.
  double imaged_length(const FibreState& state) const;

  // The length between the contacts with its slopes, extrapolated beyond the end of the branch; NaN
  // if impossible.
  struct Contact {
    double length, length_S, length_q;
  };
  Contact contact(double S, double q) const;
  // The same for many states, without extrapolation. Max error: as tabulated_states.
  struct ContactArrays {
    std::vector<double> length, length_S, length_q;
  };
  ContactArrays contacts(const FibrePoints& points) const;

  // The sliding coordinate σ = √(S - Σ0), in which curves are smooth at their start. Σ0, 1 on knife
  // edges, is the smallest length at small deflection. Domain: S >= 1.
  double sliding_coordinate(double S) const { return std::sqrt(S - least_length_); }
  double length_at(double sigma) const { return least_length_ + sigma * sigma; }
  double least_length() const { return least_length_; }
  bool slides_inward_only() const { return least_length_ == 1; }  // true without a thickness

  // [EI/L^2] Bending energy per length of the axis that leaves the span: κ0²/2, with the curvature
  // κ0 that friction at the surface causes.
  double bending_energy_lost_at_contact(const FibreState& state) const {
    const double couple = state.q * state.Pn * supports().half_depth;
    return 0.5 * couple * couple;
  }

  // [1/L] Max error: as curvature_at_midspan of elastica.h.
  double curvature_at_midspan(const FibreState& state) const;
  // [1/L] The same for many states with known deflections; NaN without a state.
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
  double smooth_from_ = 1;   // [L] the table by length is used above
};

// The contact points along the specimen as it slides in over rollers.
//
// The specimen slides and rolls together. At first the contacts roll outwards faster than it slides
// in, so the axis between them becomes shorter; later it becomes longer. The travel of the contacts
// along the specimen always increases (theory.md, "Rollers and thickness").

class ContactPath {
 public:
  // Knife edges: the sliding length is the length between the contacts.
  ContactPath() = default;

  // At constant friction, for sliding lengths in [S_least, S_most]; linear outside.
  // Domain:     1 < S_least < S_most, and the specimen has states between; on knife edges as above.
  // Max error:  1e-6 of the length at this friction.
  ContactPath(const Fibre& fibre, double q, double S_least, double S_most);

  // [L] The travel ξ, rising: the length between the contacts once it grows, before that its mirror
  // image about the minimum.
  double at(double S) const;
  double slope(double S) const;  // dξ/dΣ >= 0

  // [L] The sliding length at this travel.
  double sliding_length_at(double travel) const;

  // True if the contacts roll outwards faster than the specimen slides in.
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
  std::vector<Value> knots_;                // empty on knife edges
  double turn_at_ = 0;                      // σ at the minimum
  double turn_ = -infinity;                 // [L] minimum length between the contacts
};

}  // namespace flexslip
