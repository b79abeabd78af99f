// Stick or slide between the drops, drawn.
#pragma once

#include "case/fitted.h"
#include "report/figure.h"

namespace flexslip {

// The position of every tooth between sliding and sticking, along the specimen.
// Domain: analysis.status is ok, analysis.teeth is given and has teeth.
Figure teeth_figure(const FittedTest& test);

}  // namespace flexslip
