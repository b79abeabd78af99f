// A record of which there is no fit, to look at.
#pragma once

#include "case/fitted.h"
#include "report/figure.h"

namespace flexslip {

// Force against deflection, with what the bending stiffness stated would give with small deflections and without friction.
// Domain:     analysis.status is not_explained.
Figure record_figure(const FittedTest& test);

}  // namespace flexslip
