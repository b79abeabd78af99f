// Can a record be sliding with friction at all?
#pragma once

#include <cmath>

#include "bending_test/rig.h"
#include "data/record.h"
#include "data/scales.h"

namespace flexslip {

// Do four fifths of the points past the deflection judged_from have a friction of least_friction or more (profile.h), at the bending stiffness of
// the scales or one that differs from it by twice its error?
// Domain:     bending_stiffness_error >= 0 [1]; the stiffness of the rig is in units of the scales.
bool may_slide(const Record& record, const Scales& scales, const Rig& rig, double bending_stiffness_error);

// The force over that without friction at the same deflection, past the deflection judged_from.
struct OverFrictionless {
  double median = NAN, least = NAN;  // [1] NaN without such points
};

// Max error:  1e-4.
OverFrictionless over_frictionless(const ReducedRecord& record, const Fibre& fibre);

}  // namespace flexslip
