// A test on rollers that roll loose on a flat base: one curve, there and back, on which friction does no work.
#pragma once

#include <optional>

#include "fibre/loose_rollers.h"

namespace flexslip {

// The state that a stage position leads to, in series with a load train.
// Domain:     stage >= 0 [L]; stiffness > 0 [EI/L^3], infinite for displacement control; std::invalid_argument otherwise.
// Max error:  1e-12 of the stage position.
// Fails:      none where no state is found that far: the specimen falls through, or is bent by more than deepest_on_supports.
std::optional<LooseState> state_at_stage(double stage, double stiffness, const Supports& supports);

}  // namespace flexslip
