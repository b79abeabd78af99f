// The roles of an export's columns, from their titles and from the user, and the open questions.
#pragma once

#include <cstddef>

#include "instruments/export.h"

namespace flexslip {

// The export whose columns have the roles and units of the options. Adds questions on what neither
// the options nor the file state, and the flags that repeat the decisions. `header_line` counts
// from 1.
// Fails:      InputError for an option that names no such column, a force in volts without a
//             calibration, or a unit that contradicts the maximum force stated in the file.
Export decided(Export file, const ExportOptions& options, std::size_t header_line);

}  // namespace flexslip
