// The numbers of the outcome of a design, each described once.
#pragma once

#include "design/design_result.h"
#include "result/fields.h"

namespace flexslip {

// The same names in CSV, JSON and HDF5. None where there is no outcome.
const Fields<DesignResult>& outcome_fields();

}  // namespace flexslip
