// The problem of a fit: the record of one loading, its rig, and the errors of both. Reduced
// variables of the nominal bending stiffness.
#pragma once

#include <optional>
#include <utility>

#include "bending_test/motion.h"
#include "bending_test/rig.h"
#include "contact/nose.h"
#include "data/record.h"
#include "inference/profile.h"

namespace flexslip {

// [L] The sagitta of a specimen that is called straight. Its effect is that of a preload.
inline constexpr double usual_bow = 0.003;

// Prior standard deviations of the errors of a rig, relative to its values. The defaults are those
// of a careful laboratory (theory.md, "Sensitivity to the rig").
struct RigErrors {
  double load_train = 0.02, span = 0.005;
  double force_gain = 0.01;
  double thickness = 0.01, support_radius = 0.01;
  double preload = 0.005;      // [L] deflection before displacement and force were set to zero, or a bow
  double slow_force = 0.0065;  // [maximum force] of relaxation and drift of the load cell
};

struct FitProblem {
  ReducedRecord record;  // one loading up to failure; stage increasing
  Rig rig;
  MeasurementErrors errors;  // bending_stiffness is its prior standard deviation; 0 if it is exact
  RigErrors rig_errors{};
  Nose nose = Nose::holds;          // under a free nose, lengths along the specimen are doubled
  std::optional<SnapRest> snaps{};  // default: as the record shows

  // The same rig with another record of its test.
  FitProblem with(ReducedRecord other) const { return {std::move(other), rig, errors, rig_errors, nose, snaps}; }
};

inline constexpr double max_stiffness_error = 0.3;  // [1] of EI; larger errors are refused

}  // namespace flexslip
