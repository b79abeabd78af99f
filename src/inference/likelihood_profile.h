// The likelihood of a fitted model along one of its parameters, all others fitted anew at each value: what tests that share a
// parameter are joined by.
#pragma once

#include <span>
#include <vector>

#include "inference/fit.h"

namespace flexslip {

enum class FitParameter {
  mu0,                // [1] in the middle of the data
  amplitude,          // [1] of the first wave, relative to mu0
  wavelength,         // [L] of the first wave
  phase,              // [rad] of the first wave, at S = 0
  bending_stiffness,  // [1] relative to the nominal one
};

// The log likelihood, up to a constant that is the same for all values of all parameters of this fit; -infinity at values that no
// fit is permitted at. Twice its fall from the maximum is compared with 3.84 for a 95 % interval. The prior of the bending
// stiffness, -(value - 1)²/(2 errors.bending_stiffness²), is part of it: tests that share one bending stiffness count it once.
// Domain:     a problem as fit_friction takes and a model that it found for it (fit.status other than not_found) with
//             a wave if the parameter is of one; std::invalid_argument otherwise.
// Method:     from the fit outwards, each value from its neighbour's solution and, for a single wave, from the profile at that
//             wavelength. Between values further apart than a standard error intermediate ones are taken.
// Cost:       3 ms, and 1 ms a value.
std::vector<double> likelihood_along(const FitProblem& problem, const ModelFit& fit, FitParameter parameter,
                                     std::span<const double> values);

}  // namespace flexslip
