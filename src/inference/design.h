// What a test will show, before it is run: will the force drop, where first, how often and by how much; how stiff the load
// train would have to be for it not to; and how much of the work would be friction.
#pragma once

#include <cstddef>
#include <optional>

#include "bending_test/critical_stiffness.h"
#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

// One loading of a fibre on a rig, from the straight fibre at stage position 0.
struct Design {
  Friction friction;
  Rig rig;
  double travel;  // [L] stage position at which the loading ends
  double step;    // [L] of the stage between two readings; 0: the curve is recorded continuously
};

enum class DesignStatus {
  ok,
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
  double end;         // [L] stage position that the loading gets to
  std::size_t snaps;  // those of the fibre, however small
  std::optional<FirstSnap> first_snap;
  std::size_t drops;      // falls of the force between readings, a run of them counting once: what the record shows
  double largest_drop;    // [EI/L^2] 0 without drops
  double mean_drop;       // [EI/L^2] 0 without drops
  double greatest_force;  // [EI/L^2]
  double work;            // [EI/L] ∫ F dw, what is measured as work on the specimen
  double friction;        // [EI/L] of it, heat at the supports; what the snaps set free is not in it
  double
      released;  // [EI/L] what the snaps set free beyond friction; work = friction + released + bending energy at the end
};

// Domain:     travel at least 1e-6, step >= 0 and finite, rig.stiffness > 0; std::invalid_argument otherwise.
// Max error:  of the stage positions and forces of snaps as stable_parts (rig.h); of work 1e-7, of friction and released 1e-5 of the work
//             (typically 1e-7); of drops 1e-6 of the greatest force. Falls below 1e-11 of the force are none.
// Fails:      slipped_through.
// Method:     the curve is traced; its stable parts are followed as polynomials, whose turning points tell which readings to look at.
//             In a snap the force at the supports is a smooth function of the length, whatever the friction (theory.md, "Designs").
// Cost:       the trace, and 6 µs for each period or snap, however many readings.
DesignOutcome outcome_of(const Design& design);

}  // namespace flexslip
