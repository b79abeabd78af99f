// The folds of a sliding curve, found with a guarantee: the work behind trace_loading_curve and trace_unloading_curve (rig.h).
#pragma once

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

// Domain:     as trace_loading_curve and trace_unloading_curve, whose arguments these are; std::invalid_argument if there is no state at S_from.
// Tolerance, cost: as there.
SlidingCurve find_folds(const Friction& friction, const Rig& rig, Sliding sliding, double S_from, double S_to);

}  // namespace flexslip
