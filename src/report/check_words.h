// What the checks of a fit came to, in words.
#pragma once

#include <string>
#include <vector>

#include "case/fitted.h"

namespace flexslip {

struct CheckInWords {
  std::string outcome;  // "ok", "warning", "not possible"
  std::string words;    // what was found, a clause
  std::string detail;   // by which numbers, a sentence; may be empty
  std::string remedy;   // what to do about a warning; empty otherwise
};

// Domain of all below: analysis.status is ok.
CheckInWords check_in_words(const FittedTest& test, const Check& check);

// Slip or crack first, where there are drops.
std::vector<CheckInWords> checks_in_words(const FittedTest& test);

// "D* = 74.2; 31 of 34 rises grow stiffer": what the rises between the drops say.
std::string rises_in_words(const SlipOrCrack& rises);

}  // namespace flexslip
