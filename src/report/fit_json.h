// A fitted test as JSON: the form that scripts read.
#pragma once

#include "cases/fitted_test.h"
#include "io/json.h"

namespace flexslip {

// Units:      SI and radians, rows counted from 1 in the file; reduced variables for a reduced case.
// Fails:      never: where the analysis did not succeed, the keys that depend on it are null or empty, and "status" says why.
Json fit_json(const FittedTest& test);

}  // namespace flexslip
