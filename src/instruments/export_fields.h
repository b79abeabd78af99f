// What is told of an export: by `read --json` what was decided about the file and what it holds, without its numbers; in its canonical form, UTF-8,
// commas, decimal points, one line of names with units in square brackets, what it holds.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "instruments/export.h"
#include "result/fields.h"

namespace flexslip {

// An export, and the specimen whose columns and rows are told first.
struct ToldExport {
  const Export& file;
  std::size_t chosen;
};
Fields<ToldExport> export_fields();

// Writes a specimen: its metadata as lines "# name: value", a header "name [unit]", and numbers of the fewest digits that
// read back to the same bits. What read_export makes of it has the same columns, units and values, and is written as the
// same bytes.
// Fails:      InputError if not all could be written.
void write_canonical(std::ostream& out, const Export& file, const ExportedSpecimen& specimen);

// The same to a file; "-" is standard output.
void write_canonical(const std::string& path, const Export& file, const ExportedSpecimen& specimen);

}  // namespace flexslip
