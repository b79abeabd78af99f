// The elastica between two supports: one smooth map Ψ from (S, q) to (w, F). All mechanics of FlexSlip is here.
//
// Reduced variables throughout (docs/theory.md, "Scaling"): lengths in spans L, forces in EI/L^2, energies in EI/L.
// S is the arc length between the supports, q = -P_t/P_n the mobilised friction (tangential over normal support force,
// positive when friction resists the fibre being drawn in), w the deflection at midspan, F the force there.
#pragma once

namespace flexslip {

enum class FibreStatus {
  ok,             // all fields are valid
  beyond_branch,  // no such state: S exceeds the end of the branch for this q, where F has fallen to zero; only S, q are valid
  no_friction,  // no q in [-20, 20] explains this deflection and force; only w, F are valid
};

struct FibreState {
  FibreStatus status;
  double S;       // [L] arc length between the supports
  double q;       // [1] mobilised friction
  double w;       // [L] deflection at midspan
  double F;       // [EI/L^2] force at midspan
  double theta0;  // [rad] slope of the fibre at the support
  double Pn;      // [EI/L^2] normal force at one support
  double U;       // [EI/L] bending energy of the whole fibre
  double u;       // [1] half the pendulum's phase, ω/2 of (4.15b): what shape() starts from
};

// Partial derivatives of a state with respect to S at fixed q, and to q at fixed S. Units as those of the state.
struct FibreSlopes {
  double w_S, w_q, F_S, F_q, Pn_S, Pn_q, U_S, U_q, theta0_S, theta0_q;
};

struct FibreStateSlopes {
  FibreState state;
  FibreSlopes slopes;  // valid if state.status is ok and S > 1
};

inline constexpr double largest_q = 20;  // [1] of mobilised friction that is computed

// Ψ: the state of a fibre of length S with mobilised friction q.
// Domain:     S >= 1 and q in [-20, 20]; std::invalid_argument outside.
// Max error:  relative, 3e-15 in w and Pn, 4e-15 in theta0, 8e-15 in U, 8e-15 in F times its condition number
//             1 + |(S - 1) F_S/F| + |q F_q/F| (tests/fibre/elastica_test.cpp, docs/numerics.md).
// Fails:      beyond_branch.
// Method:     closed form in Jacobi's functions at u (theory.md, "The state"); u by Halley's iteration on
//             (1 - 1/S)^(1/4), which is nearly linear in u.
// Cost:       below 1 µs.
FibreState fibre_state(double S, double q);

// The same with exact first derivatives.
// Max error:  of X_S 1e-14 of the larger of |X_S| and |X|/(S - 1), of X_q 1e-14 of the larger of |X_q| and |X|/(1 + |q|); for
//             X = F that times the condition number of F.
FibreStateSlopes fibre_state_slopes(double S, double q);

// The inverse of Ψ: the state with deflection w and force F.
// Domain:     w >= 0 and F >= 0, finite; std::invalid_argument otherwise. w = F = 0 is the straight fibre, with q = 0.
// Tolerance:  w is reproduced to 32 S ulp, F to that times its condition number; S and q as well as w and F determine them (q hardly, below w = 0.1).
// Fails:      no_friction; also for 0 < w < 1e-8, where S rounds to 1.
// Method:     Newton's iteration in (u, β0), guarded by bisection in q along w = const.
// Cost:       about 2 µs.
FibreState fibre_state_from_force(double w, double F);

// The curvature of the fibre at midspan [1/L], where it is greatest: the bending moment there, over EI.
// Domain:     state.status ok; std::invalid_argument otherwise.
// Max error:  1e-12, typically 1e-15; for q < 0 times 1 + |q| θ0.
// Method:     along an elastica κ²/2 changes as the tangential force does, and at the support κ = 0 (theory.md, "What the specimen bears").
double curvature_at_midspan(const FibreState& state);

// Where the branch ends: the longest fibre that carries a force, F = 0 there.
struct BranchEnd {
  double S;  // [L] infinite for q above 0.860...
  double w;  // [L] infinite likewise
  double u;  // [1] K(m)
};

// Domain:     q in [-20, 20]; std::invalid_argument outside.
// Max error:  u 2 ulp; S and w 16 ulp where finite, times 1 + |q/(q - 0.8604366861256783)|, their condition number.
BranchEnd fibre_branch_end(double q);

// A point of the deformed fibre.
struct ShapePoint {
  double x;      // [L] distance from the left support, along the span
  double y;      // [L] deflection
  double theta;  // [rad] slope
};

// The deformed shape at the arc length s from the left support, as a fraction of S.
// Domain:     state.status ok, 0 <= s <= 1; std::invalid_argument otherwise.
// Max error:  16 ulp of w in y, 20 of S in x, 8 of theta0 in theta; at midspan 12.8 and 15.4 were the worst of 10^7 states, 0 in theta.
ShapePoint fibre_shape(const FibreState& state, double s);

}  // namespace flexslip
