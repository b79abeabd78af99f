// What a test will show, before it is run: will the force drop, where first, how often and by how much; how stiff the load
// train would have to be for it not to; and how much of the work would be friction.
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

// How stiff a load train must be for the fibre not to snap.

// The least stiffness of the load train [EI/L^3] with which no loading up to the deflection w_max [L] snaps: 0 where none snaps
// on any rig stiffer than 1e-6, infinite where one does even with the deflection itself controlled.
// Domain:     w_max >= 1e-6, finite; std::invalid_argument otherwise.
// Tolerance:  1e-9, relative: a snap at a stiffness above that would be shorter than the tracer tells (trace.h).
// Fails:      as trace_loading_curve (trace.h).
// Method:     continuation of the fold. G' = w' + F'/k vanishes where k = -F'/w', so that the folds of all rigs lie on one
//             curve k(S), and a pair of them vanishes in a cusp, at a maximum of k(S) or at the end of the range. From the pairs
//             that the tracer finds on a soft rig one is followed up to its cusp; just above it the curve is traced anew; and so on
//             until the tracer, which misses none, finds no fold. A maximum of k(S) is flat and needs no second derivatives
//             (theory.md, "The critical stiffness").
// Cost:       about three traces, and 20 µs for each cusp; at worst a trace for every maximum of k(S).
double critical_stiffness(const Friction& friction, double w_max, const Fibre& fibre = {});

// -F'/w' along q = μ(S) [EI/L^3]: on the rig of that stiffness the fibre is at a fold at this length.
// Domain:     S > 1, where a state exists.
// The friction is that met on the way (contact/over_rollers.h).
double stiffness_of_fold(const Friction& friction, double S, const Fibre& fibre = {});

// The readings of a loading: where they stand, and what a record of them shows.

// Which reading stands where: at every whole step of the stage, and at the end of its travel.
class ReadingPositions {
 public:
  // Domain:     travel > 0, step > 0, both finite.
  ReadingPositions(double travel, double step);

  double count() const { return last_ + 1; }  // with reading 0, of the straight fibre
  double position(double i) const { return i < last_ ? i * step_ : travel_; }
  // The first reading beyond a stage position; the one before it is the last that is not.
  double first_beyond(double stage) const;

 private:
  double travel_, step_, last_;
};

// Counts the falls of a force, a run of them being one, from its values in the order in which they are read: all of them, or those
// between which it rises or falls.
class ForceFalls {
 public:
  void read(double F);
  void end();  // a fall under way is one

  std::size_t count() const { return count_; }
  double largest() const { return largest_; }                                          // [EI/L^2] 0 without drops
  double mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0; }  // likewise

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

// What is recorded in a loading up to a stage position, from the straight fibre on: a reading each step, all of the curve if it is 0
// or if there are more readings than a figure can tell apart, 20000. It ends where the fibre slips through.
// Domain:     travel at least 1e-6, step >= 0, both finite; std::invalid_argument otherwise.
std::vector<RecordedForce> record_of(const BendingTest& test, double travel, double step);

// One loading of a fibre on a rig, from the straight fibre at stage position 0.
struct Design {
  Friction friction;
  Rig rig;
  double travel;                         // [L] stage position at which the loading ends
  double step;                           // [L] of the stage between two readings; 0: the curve is recorded continuously
  double breaking_curvature = infinity;  // [1/L] at midspan, at which the fibre breaks
};

enum class DesignStatus {
  ok,
  breaks,  // the fibre breaks before the stage has travelled so far: the answers are those up to there
  slipped_through,  // the fibre slips through the supports before the stage has travelled so far: the answers are those up to there
};

struct FirstSnap {
  double stage;     // [L]
  double w;         // [L] before it
  double F_before;  // [EI/L^2]
  double F_after;   // [EI/L^2]
};

