// The elastica between two supports: one smooth map Ψ from (S, q) to (w, F), on which all mechanics
// of FlexSlip rests.
//
// Reduced variables throughout (docs/theory.md, "Scaling"): lengths in spans L, forces in EI/L^2,
// energies in EI/L. S is the arc length between the supports and w the deflection at midspan, F the
// force there. q = -P_t/P_n is the mobilised friction, tangential over normal support force,
// positive if friction resists sliding in.
#pragma once

namespace flexslip {

enum class FibreStatus {
  ok,  // all fields are valid
  // no such state: for this q the force reaches zero at a smaller S; only S, q are valid
  beyond_branch,
  no_friction,  // no q in [-20, 20] explains this deflection and force; only w, F are valid
};

struct FibreState {
  FibreStatus status;
  double S;       // [L] arc length between the supports
  double q;       // [1] mobilised friction
  double w;       // [L] deflection at midspan
  double F;       // [EI/L^2] force at midspan
  double theta0;  // [rad] slope at the support
  double Pn;      // [EI/L^2] normal force at one support
  double U;       // [EI/L] bending energy of the whole specimen
  double u;       // [1] half the phase of the pendulum, ω/2 of (4.15b); shape() uses it
};

// Partial derivatives of a state, X_S at fixed q and X_q at fixed S. Units as for the state.
struct FibreSlopes {
  double w_S, w_q, F_S, F_q, Pn_S, Pn_q, U_S, U_q, theta0_S, theta0_q;
};

struct FibreStateSlopes {
  FibreState state;
  FibreSlopes slopes;  // valid if state.status is ok and S > 1
};

inline constexpr double largest_q = 20;  // [1] limit of the mobilised friction

// Ψ: the state at length S and mobilised friction q.
// Domain:     S >= 1 and q in [-20, 20]; std::invalid_argument otherwise.
// Max error:  relative, 3e-15 in w and Pn, 4e-15 in theta0, 8e-15 in U, 8e-15 in F times its
//             condition number 1 + |(S - 1) F_S/F| + |q F_q/F| (tests/fibre/elastica_test.cpp,
//             docs/numerics.md).
// Fails:      beyond_branch.
// Method:     closed form in Jacobi's functions at u (theory.md, "The state"); u by Halley's
//             iteration on (1 - 1/S)^(1/4), which is nearly linear in u.
// Cost:       below 1 µs.
FibreState fibre_state(double S, double q);

// The state with exact first derivatives.
// Max error:  of X_S 1e-14 of max(|X_S|, |X|/(S - 1)), of X_q 1e-14 of max(|X_q|, |X|/(1 + |q|));
//             for X = F times the condition number of F.
FibreStateSlopes fibre_state_slopes(double S, double q);

// The inverse of Ψ: the state with deflection w and force F.
// Domain:     w >= 0 and F >= 0, finite; std::invalid_argument otherwise. w = F = 0 gives the
//             straight specimen, with q = 0.
// Tolerance:  w is reproduced to 32 S ulp, F to 32 S ulp times its condition number. S and q are as
//             well determined as w and F determine them (q poorly, below w = 0.1).
// Fails:      no_friction; also for 0 < w < 1e-8, where S rounds to 1.
// Method:     Newton's iteration in (u, β0), guarded by bisection in q at constant w.
// Cost:       about 2 µs.
FibreState fibre_state_from_force(double w, double F);

// [1/L] The curvature at midspan, which is the maximum: the bending moment over EI.
// Domain:     state.status ok; std::invalid_argument otherwise.
// Max error:  1e-12, typically 1e-15; for q < 0 times 1 + |q| θ0.
// Method:     along an elastica κ²/2 changes with the tangential force, and κ = 0 at the support
//             (theory.md, "What the specimen bears").
double curvature_at_midspan(const FibreState& state);

// The end of the branch: the longest specimen in equilibrium, with F = 0.
struct BranchEnd {
  double S;  // [L] infinite for q above 0.860...
  double w;  // [L] infinite for the same q
  double u;  // [1] K(m)
};

// Domain:     q in [-20, 20]; std::invalid_argument otherwise.
// Max error:  u 2 ulp; S and w, if finite, 16 ulp times their condition number 1 + |q/(q -
//             0.8604366861256783)|.
BranchEnd fibre_branch_end(double q);

// A point of the deformed specimen.
struct ShapePoint {
  double x;      // [L] distance from the left support, along the span
  double y;      // [L] deflection
  double theta;  // [rad] slope
};

// The deformed shape at the arc length s from the left support, as a fraction of S.
// Domain:     state.status ok, 0 <= s <= 1; std::invalid_argument otherwise.
// Max error:  16 ulp of w in y, 20 of S in x, 8 of theta0 in theta. At midspan the worst of 10^7
//             states had 12.8, 15.4 and 0.
ShapePoint fibre_shape(const FibreState& state, double s);

}  // namespace flexslip
