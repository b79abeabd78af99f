// What a fitted test comes to: one verdict, the same rows for every test, what stands against it, and one next step.
#pragma once

#include <string>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Of a test of any status.
Answer answer_of(const FittedTest& test);

// "0.47 ± 0.06", or "at most 0.28".
std::string mean_friction(const FrictionFit& fit);

// The largest drop [N, or reduced if the test is]; 0 without drops.
double largest_drop(const TestAnalysis& analysis);

}  // namespace flexslip
