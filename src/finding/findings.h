// What is found out about a fitted test, by one table of rules: what stands against its answer, what it is told under, what is worth knowing.
#pragma once

#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Of a test of any status, the weightiest first: in the order of the rules.
std::vector<Finding> findings_of(const FittedTest& test);

// By the weightiest of them.
Standing standing_of(const std::vector<Finding>& findings);

// The codes that there are, in the order of their weight.
std::vector<std::string_view> finding_codes();

// That of a code; null where it was not found.
const Finding* finding_in(const std::vector<Finding>& findings, std::string_view code);

}  // namespace flexslip
