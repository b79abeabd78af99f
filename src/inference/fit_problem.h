// What is fitted: a record, the rig it was taken on, and what limits its accuracy.
#pragma once

#include "bending_test/rig.h"
#include "data/record.h"
#include "inference/profile.h"

namespace flexslip {

// Units: reduced, with the nominal bending stiffness.
struct FitProblem {
  ReducedRecord record;  // one loading, up to the failure; stage rising
  Rig rig;
  MeasurementErrors errors;  // bending_stiffness is the standard deviation of its prior: 0 if it is exact
};

// Without deflections beyond 0.8.
// Domain:     a record without faults, stage not falling; rig.stiffness > 0; errors >= 0, that of EI at most 0.3;
//             std::invalid_argument otherwise.
FitProblem usable_part(const FitProblem& whole);

// Of a record of so many points, which are fitted: every so many, so that there are at most 1200.
std::size_t thinning_of(std::size_t points);
FitProblem thinned(const FitProblem& problem);

}  // namespace flexslip