struct DesignOutcome {
  DesignStatus status;
  double stage_reached;  // [L] stage position that the loading gets to
  double w_reached;      // [L] deflection there
  std::size_t snaps;     // those of the fibre, however small
  std::optional<FirstSnap> first_snap;
  double largest_snap;        // [EI/L^2] the greatest fall of the force in a snap; 0 without one
  std::size_t drops;          // falls of the force between readings, a run of them counting once: what the record shows
  double largest_drop;        // [EI/L^2] 0 without drops
  double mean_drop;           // [EI/L^2] 0 without drops
  double greatest_force;      // [EI/L^2]
  double greatest_curvature;  // [1/L] at midspan
  double work;                // [EI/L] ∫ F dw, what is measured as work on the specimen
  double friction_heat;       // [EI/L] of it, heat at the supports while the fibre slides and snaps
  double released;            // [EI/L] of it, what the snaps set free beyond friction; the rest bends the fibre
};

// [1] Of the work, what went into friction and snaps.
inline double friction_share(const DesignOutcome& outcome) {
  return (outcome.friction_heat + outcome.released) / outcome.work;
}

// Domain:     travel/(1 + 48/stiffness), about the deflection, at least 1e-6; step 0 or at least 1e-9 of the travel, finite;
//             rig.stiffness > 0; std::invalid_argument otherwise.
// Max error:  of the stage positions and forces of snaps as stable_parts (rig.h); of work and the greatest force 1e-7; of friction_heat
//             and released 1e-5 of the work (typically 1e-7); of drops 1e-6 of the greatest force. Falls below 1e-11 of the force are
//             none. Where a drift of friction begins or ends to be held at zero within a snap, friction_heat and released 1e-3 of the
//             work and drops 1e-4; where the loading ends below a length S, all of them 2^-48/(S - 1) besides.
//             The greatest curvature, and that at which the fibre breaks, is looked for at four points of each half of the shortest
//             period, and may be 2 % too small; one exceeded for less than that is not seen.
// Fails:      slipped_through, breaks.
// Method:     the curve is traced; its stable parts are followed as polynomials, whose turning points tell which readings to look at.
//             In a snap the force at the supports is a smooth function of the length, whatever the friction (theory.md, "Designs").
// Cost:       the trace, and 6 µs for each period or snap, however many readings.
DesignOutcome outcome_of(const Design& design);

// Does the fibre snap at all, and come to rest again: outcome_of(design).snaps > 0, but for one that breaks just there.
// Domain:     as outcome_of.
// Cost:       the trace up to four times as far as the first snap, or of all of it.
bool snaps(const Design& design);

// The smallest stiffness of the load train [EI/L^3] from which on this loading, to its travel or until the fibre breaks, meets no fold: at a
// fold the fibre snaps or, if there is no rest beyond it, slips through. 0 where it meets none on any load train. The stiffness of the design
// itself does not count.
// Domain:     as outcome_of.
// Tolerance:  rounded up, by 1e-7, so that on a rig of just this stiffness there is no snap; 1e-8 beside it.
// Fails:      infinity where the fibre snaps even with the deflection controlled.
// Method:     on a rig of stiffness k and on all softer ones the loading gets no farther than to a deflection w(k), and up to that the
//             critical stiffness K(w) is known (the other critical_stiffness): so k = K(travel) at first, and then k = K(w(k)) until it stays.
//             No stiffer rig snaps at any moment of this. It stays at a cusp, because along a rising k(S) the stage positions of folds
//             fall, by F k'/k^2.
// Cost:       a few times that of critical_stiffness.
double critical_stiffness(const Design& design);

// How far a rig is from where the fibre begins to snap: ln k/k_critical up to the deflection that the loading got to, within [-3, 3].
// 0 or more where it did not snap, at most 0 where it did: to 1e-8, as critical_stiffness. Of what slips through, up to the travel.
double stiffness_margin(const Design& design, const DesignOutcome& outcome);

// A point of the curve with the stiffness of the rig on which it is a fold.
struct FoldPoint {
  double w;          // [L]
  double F;          // [EI/L^2]
  double stiffness;  // [EI/L^3]
};

// Points along the curve up to a deflection, close enough to be drawn as lines.
// Domain:     w_max >= 1e-6, finite.
std::vector<FoldPoint> folds_up_to(const Friction& along, double w_max, const Fibre& fibre = {});

}  // namespace flexslip
