// What the checks of a fit came to, in words.
#pragma once

#include <string>

#include "case/fitted.h"

namespace flexslip {

// What was found, in a sentence that begins in lower case.
std::string finding_in_words(const FittedTest& test, const Check& check);

// The same behind "Passed", "Failed" or "Not possible".
std::string check_in_words(const FittedTest& test, const Check& check);

// In a clause, and what to do where it failed; "" otherwise.
struct CheckInShort {
  std::string outcome;  // "ok", "warning", "not possible"
  std::string words, remedy;
};
CheckInShort check_in_short(const FittedTest& test, const Check& check);

}  // namespace flexslip
