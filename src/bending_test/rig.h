// The specimen on a rig of finite stiffness: overall equilibria, their stability, the folds at
// which it snaps, and the range of a loading.
//
// On a sliding curve, q = μ(S) for sliding in or q = -μ(S) for sliding out, equilibrium requires
// the stage position G(S) = w + F/k. Every root of G(S) = stage is an overall equilibrium. It is
// stable if G increases with S (4.31); at a fold, G' = 0, the specimen snaps. (The paper writes k
// G.)
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bending_test/curve_piece.h"
#include "bending_test/equilibrium.h"
#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

struct Rig {
  double stiffness;  // [EI/L^3] > 0, of the load train; infinity for displacement control
  Fibre fibre = {};  // with its supports

  // The rig in units of a bending stiffness that is larger by a factor.
  Rig in_units_of(double times) const { return {stiffness / times, fibre}; }
};

// A point of a sliding curve with its stage position.
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
  bool is_maximum;  // of G: a snap for sliding in; a minimum is one for sliding out
};

enum class CurveEnd {
  reached,       // at the requested length
  branch_ended,  // the force reaches zero: `end` is the last point with F >= 0
};

// A sliding curve between two lengths, in the sliding direction, with its folds. G is strictly
// monotone between folds. See trace.h.
struct SlidingCurve {
  Friction friction;  // on this path (contact/over_rollers.h)
  Rig rig;
  Sliding sliding;
  RigPoint begin;
  std::vector<Fold> folds;  // in the sliding direction; maxima and minima alternate
  RigPoint end;
  CurveEnd end_reason;
  std::size_t looked_at;  // number of points evaluated to find the folds
  // contiguous segments from the beginning of the curve, at most 2^16
  std::vector<CurvePiece> pieces;
};

// An upper bound of the length at a stage position: trace up to it to find all equilibria.
// Domain:     stage >= 1e-6; std::invalid_argument otherwise. For q >= 0, as in loading.
// Method:     w <= stage, and S - 1 <= 2.4 w^2, the limit of small deflection (tested for q in [0,
//             20]).
double longest_at_stage(double stage);

// True if the curve contains a length, to rounding.
bool is_on(const SlidingCurve& curve, double S);

// Domain:     S between curve.begin and curve.end, as in all functions below; std::invalid_argument
//             otherwise.
RigPoint point_at_length(const SlidingCurve& curve, double S);

enum class Stability {
  stable,
  partially_stable,  // at a fold, to 1e-9 of the stage position
  unstable,
};

struct OverallEquilibrium {
  RigPoint point;
  Stability stability;
};

// All overall equilibria at a stage position [L] within the curve, in the sliding direction (Fig.
// 8B).
// Max error:  16 ulp in S, times the condition number of G(S) = stage.
std::vector<OverallEquilibrium> overall_equilibria(const SlidingCurve& curve, double stage);

// A part of a curve that a slow test follows, with an advancing stage.
struct StablePart {
  RigPoint from, to;
};

// The stable part that begins at a point of the curve; empty, to = from, if the curve is unstable
// there.
StablePart stable_part_from(const SlidingCurve& curve, const RigPoint& point);

// The first later point with this stage position that is stable: the end of a snap. Empty if the
// curve ends earlier.
std::optional<RigPoint> landing_after(const SlidingCurve& curve, double S, double stage);

// All stable parts of a curve: for loading, the running maximum of G. The specimen snaps between
// parts: `to` of one and `from` of the next have equal G.
std::vector<StablePart> stable_parts(const SlidingCurve& curve);

// The point of `part` at a stage position that it contains.
RigPoint point_at_stage(const SlidingCurve& curve, const StablePart& part, double stage);

// The end of an interval from S towards S_to in which friction and elastica are smooth: polynomials
// of low degree in the sliding coordinate suffice. It has at most `scales` smooth scales of
// friction (friction.h) and no knot inside.
double end_of_stretch(const Friction& friction, const Fibre& fibre, double S, double S_to, double scales);

// The sliding length of a loading, up to which its curve has to be traced.

// An upper bound of the length in a loading to a stage position. It is close to the final length,
// unless the specimen slips through before.
// Domain:     rig.stiffness > 0, stage >= 1e-6; std::invalid_argument otherwise.
// Method:     a loading ends before any length at which G reaches the stage position, or beyond the
//             branch. Bisection in the sliding coordinate finds one below longest_at_stage().
// Cost:       3 µs.
double longest_in_loading(const Friction& along, const Rig& rig, double stage);

}  // namespace flexslip
