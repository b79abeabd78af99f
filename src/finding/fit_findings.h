// What is found out about a fitted test, by one table of rules in the order of their weight.
#pragma once

#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Of a test of any status, the weightiest first.
std::vector<Finding> findings_of(const FittedTest& test);

// By the weightiest of them.
Standing standing_of(const std::vector<Finding>& findings);

// The codes that there are, in the order of their weight.
std::vector<std::string_view> finding_codes();

// The greatest deflection [L] that a specimen reaches over its supports.
inline constexpr double farthest_deflection = 0.8;

}  // namespace flexslip
