// The information about errors of the rig that the linearised model misses.
#pragma once

#include "inference/process_mode.h"

namespace flexslip {

// The gradient of ln p(readings, gaps) in the coefficients of the bending stiffness and the rig
// that the columns miss, for FrictionProcess::with_pull.
//
// An error of the rig also changes the size and the places of the roughness. The columns follow a
// smooth curve, because the size of the roughness is unknown. But the specimen stops where friction
// is high and skips where it is low, the farther the softer the rig, so the remainder is
// informative. It is the difference of the log_posterior at two bending stiffnesses, with the rig
// held and the hyperparameters optimised. Other errors count as far as their effect on friction
// resembles that of the bending stiffness.
//
// Domain:     a settled mode. Zero without roughness, and for an exact bending stiffness.
// Max error:  that of a difference of two approximately settled posteriors. Limited to a change of
//             ln EI by three of its errors.
// Cost:       two polishes, a twentieth of a fit.
Coefficients rig_score_correction(const FrictionProcess& process, const Mode& mode);

}  // namespace flexslip
