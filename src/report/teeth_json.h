// Stick or slide between the drops, as JSON.
#pragma once

#include "cases/fitted_test.h"
#include "io/json.h"

namespace flexslip {

// "sliding", "as_if_stuck" or "undecided".
std::string name_of(ToothVerdict verdict);

// Units:      as fit_json; the compliance in m/N.
// Fails:      never: null where there are no teeth to judge.
Json teeth_json(const FittedTest& test);

}  // namespace flexslip
