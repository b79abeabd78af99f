// The fibre on a loading frame of finite stiffness: overall equilibria, their stability, the folds where it snaps,
// and how far a loading gets.
//
// Along a sliding curve, q = μ(S) drawn in or q = -μ(S) let out, the frame asks for the stage position G(S) = w + F/k. At a
// given stage position every root of G(S) = stage is an overall equilibrium; it is stable where G rises with S (4.31), and at
// a fold, G' = 0, the fibre snaps. (The paper writes k G.)
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
  double stiffness;  // [EI/L^3] of whatever carries the load cell; infinity for displacement control; > 0
  Fibre fibre = {};  // on its supports

  // The same in units of a bending stiffness that is so many times that of its own.
  Rig in_units_of(double times) const { return {stiffness / times, fibre}; }
};

// A point of a sliding curve with the stage position that holds it.
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
  bool is_maximum;  // of G: where a fibre drawn in snaps; a minimum is where one let out does
};

enum class CurveEnd {
  reached,       // the length asked for
  branch_ended,  // the force fell to zero: `end` is the last point with F >= 0
};

// A sliding curve from one length to another, on the way that the fibre slides, cut at its folds: between two of them G is
// strictly monotone. trace.h makes it.
struct SlidingCurve {
  Friction friction;  // as met on this way (contact/over_rollers.h)
  Rig rig;
  Sliding sliding;
  RigPoint begin;
  std::vector<Fold> folds;  // in the order of the way; maxima and minima in turn
  RigPoint end;
  CurveEnd end_reason;
  std::size_t looked_at;  // points that it took to find the folds
  std::vector<CurvePiece>
      pieces;  // of the curve, end to end from its begin: as far as it takes no more than 2^16 of them
};

// A length that the fibre exceeds only at stage positions beyond `stage`: what to trace to find all equilibria at `stage`.
// Domain:     stage >= 1e-6; std::invalid_argument otherwise. For q >= 0, as in loading.
// Method:     w <= stage, and S - 1 <= 2.4 w^2, which is the limit of small deflection (tested for q in [0, 20]).
double longest_at_stage(double stage);

// True if the curve leads over a length, to rounding.
bool is_on(const SlidingCurve& curve, double S);

// Domain: S on the curve, from curve.begin to curve.end; std::invalid_argument otherwise. So for all that follows.
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

// All overall equilibria at a stage position [L], in the order of the way, within the curve traced (Fig. 8B).
// Max error:  16 ulp in S, times the condition number of G(S) = stage.
std::vector<OverallEquilibrium> overall_equilibria(const SlidingCurve& curve, double stage);

// A part of a curve that a slowly moved test visits. On the way from one end to the other the stage only advances.
struct StablePart {
  RigPoint from, to;
};

// The stable part that begins at a point of the curve. It is empty, to = from, if the curve is not stable there.
StablePart stable_part_from(const SlidingCurve& curve, const RigPoint& point);

// The first point beyond a length at which the curve comes back to a stage position as a stable one: where a fibre that
// snaps there comes to rest. None if the curve ends before.
std::optional<RigPoint> landing_after(const SlidingCurve& curve, double S, double stage);

// All stable parts of a curve from its begin, in loading the running maximum of G. Between parts the fibre snaps: `to` of one
// and `from` of the next have equal G.
std::vector<StablePart> stable_parts(const SlidingCurve& curve);

// The state at a stage position that `part` contains.
RigPoint point_at_stage(const SlidingCurve& curve, const StablePart& part, double stage);

// The end of a stretch of the way from S towards S_to, over which friction and the elastica bend so little that polynomials in
// √(S - 1) (Fibre::way) of low degree follow them: at most `scales` smooth scales of the friction (friction.h), and no knot inside.
double end_of_stretch(const Friction& friction, const Fibre& fibre, double S, double S_to, double scales);

// How far a loading can draw the fibre in: the length up to which its curve has to be traced.

// A length that a loading to a stage position does not exceed; it is close to the one that it gets to, unless the fibre slips
// through the supports before.
// Domain:     rig.stiffness > 0, stage >= 1e-6; std::invalid_argument otherwise.
// Method:     the loading stops before any length at which G reaches the stage position, or at which the branch has ended;
//             such a length is found by bisection below longest_at_stage(), in √(S - 1) (Fibre::way).
// Cost:       3 µs.
double longest_in_loading(const Friction& along, const Rig& rig, double stage);

}  // namespace flexslip
