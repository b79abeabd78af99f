// Every number of `fit --json`, described once.
#pragma once

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// The units of the test, and the rows of its file. The test must outlive it.
Frame frame_of(const FittedTest& test);

// Where the analysis did not succeed, what depends on it is null or empty, and "status" says why.
const Fields<FittedTest>& fit_fields();

Json fit_json(const FittedTest& test);

}  // namespace flexslip
