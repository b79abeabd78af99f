// What the drops of a record tell of its load train, and of which column was taken for what.
#pragma once

#include <optional>
#include <string>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Is it bent far enough to tell friction: is there a fit, or none that explains the record?
bool is_bent_enough(const FittedTest& test);

// The stiffness stated, "90.65 N/m" or "∞".
std::string load_train_in_words(const FittedTest& test);

// A stage moves evenly from row to row, a deflection leaps in each drop. Nothing below three drops.
std::optional<Finding> deflection_for_stage(const FittedTest& test);

// While the force falls, the specimen bends as on another load train.
// Domain:     a test that is_bent_enough.
std::optional<Finding> other_train_in_drops(const FittedTest& test);

}  // namespace flexslip
