// What is found out about a fitted test, by one table of rules: what stands against its answer, what it is told under, what is worth knowing.
#pragma once

#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Of a test of any status, in the order of the rules; of rules that exclude each other the first that applies.
std::vector<Finding> findings_of(const FittedTest& test);

// The codes that there are, in the order of the rules.
std::vector<std::string_view> finding_codes();

}  // namespace flexslip
