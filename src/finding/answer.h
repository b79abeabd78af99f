// What a fitted test comes to: one verdict, the same rows for every test, what stands against it, and one next step.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// What is found out, by one table of rules in the order of their weight: of a test of any status, the weightiest first.
std::vector<Finding> findings_of(const FittedTest& test);

// By the weightiest of them.
Standing standing_of(const std::vector<Finding>& findings);

// The codes that there are, in the order of their weight.
std::vector<std::string_view> finding_codes();

// The greatest deflection [L] that a specimen reaches over its supports.
inline constexpr double max_deflection = 0.8;

// Of a test of any status.
Answer answer_of(const FittedTest& test);

// "0.47 ± 0.06", or "at most 0.28".
std::string mean_friction(const FrictionFit& fit);

}  // namespace flexslip
