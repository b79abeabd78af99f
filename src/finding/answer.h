// What a fitted test comes to: one verdict, the same rows for every test, what stands against it, and one next step.
#pragma once

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Of a test of any status.
Answer answer_of(const FittedTest& test);

}  // namespace flexslip
