// All that a fitted test says, as its report and the terminal (fit --full) lay it out.
#pragma once

#include <string>
#include <vector>

#include "case/fitted.h"
#include "report/document.h"

namespace flexslip {

// In the order of a report, without the answer that stands above it; of a test of any status. The test must outlive its pictures.
std::vector<Chapter> document_of(const FittedTest& test);

// For a terminal, the answer first.
std::string fit_text(const FittedTest& test);

}  // namespace flexslip
