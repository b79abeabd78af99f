// Stick or slide between the drops, in words and as a table.
#pragma once

#include <string>

#include "case/fitted.h"
#include "finding/printed.h"

namespace flexslip {

// Domain of all: analysis.status is ok.

// What the teeth reject, at what confidence, and what they cannot tell apart: sticking from sliding against steeply rising
// friction, and sliding from supports that give way.
std::string teeth_in_words(const FittedTest& test);

// The teeth judged; no rows if there are none.
PrintedTable tooth_table(const FittedTest& test);

}  // namespace flexslip
