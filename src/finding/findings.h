// The findings of a fitted test: reasons against its answer, conditions, and notes, each made by
// one rule of a table.
#pragma once

#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// The findings in the order of the rules. Of rules that exclude each other, the first that applies
// makes its finding.
// Domain:     a test of any status.
std::vector<Finding> findings_of(const FittedTest& test);

// The codes of all rules, in their order.
std::vector<std::string_view> finding_codes();

}  // namespace flexslip
