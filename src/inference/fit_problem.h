// What a fit of friction is asked: the record of one loading, its rig, and how far both may be off. Reduced variables of the nominal bending
// stiffness.
#pragma once

#include <optional>
#include <utility>

#include "bending_test/motion.h"
#include "bending_test/rig.h"
#include "contact/nose.h"
#include "data/record.h"
#include "inference/profile.h"

namespace flexslip {

// [L] Sagitta of a specimen that is called straight. It reads as a preload: the specimen lies as one bent so far, and bears nothing.
inline constexpr double usual_bow = 0.003;

// By how much a rig is off what is stated of it, beforehand: standard deviations, each relative to its value. What a careful laboratory is off
// by, unless the case states better (theory.md, "Sensitivity to the rig").
struct RigErrors {
  double load_train = 0.02, span = 0.005;
  double force_gain = 0.01;
  double thickness = 0.01, support_radius = 0.01;
  double preload =
      0.005;  // [L] of deflection that was there before displacement and force were set to zero, or of a bow
  double slow_force = 0.0065;  // of the greatest force: bow, relaxation, drift of the cell
};

// Units: reduced, with the nominal bending stiffness.
struct FitProblem {
  ReducedRecord record;  // one loading, up to the failure; stage rising
  Rig rig;
  MeasurementErrors errors;  // bending_stiffness is the standard deviation of its prior: 0 if it is exact
  RigErrors rig_errors{};
  Nose nose = Nose::holds;          // under a free one lengths along the fibre are twice as long
  std::optional<SnapRest> snaps{};  // not given: as the record shows

  // The same rig with another record of its test.
  FitProblem with(ReducedRecord other) const { return {std::move(other), rig, errors, rig_errors, nose, snaps}; }
};

inline constexpr double max_stiffness_error = 0.3;  // of EI: beyond it the fit would be that of another specimen

}  // namespace flexslip
