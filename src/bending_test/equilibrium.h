// Equilibrium of the fibre by itself: every (S, q) with |q| <= μ(S), and the curve on which it slides (Figs. 7 and 8A).
#pragma once

#include <span>
#include <vector>

#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

// A state of the fibre in the spaces of Fig. 7. Reduced variables, as in fibre/elastica.h.
struct EquilibriumPoint {
  double S;  // [L]
  double q;  // [1]
  double w;  // [L]
  double F;  // [EI/L^2]
};

// Which way the fibre slides: drawn in (loading), q = μ; let out (unloading), q = -μ.
enum class Sliding { in, out };

enum class EquilibriumStatus {
  ok,
  branch_ended,  // the force fell to zero before S_max: the points end there, the last one with F = 0
};

struct EquilibriumCurve {
  EquilibriumStatus status;
  std::vector<EquilibriumPoint> points;  // S rising
};

// The envelope of the equilibrium region on which the fibre slides: (4.28).
// Domain:     S_max > 1; n >= 2; std::invalid_argument otherwise.
// Method:     n points evenly spaced in √(S - 1) (Fibre::way), in which the curve starts as a straight line. Each point is exact.
EquilibriumCurve equilibrium_curve(const Friction& friction, Sliding sliding, double S_max, int n,
                                   const Fibre& fibre = {});

// Sliding in at one friction, up to a deflection [L] or beyond, or to the end of the branch; n points, w rising.
// Domain:     deflection > 0; n >= 2; mu as Friction::constant; std::invalid_argument otherwise.
std::vector<EquilibriumPoint> sliding_up_to(double deflection, double mu, int n, const Fibre& fibre = {});

// [EI/L^2] The force on such a curve, between its points by a straight line; NaN where it has none.
double force_at(std::span<const EquilibriumPoint> curve, double deflection);

// As equilibrium_curve, for bulk work, each point to the accuracy of the table (fibre/state_table.h).
EquilibriumCurve tabulated_equilibrium_curve(const Friction& friction, Sliding sliding, double S_max, int n,
                                             const Fibre& fibre = {});

// The equilibrium region: n_S by n_q points, q from -μ(S) to μ(S) (Algorithm 1, with its step corrected, theory.md); on rollers from the friction
// met on the way out to that met on the way in.
// Domain:     as above; n_q >= 2. Points of the grid beyond the end of the branch are left out.
std::vector<EquilibriumPoint> equilibrium_region(const Friction& friction, double S_max, int n_S, int n_q,
                                                 const Fibre& fibre = {});

}  // namespace flexslip
