// The elastica on rollers, with a thickness: the state of elastica.h where the axis of the specimen stands off from supports that have a radius.
//
// The fibre touches a roller under its surface, so that its axis touches a circle of R = r + τ, and the friction that acts at the surface
// bends the axis by a couple q Pn τ: it is the same pendulum, started off its inflection (theory.md, "Rollers and thickness"). Three lengths
// part there that are one on knife edges: that of the axis between the contacts, at which friction is looked up; that which has slid; and
// what a camera sees.
#pragma once

#include "fibre/elastica.h"

namespace flexslip {

struct Supports {
  double radius;      // [L] of fixed rollers; 0: edges
  double half_depth;  // [L] τ, of the specimen; 0: friction acts at the axis
};

// [L] radius and half depth together: both sides leave a tenth of the span.
inline constexpr double widest_supports = 0.45;
inline constexpr double deepest_on_supports = 2;  // [L] of deflection

// Lengths are those of both sides together.
struct SupportedState {
  FibreStatus status;  // nothing else is valid unless ok
  double length;       // [L] S, of the axis between the contacts
  double slid;         // [L] Σ - 1, drawn in past the contacts of the straight fibre, along the surface
  double imaged;       // [L] of the axis between the verticals through the supports; NaN from an upright slope on
  double q;            // [1] mobilised friction
  double w;            // [L] deflection at midspan
  double F;            // [EI/L^2] force there
  double theta0;       // [rad] slope at the contacts
  double Pn;           // [EI/L^2] normal force at one support
  double U;            // [EI/L] bending energy between the contacts
  double curvature;    // [1/L] at midspan
};

// The state with mobilised friction q and a deflection w.
// Domain:     q in [-20, 20], w in (0, deepest_on_supports]; radius and half depth at least 0, together below widest_supports; std::invalid_argument otherwise.
// Max error:  w is reproduced to 1e-12; for w <= 0.35 and q in [-0.8, 1.5] all else to 1e-11 (tests/fibre/supported_state_test.cpp).
// Fails:      beyond_branch: there is no such state, none with a force, or none was found, as may be on rollers or with a thickness beyond a
//             tenth of the span, with a friction beyond 2, or a deflection beyond the span.
// Method:     closed form in Jacobi's functions of the half span and the phase; both by Newton's iteration, or the secant method within brackets.
// Cost:       1 µs; some 50 µs where there is no state, or one much bent that Newton's iteration does not find.
SupportedState state_on_supports(double w, double q, const Supports& supports);

// Where Newton's iteration begins, or has ended: the phase of midspan and the half span, in units of the length in which the phase is the arc length.
struct PhaseAndSpan {
  double phase = 0, half_span = 0;  // 0: not known
};

// The same, led on beyond the end of the branch as far as it is smooth: with a force below 0, which no support bears. Begins at `from`, and leaves
// there where it has ended.
SupportedState extrapolated_state(double w, double q, const Supports& supports, PhaseAndSpan& from);
SupportedState extrapolated_state(double w, double q, const Supports& supports);

// What stands where there is none with this friction: beyond_branch.
SupportedState no_state_on_supports(double q);

// Deflections below so many half depths tell no friction. From 1.25 on more friction makes for more force, at first hardly any.
inline constexpr double least_half_depths = 4;
inline constexpr double largest_q_on_supports = 2;  // [1] of friction that is looked for

// The inverse: the state with a deflection w and a force F.
// Domain:     as above; F >= 0.
// Tolerance:  F is reproduced to 1e-12 of the larger of F and w.
// Fails:      no_friction where none in [-2, 2] gives the force, or w < 4 half depths.
// Method:     the secant method in q, guarded by bisection, on state_on_supports.
SupportedState state_on_supports_from_force(double w, double F, const Supports& supports);

}  // namespace flexslip
