// The answer of a fit on one screen.
#pragma once

#include <string>

#include "case/fitted.h"

namespace flexslip {

// What is known and no more, in lines of at most 100 characters: the verdict first, then what was read off the curve before any model, the checks
// with what to do about those that failed, what was assumed, and where more is. About 30 lines; fit_text (fit_document.h) has the rest.
std::string fit_screen(const FittedTest& test);

// "426 rows, to a deflection of 766.1 µm, …". Domain: analysis.status is ok.
std::string record_in_words(const FittedTest& test);

}  // namespace flexslip
