// What a load-unload-reload test says.
#pragma once

#include <string>

#include "case/fitted.h"
#include "report/document.h"

namespace flexslip {

// Domain: analysis.status is ok, test.cycles is given; the test must outlive it.
Chapter cycles_chapter(const FittedTest& test);

// What friction that builds up after a reversal leaves of the height of waves and roughness as fitted; "" where none is told.
std::string smoothing_in_words(const FittedTest& test);

}  // namespace flexslip
