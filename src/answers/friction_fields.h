// The friction of a fitted test, described once: its parameters, its waves, its explanations, and what the fit is held against.
#pragma once

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// Those of the model that the fit is of, and the contact; without a fit that alone.
Fields<FittedTest> parameter_fields();

// The likeliest wave, claimed or not. Domain: the fit has one.
Fields<FittedTest> likeliest_wave_fields();

Fields<Explanation> explanation_fields();

// Friction at each of many lengths.
Fields<FittedTest> band_fields();

Fields<Check> check_fields();

}  // namespace flexslip
