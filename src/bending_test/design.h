// Predictions for a planned test: whether the force drops, where first, how often and by how much;
// the load-train stiffness that prevents drops; and the friction share of the work.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bending_test/motion.h"
#include "bending_test/rig.h"
#include "contact/friction.h"
#include "fibre/fibre.h"
#include "numerics/elementary.h"

namespace flexslip {

// The load-train stiffness at which snaps begin.

// [EI/L^3] The smallest stiffness of the load train at and above which no loading up to the
// deflection w_max [L] snaps. 0 if there is no snap on any rig stiffer than 1e-6. Infinite if the
// test snaps even under displacement control.
// Domain:     w_max >= 1e-6, finite; std::invalid_argument otherwise.
// Tolerance:  1e-9, relative: a snap at a larger stiffness is too short for the tracer (trace.h).
// Fails:      as trace_loading_curve (trace.h).
// Method:     continuation of the fold. G' = w' + F'/k vanishes at k = -F'/w', so the folds of all
//             rigs lie on one curve k(S). A pair of folds vanishes in a cusp: a maximum of k(S), or
//             the end of the range. One pair from the trace on a soft rig is followed to its cusp.
//             Just above the cusp the curve is traced again, until a trace finds no fold. At a
//             maximum k(S) is flat, so second derivatives are not needed (theory.md, "The critical
//             stiffness").
// Cost:       about three traces, and 20 µs for each cusp; at worst a trace for every maximum of
//             k(S).
double critical_stiffness(const Friction& friction, double w_max, const Fibre& fibre = {});

// [EI/L^3] -F'/w' along q = μ(S): the stiffness of the rig that has a fold at this length. The
// friction is a function of the sliding length (contact/over_rollers.h).
// Domain:     S > 1, with a state.
double stiffness_of_fold(const Friction& friction, double S, const Fibre& fibre = {});

// The readings of a loading.

// The stage positions of readings: at every whole step, and at the end of the travel.
class ReadingPositions {
 public:
  // Domain:     travel > 0, step > 0, both finite.
  ReadingPositions(double travel, double step);

  double count() const { return last_ + 1; }  // includes reading 0, straight
  double position(double i) const { return i < last_ ? i * step_ : travel_; }
  // The index of the first reading beyond a stage position.
  double first_beyond(double stage) const;

 private:
  double travel_, step_, last_;
};

// Counts and measures the force drops in a series of readings. Successive falls are one drop.
// Readings within a monotone part may be omitted.
class ForceFalls {
 public:
  void read(double F);
  void end();  // completes a current fall

  std::size_t count() const { return count_; }
  double largest() const { return largest_; }  // [EI/L^2] 0 without drops
  // [EI/L^2] 0 without drops
  double mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0; }

 private:
  double last_ = 0;
  double top_ = 0;
  bool falling_ = false;
  std::size_t count_ = 0;
  double sum_ = 0;
  double largest_ = 0;
};

struct RecordedForce {
  double stage;  // [L]
  double F;      // [EI/L^2]
};

// The record of a loading from the straight specimen to a stage position. It has one reading per
// step; the whole curve if step is 0, or for more readings than a figure can resolve (20000). It
// ends if the specimen slips through.
// Domain:     travel >= 1e-6, step >= 0, both finite; std::invalid_argument otherwise.
std::vector<RecordedForce> record_of(const BendingTest& test, double travel, double step);

// A planned loading, from the straight specimen at stage position 0.
struct Design {
  Friction friction;
  Rig rig;
  double travel;  // [L] final stage position
  // [L] stage travel between readings; 0 for a continuous record
  double step;
  double breaking_curvature = infinity;  // [1/L] at midspan
};

enum class DesignStatus {
  ok,
  breaks,           // the specimen breaks during the loading; the results end there
  slipped_through,  // the specimen slips through the supports; the results end there
};

struct FirstSnap {
  double stage;     // [L]
  double w;         // [L] before the snap
  double F_before;  // [EI/L^2]
  double F_after;   // [EI/L^2]
};

