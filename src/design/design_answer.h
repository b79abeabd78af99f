// The answer of `design`: whether a planned test will show a sawtooth, and which changes would
// reverse that.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "bending_test/design.h"
#include "design/design_result.h"
#include "design/open_study.h"
#include "design/planned_case.h"
#include "design/reload_study.h"

namespace flexslip {

// A change of one parameter that reverses whether the specimen snaps. All other parameters keep
// their values.
struct DesignChange {
  std::string_view parameter;
  double from, to;  // [units of the case]
  // [units of the case] `to` rounded away from `from`, to the fewest digits that still reverse it
  double printed;
  bool and_beyond;        // every value beyond `to` reverses it as well
  DesignOutcome outcome;  // with `to`
};

// The effect of the phase of friction, which is seldom known before a test. The phases are evenly
// spaced over one turn; all else is unchanged.
struct PhaseStudy {
  std::size_t phases;    // number of phases that can be computed
  std::size_t snapping;  // number of these with which the specimen snaps
  double min_drop;       // [EI/L^2] minimum over the phases of the largest drop
  double largest_drop;   // [EI/L^2] maximum over the phases
  double critical;       // [EI/L^3] smallest stiffness at and above which no phase leads to a snap
};

struct DesignAnswer {
  Test input;  // one loading
  Design design;
  Scales scales;
  std::optional<SurfaceStrain> surface;  // empty without a section
  bool wraps_nose;                       // the specimen is curved more sharply than the nose
  DesignOutcome outcome;
  double critical;  // [EI/L^3] critical_stiffness (design.h) of this loading
  std::vector<DesignChange> changes;
  // Empty if the case has no phase or no waves to shift, if its two supports differ, or if the waves
  // are below 1e-5 spans, where the phase has no visible effect.
  std::optional<PhaseStudy> phases;
  std::optional<ReloadStudy> reload{};  // empty unless requested: reload_study(input, ...)
  std::optional<OpenStudy> open{};      // empty unless requested (open_study), or if friction is not stated
};

// Fails:      throws InputError as design_of.
// Method:     If the specimen snaps, the stiffness changes to the critical one, or to the nearest
//             softer one without a snap. If it does not, a stiffness above the critical one changes
//             to 1e-4 below it; any other changes to the nearest one on either side. Changes of
//             modulus and section follow from the stiffness in closed form, unless it is infinite
//             or the depth has other effects. The travel changes to the first snap, at most
//             by a factor of 30 or up to a deflection of one span. Other parameters are searched in
//             steps of 10 %, up to a factor of 30, then bisected to 1e-4. A window narrower than a
//             step may be missed. A search from 0 starts at 1/900 of the largest value; from
//             infinity there is none.
// Cost:       about 40 outcomes, and 700 traces up to the first snap.
DesignAnswer answer_of(const Test& loading);

// The same for a case that leaves friction open: in the middle of its ranges, with the study of the ranges.
DesignAnswer answer_of(const PlannedCase& planned, unsigned threads);

// The expected record, and the folds up to the travel, dense enough to be drawn as lines.
std::vector<RecordedForce> record_of(const DesignAnswer& answer);
std::vector<FoldPoint> folds_of(const DesignAnswer& answer);

}  // namespace flexslip
