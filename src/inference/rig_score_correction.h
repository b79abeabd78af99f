// What readings tell of a rig that its columns do not say.
#pragma once

#include "inference/process_mode.h"

namespace flexslip {

// The slope of ln p(readings, gaps) in the coefficients of the bending stiffness and of the rig, less what the columns say of it, for FrictionProcess::with_pull.
//
// A rig that is off moves the size of roughness and its places, too. Columns are those of a smooth curve, since nobody knows that size beforehand; what
// they leave out would tell nothing if readings were taken anywhere, but a fibre rests where friction is high and jumps over where it is low, the
// farther the softer the rig. So the log_posterior itself is asked, at two bending stiffnesses beside that of the mode, the rig held as the mode has it and
// all hyperparameters moved along; of other errors by how much the friction that they add looks like that of the bending stiffness.
//
// Domain:     a mode that is settled; zero for one without roughness, and where the bending stiffness is exact.
// Accuracy:   that of a difference of two merits that are not settled to the last digit; so much at most as moves ln EI by three of its errors.
// Cost:       two polishes, a twentieth of a fit.
Coefficients rig_score_correction(const FrictionProcess& process, const Mode& mode);

}  // namespace flexslip