struct DesignOutcome {
  DesignStatus status;
  double stage_reached;  // [L] final stage position
  double w_reached;      // [L] final deflection
  std::size_t snaps;     // all, however small
  std::optional<FirstSnap> first_snap;
  double largest_snap;        // [EI/L^2] largest force drop in a snap; 0 without a snap
  std::size_t drops;          // recorded drops: successive falls between readings count once
  double largest_drop;        // [EI/L^2] 0 without drops
  double mean_drop;           // [EI/L^2] 0 without drops
  double greatest_force;      // [EI/L^2]
  double greatest_curvature;  // [1/L] at midspan
  double work;                // [EI/L] ∫ F dw, the measured work
  // [EI/L] part of the work: heat at the supports while sliding and in snaps
  double friction_heat;
  // [EI/L] part of the work: released in snaps beyond friction; the rest is bending
  double released;
};

// [1] The part of the work lost to friction and snaps.
inline double friction_share(const DesignOutcome& outcome) {
  return (outcome.friction_heat + outcome.released) / outcome.work;
}

// The outcome of a planned loading.
// Domain:     travel/(1 + 48/stiffness), about the deflection, at least 1e-6; step 0 or at least
//             1e-9 of the travel, finite; rig.stiffness > 0; std::invalid_argument otherwise.
// Max error:  as stable_parts (rig.h) for stage positions and forces of snaps; 1e-7 for work and
//             greatest_force; 1e-5 of the work (typically 1e-7) for friction_heat and released;
//             1e-6 of greatest_force for drops. Falls below 1e-11 of the force are ignored. If a
//             drift reaches zero friction within a snap: 1e-3 of the work for friction_heat and
//             released, 1e-4 for drops. If the loading ends below a length S, all have an
//             additional 2^-48/(S - 1). The maximum curvature and the breaking point are searched
//             at four points per half of the shortest period: up to 2 % too small, and shorter
//             excesses are missed.
// Fails:      slipped_through, breaks.
// Method:     the stable parts of the traced curve are followed as polynomials. Their turning
//             points determine which readings matter. In a snap the support force is a smooth
//             function of the length for any friction (theory.md, "Designs").
// Cost:       the trace, and 6 µs for each period or snap, for any number of readings.
DesignOutcome outcome_of(const Design& design);

// True if the specimen snaps and comes to rest again: outcome_of(design).snaps > 0, unless it
// breaks exactly then.
// Domain:     as outcome_of.
// Cost:       the trace up to four times the distance to the first snap, or all of it.
bool snaps(const Design& design);

// [EI/L^3] The smallest load-train stiffness at and above which this loading, to its travel or to
// the break, has no fold. At a fold the specimen snaps or slips through. 0 if no load train causes
// a fold. The stiffness of the design has no effect.
// Domain:     as outcome_of.
// Tolerance:  1e-7, rounded up so that a rig of this stiffness has no snap, plus 1e-8.
// Fails:      infinity if the specimen snaps even under displacement control.
// Method:     on rigs of stiffness k and below, the loading reaches at most a deflection w(k), with
//             the critical stiffness K(w) of the function above. The iteration starts with k =
//             K(travel) and continues with k = K(w(k)) to convergence; no stiffer rig snaps. It
//             converges to a cusp, because along a rising k(S) the stage positions of folds
//             decrease by F k'/k^2.
// Cost:       a few times the cost of critical_stiffness above.
double critical_stiffness(const Design& design);

// ln(k/k_critical) up to the final deflection, limited to [-3, 3]: >= 0 without a snap, <= 0 with
// one, to 1e-8. If the specimen slips through, up to the travel.
double stiffness_margin(const Design& design, const DesignOutcome& outcome);

// A point of the curve and the stiffness of the rig that has a fold there.
struct FoldPoint {
  double w;          // [L]
  double F;          // [EI/L^2]
  double stiffness;  // [EI/L^3]
};

// Points along the curve up to a deflection, dense enough to be connected by lines.
// Domain:     w_max >= 1e-6, finite.
std::vector<FoldPoint> folds_up_to(const Friction& along, double w_max, const Fibre& fibre = {});

}  // namespace flexslip
