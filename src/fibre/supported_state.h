// The elastica on rollers or with a thickness: the state of elastica.h with an axis at a distance
// from the supports.
//
// The surface of the specimen touches a roller, so its axis touches a circle of R = r + τ. The
// friction at the surface bends the axis by a couple q Pn τ. The pendulum is the same, but does not
// start at its inflection (theory.md, "Rollers and thickness"). Three lengths that are equal on
// knife edges differ: the axis between the contacts, which determines friction; the sliding length;
// and the length that a camera sees.
#pragma once

#include "fibre/elastica.h"

namespace flexslip {

struct Supports {
  double radius;      // [L] of fixed rollers; 0 for knife edges
  double half_depth;  // [L] τ, of the specimen; 0: friction acts at the axis
};

// [L] limit of radius plus half depth, which leaves a tenth of the span free.
inline constexpr double widest_supports = 0.45;
inline constexpr double deepest_on_supports = 2;  // [L] limit of the deflection

// Lengths include both sides.
struct SupportedState {
  FibreStatus status;  // the other fields are valid only if ok
  double length;       // [L] S, axis between the contacts
  // [L] Σ - 1, length of surface that slid in past the contacts of the straight specimen
  double slid;
  // [L] axis between the vertical planes through the supports; NaN once vertical there
  double imaged;
  double q;          // [1] mobilised friction
  double w;          // [L] deflection at midspan
  double F;          // [EI/L^2] force there
  double theta0;     // [rad] slope at the contacts
  double Pn;         // [EI/L^2] normal force at one support
  double U;          // [EI/L] bending energy between the contacts
  double curvature;  // [1/L] at midspan
};

// The state with mobilised friction q and deflection w.
// Domain:     q in [-20, 20], w in (0, deepest_on_supports]; radius and half depth >= 0, their sum
//             below widest_supports; std::invalid_argument otherwise.
// Max error:  w is reproduced to 1e-12; for w <= 0.35 and q in [-0.8, 1.5] all else to 1e-11
//             (tests/fibre/supported_state_test.cpp).
// Fails:      beyond_branch: no state exists, none has a positive force, or none was found. The
//             last is possible for a radius or half depth above a tenth of the span, a friction
//             above 2, or a deflection beyond the span.
// Method:     closed form in Jacobi's functions of the half span and the phase; both by Newton's
//             iteration, or the secant method within brackets.
// Cost:       1 µs; 50 µs without a state, or at a large deflection for which Newton's iteration
//             fails.
SupportedState state_on_supports(double w, double q, const Supports& supports);

// The start or the result of Newton's iteration: phase at midspan and half span, in units in which
// the phase is the arc length.
struct PhaseAndSpan {
  double phase = 0, half_span = 0;  // 0: unknown
};

// The state, extrapolated beyond the end of the branch while it is smooth: the force is then
// negative. The iteration starts at `from` and stores its result there.
SupportedState extrapolated_state(double w, double q, const Supports& supports, PhaseAndSpan& from);
SupportedState extrapolated_state(double w, double q, const Supports& supports);

// The result for a friction without a state: beyond_branch.
SupportedState no_state_on_supports(double q);

// In half depths, the smallest deflection at which friction can be determined. Above 1.25 half
// depths the force increases with friction, at first only slightly.
inline constexpr double least_half_depths = 4;
inline constexpr double largest_q_on_supports = 2;  // [1] limit of the friction

// The inverse: the state with deflection w and force F.
// Domain:     as above; F >= 0.
// Tolerance:  F is reproduced to 1e-12 of max(F, w).
// Fails:      no_friction if no friction in [-2, 2] gives the force, or w < least_half_depths half
//             depths.
// Method:     the secant method in q on state_on_supports, guarded by bisection.
SupportedState state_on_supports_from_force(double w, double F, const Supports& supports);

}  // namespace flexslip
