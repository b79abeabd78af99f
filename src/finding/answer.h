// The answer of a fitted test: one verdict, rows in the same order for every test, findings, and
// one next step.
#pragma once

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Domain:     a test of any status.
Answer answer_of(const FittedTest& test);

}  // namespace flexslip
