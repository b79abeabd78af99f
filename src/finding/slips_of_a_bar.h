// How large the drops are, and what is told of those of a specimen that is bent too little to tell its friction.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// "the largest 850 mN", and how many are small beside it, where that is most: "the largest 850 mN, 8 of them below a tenth of that".
// Domain:     a test with drops.
std::string sizes_in_words(const FittedTest& test);

// So slender that a span or a unit is wrong, where it is bent too little.
bool is_slender(const FittedTest& test);

// Domain of the next four: a bar with drops (TestAnalysis::slips_of_bar).

// [N] The most that a slip can make at the drop that is least like one.
double most_by_slip(const FittedTest& test);

// "at 3.1 mm a slip can make at most 80 mN"
std::string most_by_slip_in_words(const FittedTest& test);

// "1 of 10 drops is deeper"
std::string deeper_drops(const FittedTest& test);

// "at 3.1 mm a slip can make at most 80 mN; 1 of 2 drops is deeper"
std::string slips_of_a_bar_in_words(const FittedTest& test);

// Of a specimen that is bent too little.
inline constexpr std::string_view no_friction_of_a_bar = "friction cannot be told at so small a deflection";

// By what a slip can do.
// Domain:     a bar; its findings, of which the first says why there is no friction.
Verdict verdict_of_a_bar(const FittedTest& test, const std::vector<Finding>& findings);

}  // namespace flexslip
