// The figures of a fitted test, in journal column widths.
#pragma once

#include "cases/fitted_test.h"
#include "report/figure.h"

namespace flexslip {

// For all: Domain: analysis.status is ok.

// Force against deflection with model, references and drops, as Fig. 10 of the paper; residuals below.
Figure force_figure(const FittedTest& test);

// Friction along the specimen, with its 95 % intervals, at the bending stiffness of the fit: so the model can be compared.
Figure profile_figure(const FittedTest& test);

// How likely each wavelength is. Domain: waves were among the models.
Figure wavelength_figure(const FittedTest& test);

}  // namespace flexslip
