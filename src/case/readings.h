// The columns of a record as its file has them, found by their names or by what the file says of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.h"
#include "case/preparation.h"
#include "io/table.h"

namespace flexslip {

// What whoever evaluates a record needs of it.
struct Needs {
  std::size_t points;  // at least
  bool span = false;   // of the case, or of the file: asked for with all else that is open
};

enum class Reading { stage, deflection, force, length };

// The columns of a record, each still as its machine counts.
struct Readings {
  Test test;                                  // completed with what the file says of span and section
  Table table;                                // two columns [m], [N], and perhaps a length [m]
  std::vector<Reading> columns;               // what each of them is
  std::vector<PreparationStep> found_by{};    // how they were found
  std::vector<std::string> contradictions{};  // sentences: see dimensions_of_file.h

  bool has(Reading reading) const;
  // Domain: has(reading).
  const std::vector<double>& of(Reading reading) const;
  // Of the displacement, the column that comes first.
  const std::vector<double>& displacement() const { return table.columns.front().values; }
};

// Reads the columns of the record of a case, in SI: from a table whose columns are named, or from the export of a testing machine, whose columns
// say themselves what they are.
// Fails:      InputError, besides what read_table and read_export throw: a displacement of which neither case nor file says what it
//             is one of, several specimens of which none is chosen, one that is not there.
Readings read_readings(const Test& input, const Needs& needs);

// The row that a place is, if it is one of the record's; else `none`.
std::size_t row_or(const std::optional<PlaceInRecord>& place, std::size_t rows, std::size_t none);

}  // namespace flexslip
