// How far a loading can draw the fibre in: the length up to which its curve has to be traced.
#pragma once

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

// A length that a loading to a stage position does not exceed; it is close to the one that it gets to, unless the fibre slips
// through the supports before.
// Domain:     rig.stiffness > 0, stage >= 1e-6; std::invalid_argument otherwise.
// Method:     the loading stops before any length at which G reaches the stage position, or at which the branch has ended;
//             such a length is found by bisection below longest_at_stage(), in √(S - 1) (Fibre::way).
// Cost:       3 µs.
double longest_in_loading(const Friction& along, const Rig& rig, double stage);

}  // namespace flexslip
