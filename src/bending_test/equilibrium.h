// Equilibrium of the specimen without a rig: every (S, q) with |q| <= μ(S), and the curve on which
// it slides (Figs. 7 and 8A).
#pragma once

#include <span>
#include <vector>

#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

// A state in the spaces of Fig. 7. Reduced variables, as in fibre/elastica.h.
struct EquilibriumPoint {
  double S;  // [L]
  double q;  // [1]
  double w;  // [L]
  double F;  // [EI/L^2]
};

// The sliding direction: in (loading), q = μ; out (unloading), q = -μ.
enum class Sliding { in, out };

enum class EquilibriumStatus {
  ok,
  branch_ended,  // the force reaches zero before S_max; the last point has F = 0
};

struct EquilibriumCurve {
  EquilibriumStatus status;
  std::vector<EquilibriumPoint> points;  // S rising
};

// The curve on which the specimen slides, the envelope of the equilibrium region: (4.28).
// Domain:     S_max > 1; n >= 2; std::invalid_argument otherwise.
// Method:     n points evenly spaced in the sliding coordinate √(S - 1), in which the curve starts
//             as a straight line. Each point is exact.
EquilibriumCurve equilibrium_curve(const Friction& friction, Sliding sliding, double S_max, int n,
                                   const Fibre& fibre = {});

// Sliding in at constant friction, to a deflection [L] or beyond, or to the end of the branch; n
// points, w rising.
// Domain:     deflection > 0; n >= 2; mu as Friction::constant; std::invalid_argument otherwise.
std::vector<EquilibriumPoint> sliding_up_to(double deflection, double mu, int n, const Fibre& fibre = {});

// [EI/L^2] The force at a deflection, interpolated linearly; NaN outside the curve.
double force_at(std::span<const EquilibriumPoint> curve, double deflection);

// The same with the accuracy of the tables (fibre/state_table.h), for bulk work.
EquilibriumCurve tabulated_equilibrium_curve(const Friction& friction, Sliding sliding, double S_max, int n,
                                             const Fibre& fibre = {});

// The equilibrium region: n_S by n_q points, q from -μ(S) to μ(S) (Algorithm 1, with its step
// corrected, theory.md). On rollers the limits are the frictions for sliding out and in.
// Domain:     as above; n_q >= 2. Points beyond the end of the branch are omitted.
std::vector<EquilibriumPoint> equilibrium_region(const Friction& friction, double S_max, int n_S, int n_q,
                                                 const Fibre& fibre = {});

}  // namespace flexslip
