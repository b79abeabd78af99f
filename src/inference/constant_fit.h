// Constant friction by least squares in the force at the measured deflections.
#pragma once

#include "inference/fit_problem.h"

namespace flexslip {

struct ConstantFit {
  double mu0;             // [1]
  double standard_error;  // [1] of the residuals, allowing for their correlation, and of the bending stiffness
};

// The bending stiffness is taken as nominal, and its error carried into the interval: given the freedom, a constant would bend
// it to suit the roughness.
// Domain:     as fit_friction.
// Method:     Gauss-Newton; autocovariance of the scores tapered (Newey & West) over a tenth of the record.
ConstantFit fit_constant(const FitProblem& problem);

}  // namespace flexslip
