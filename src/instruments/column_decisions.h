// What the columns of an export are taken for: as its words say, or as the user does, and what remains to be asked.
#pragma once

#include <cstddef>

#include "instruments/export.h"

namespace flexslip {

// The export whose columns have the roles and units that the options state, with questions for what neither they nor the file say, and the flags
// that decide the same again. The header of its numbers stands on a line, counted from 1.
// Fails:      InputError for options that name no such column, a force in volts without its calibration, a unit that what the file states of its
//             greatest force contradicts.
Export decided(Export file, const ExportOptions& options, std::size_t header_line);

}  // namespace flexslip
