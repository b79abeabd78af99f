// What the columns of an export are taken for: as its words say, or as the user does, and what remains to be asked.
#pragma once

#include <cstddef>
#include <vector>

#include "instruments/export.h"
#include "instruments/number_format.h"

namespace flexslip {

// What a file says of itself; of one specimen, with what it says of that.
std::vector<Metadatum> all_metadata(const Export& file);

// Gives the columns the roles and units that the options state, asks for what neither they nor the file say, and tells the flags that
// decide the same again. The header of its numbers stands on a line, counted from 1.
// Fails:      InputError for options that name no such column, a force in volts without its calibration, a unit that what the file states of its
//             greatest force contradicts.
void decide_columns(Export& file, const ExportOptions& options, const NumberFormat& format, std::size_t header_line);

}  // namespace flexslip
