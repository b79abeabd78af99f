// The description of an export in JSON, with the decisions on the file; and its canonical form:
// UTF-8, commas, decimal points, one line of names with units in square brackets.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "instruments/export.h"
#include "result/fields.h"

namespace flexslip {

// An export, and the specimen that is described first.
struct ToldExport {
  const Export& file;
  std::size_t chosen;
};
Fields<ToldExport> export_fields();

// Writes a specimen: metadata as lines "# name: value", a header "name [unit]", and numbers with
// the fewest digits that read back to the same bits. read_export reproduces columns, units and
// values, and writing them again gives the same bytes.
// Fails:      InputError if the output is incomplete.
void write_canonical(std::ostream& out, const Export& file, const ExportedSpecimen& specimen,
                     const CsvMarks& marks = {});

// Writes the specimen to a file; "-" is standard output.
void write_canonical(const std::string& path, const Export& file, const ExportedSpecimen& specimen,
                     const CsvMarks& marks = {});

}  // namespace flexslip
