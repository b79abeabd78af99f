// The surface that would explain the friction of a fitted test, and a trace it is held against.
#pragma once

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// Domain: test.implied is given.
Fields<FittedTest> implied_fields();

}  // namespace flexslip
