// The figures of a fitted test, in journal column widths.
#pragma once

#include "case/fitted.h"
#include "report/plot.h"

namespace flexslip {

// For all: Domain: analysis.status is ok, unless they say otherwise.

// Force against deflection with the mean of the fit run forward, references and drops, as Fig. 10 of the paper; residuals below.
Plot force_figure(const FittedTest& test);

// Friction along the specimen, with its 95 % intervals, at the bending stiffness of the fit, and what the fit knows of it.
Plot profile_figure(const FittedTest& test);

// What a wave of each wavelength adds to the evidence. Domain: the fit has a scan.
Plot wavelength_figure(const FittedTest& test);
// Is there a scan, and a wave that is claimed or among the explanations listed?
bool has_waves(const FittedTest& test);

// The position of every tooth between sliding and sticking, along the specimen. Domain: analysis.teeth is given.
Plot teeth_figure(const FittedTest& test);
// Is there a rise of which a verdict is known?
bool has_judged_teeth(const FittedTest& test);

// A record of which there is no fit, to look at: force against deflection, with what the bending stiffness stated would give with small
// deflections and without friction. Domain: analysis.status is not_explained.
Plot record_figure(const FittedTest& test);

}  // namespace flexslip
