// From a fit as it is reported back to the point that the searches work with.
#pragma once

#include "inference/descent.h"
#include "inference/fit.h"
#include "inference/force_model.h"

namespace flexslip {

// The model of the part of a problem that is fitted.
// Domain:     as fit_friction; at least two points with a deflection above friction_shows_from.
ForceModel model_of(const FitProblem& whole);

// The noise is that of the reported fit.
FitPoint fitted_point(const ForceModel& model, const ModelFit& fit);

}  // namespace flexslip
