// The supports that --roller-radius and --thickness state.
#pragma once

#include "fibre/supported_state.h"

namespace flexslip {

// The same, in spans, if they leave a span and beam theory holds between them.
// Fails:      InputError, naming the flag, where they do not: as a case is refused (problem.h).
const Supports& within_limits(const Supports& stated);

}  // namespace flexslip
