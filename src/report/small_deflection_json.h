// The numbers of the bending standards, as JSON.
#pragma once

#include "io/json.h"
#include "report/small_deflection_words.h"

namespace flexslip {

// Units:      SI, rows counted from 1 in the file; reduced variables for a reduced test.
// Fails:      never: null where a number is not known, and "status" says whether there is a straight part.
Json small_deflection_json(const StandardTest& test);

// The same, with its ratio to the bending stiffness of the fit.
Json small_deflection_json(const FittedTest& test);

}  // namespace flexslip
