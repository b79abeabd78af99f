// How large the drops are, and what is told of those of a specimen that is bent too little to tell its friction.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// Has it drops, and is it told what they are by what a slip can do, as no friction can be told?
bool tells_slips_of_a_bar(const FittedTest& test);

// "the largest 850 mN", and how many are small beside it, where that is most: "the largest 850 mN, 8 of them below a tenth of that".
// Domain:     a test with drops.
std::string sizes_in_words(const FittedTest& test);

// So slender that a span or a unit is wrong, where it is bent too little.
bool is_slender(const FittedTest& test);

// Of a test without a fit that has a drop deeper than any slip (inference/slip_limit.h).
std::optional<Finding> gave_way(const FittedTest& test);

// Of a test that is bent too little to tell friction: its force sinks by a tenth or more, and not in drops.
std::optional<Finding> sinks(const FittedTest& test);

// "at 3.1 mm a slip can make at most 80 mN; 1 of 2 drops is deeper"
// Domain:     a test that tells_slips_of_a_bar.
std::string slips_of_a_bar_in_words(const FittedTest& test);

// Of a specimen that is bent too little.
inline constexpr std::string_view no_friction_of_a_bar = "friction cannot be told at so small a deflection";

// By what a slip can do; shallow says why there is no friction, gave_way is null where no drop is too deep.
Verdict verdict_without_friction(const FittedTest& test, const Finding& shallow, const Finding* gave_way);

}  // namespace flexslip
