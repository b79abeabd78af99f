// The surface that would explain the friction of a fitted test, in sentences.
#pragma once

#include <string>
#include <vector>

#include "case/fitted.h"

namespace flexslip {

// Each complete in itself; none where friction does not vary, or its contacts roll back.
std::vector<std::string> implied_in_words(const FittedTest& test);

}  // namespace flexslip
