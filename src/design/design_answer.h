// Will this test show a sawtooth, and what would have to change for it to be otherwise?
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "bending_test/design.h"
#include "design/design_result.h"
#include "design/reload_study.h"

namespace flexslip {

// A value of one parameter, the others as they are, with which the specimen snaps if it does not, or does not if it does.
struct DesignChange {
  std::string_view parameter;
  double from, to;        // [units of the case]
  double printed;         // [units of the case] `to` rounded away from `from`, to as few digits as leave it so
  bool and_beyond;        // it stays so however far beyond `to`
  DesignOutcome outcome;  // with `to`
};

// What the phase of the friction decides, which is seldom known before a test: with phases evenly spaced over a turn, all else as it is.
struct PhaseStudy {
  std::size_t phases;    // of which a test can be computed
  std::size_t snapping;  // of them, those with which the specimen snaps
  double min_drop;       // [EI/L^2] of the largest drops, one for each phase
  double largest_drop;   // [EI/L^2]
  double critical;       // [EI/L^3] on no stiffer load train does the specimen snap, with any of these phases
};

struct DesignAnswer {
  Test input;  // as one loading
  Design design;
  Scales scales;
  std::optional<SurfaceStrain> surface;  // none without a section
  bool wraps_nose;                       // it is bent more sharply than the nose
  DesignOutcome outcome;
  double critical;  // [EI/L^3] of this loading to this travel, critical_stiffness (design.h)
  std::vector<DesignChange> changes;
  std::optional<PhaseStudy>
      phases;  // none if the case has no phase, or two supports that are not alike, or no waves for it to shift, or waves below 1e-5 spans, of
               // which it moves nothing that can be seen
  std::optional<ReloadStudy> reload{};  // where it is asked for: reload_study(input, ...)
};

// Fails:      InputError as design_of.
// Method:     a specimen that snaps needs the critical stiffness, or the nearest softer rig with which it does not; one that does not
//             snap, on a rig stiffer than the critical one, one a hair softer (1e-4), on others the nearest on either side. From the
//             stiffness modulus and section follow in closed form, unless it is infinite, or the depth decides elsewhere, too. The travel is
//             that of the first snap, up to 30 times as far, or until the specimen is bent by more than a span. What is nearest is sought in steps of
//             10 %, up to 30 times as much or as little, and its
//             neighbourhood halved to 1e-4: a window narrower than a step may be missed. From 0, where there are no such steps, they
//             begin at 1/900 of the greatest value; from infinity none are made.
// Cost:       some 40 outcomes, and 700 traces to the first snap.
DesignAnswer answer_of(const Test& loading);

// The record as it will be, and the folds up to the travel, close enough to be drawn as lines.
std::vector<RecordedForce> record_of(const DesignAnswer& answer);
std::vector<FoldPoint> folds_of(const DesignAnswer& answer);

}  // namespace flexslip
