// What the checks of a fit came to, in words.
#pragma once

#include <string>

#include "case/fitted.h"

namespace flexslip {

struct CheckInWords {
  std::string outcome;  // "ok", "warning", "not possible"
  std::string words;    // what was found, a clause
  std::string detail;   // by which numbers, a sentence; may be empty
  std::string remedy;   // what to do about a warning; empty otherwise
};
CheckInWords check_in_words(const FittedTest& test, const Check& check);

}  // namespace flexslip
