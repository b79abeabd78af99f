// The canonical form of an export: UTF-8, commas, decimal points, one line of names with units in square brackets.
#pragma once

#include <iosfwd>
#include <string>

#include "instruments/export.h"

namespace flexslip {

// Writes a specimen: its metadata as lines "# name: value", a header "name [unit]", and numbers of the fewest digits that
// read back to the same bits. What read_export makes of it has the same columns, units and values, and is written as the
// same bytes.
// Fails:      InputError if not all could be written.
void write_canonical(std::ostream& out, const Export& file, const ExportedSpecimen& specimen);

// The same to a file; "-" is standard output.
void write_canonical(const std::string& path, const Export& file, const ExportedSpecimen& specimen);

}  // namespace flexslip
