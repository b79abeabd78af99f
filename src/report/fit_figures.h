// The figures of a fitted test, in journal column widths.
#pragma once

#include "case/fitted.h"
#include "report/figure.h"

namespace flexslip {

// For all: Domain: analysis.status is ok.

// Force against deflection with the mean of the fit run forward, references and drops, as Fig. 10 of the paper; residuals below.
Figure force_figure(const FittedTest& test);

// Friction along the specimen, with its 95 % intervals, at the bending stiffness of the fit, and what the fit knows of it.
Figure profile_figure(const FittedTest& test);

// What a wave of each wavelength adds to the evidence. Domain: the fit has a scan.
Figure wavelength_figure(const FittedTest& test);

}  // namespace flexslip
