// The fibre on a loading frame of finite stiffness: overall equilibria, their stability, and the folds where it snaps.
//
// Along the sliding curve q = μ(S) the frame asks for the stage position G(S) = w + F/k. At a given stage position every
// root of G(S) = stage is an overall equilibrium; it is stable where G rises with S (4.31), and at a fold, G' = 0, the
// fibre snaps. (The paper writes k G.)
#pragma once

#include <vector>

#include "bending_test/equilibrium.h"
#include "contact/friction.h"

namespace flexslip {

struct Rig {
  double stiffness;  // [EI/L^3] of whatever carries the load cell; infinity for displacement control; > 0
};

// A point of the sliding curve with the stage position that holds it.
struct RigPoint {
  double S;            // [L]
  double q;            // [1]
  double w;            // [L]
  double F;            // [EI/L^2]
  double stage;        // [L] G(S)
  double stage_slope;  // [1] G'(S); infinite at S = 1
};

struct Fold {
  RigPoint point;
  bool is_maximum;  // of G: where a loading fibre snaps; a minimum is where an unloading one would
};

enum class CurveEnd {
  at_S_max,
  branch_ended,  // the force fell to zero: S_end is the end of the branch
};

// The sliding curve of a test up to S_end, cut at its folds: between two of them G is strictly monotone.
struct LoadingCurve {
  Friction friction;
  Rig rig;
  std::vector<Fold> folds;  // S rising; maxima and minima in turn, a maximum first
  RigPoint end;
  CurveEnd end_reason;
};

// Domain:     rig.stiffness > 0, S_max > 1; std::invalid_argument otherwise.
// Tolerance:  no fold is missed whose snap is longer than 1e-6 of the roughness's period, whatever the wavelength: G' is
//             interpolated by Chebyshev polynomials of degree 8 on cells no longer than half the shortest period (and the
//             pieces between the knots of a table), cells are halved until the interpolant is accurate to 1e-6 of the terms
//             of G', and its roots are counted by Descartes' rule in Bernstein form (theory.md, "Folds"). Folds are then
//             polished to the rounding of G'.
// Fails:      std::invalid_argument if the roughness has more than 1e6 periods on this length, or periods below 1e-9 spans.
// Cost:       about 30 µs for each period of the roughness.
LoadingCurve trace_loading_curve(const Friction& friction, const Rig& rig, double S_max);

// A length that the fibre exceeds only at stage positions beyond `stage`: what to trace to find all equilibria at `stage`.
// Domain:     stage >= 1e-6; std::invalid_argument otherwise. For q >= 0, as in loading.
// Method:     w <= stage, and S - 1 <= 2.4 w^2, which is the limit of small deflection (tested for q in [0, 20]).
double longest_at_stage(double stage);

// Domain: 1 <= S <= curve.end.S.
RigPoint point_at_length(const LoadingCurve& curve, double S);

enum class Stability {
  stable,
  partially_stable,  // at a fold, to 1e-9 of the stage position
  unstable,
};

struct OverallEquilibrium {
  RigPoint point;
  Stability stability;
};

// All overall equilibria at a stage position [L], S rising, within the curve traced (Fig. 8B).
// Max error:  16 ulp in S, times the condition number of G(S) = stage.
std::vector<OverallEquilibrium> overall_equilibria(const LoadingCurve& curve, double stage);

// The part of a curve that a slowly loaded test visits: the running maximum of G. Between parts the fibre snaps.
struct StablePart {
  RigPoint from, to;  // G rises strictly from one to the other; `to` of one part and `from` of the next have equal G
};
std::vector<StablePart> stable_parts(const LoadingCurve& curve);

// The measured state at a stage position: the first S with G(S) >= stage. `part` must contain the stage position.
RigPoint point_at_stage(const LoadingCurve& curve, const StablePart& part, double stage);

}  // namespace flexslip
