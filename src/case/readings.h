// The columns of a record as in its file, found by their titles or by the description of the
// export.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.h"
#include "case/preparation.h"
#include "io/table.h"

namespace flexslip {

// The requirements of an evaluation.
struct Needs {
  std::size_t points;  // minimum number
  // From the case or the file; asked for with all other open questions. A load train is always needed
  // for a displacement of the crosshead.
  bool span = false, load_train = false;
};

enum class Reading { stage, deflection, force, length };

// The columns of a record in the coordinates of the machine.
struct Readings {
  Test test;                                  // completed with span and section from the file
  Table table;                                // two columns [m], [N], and perhaps a length [m]
  std::vector<Reading> columns;               // the quantity of each column
  std::vector<PreparationStep> found_by{};    // how they were found
  std::vector<std::string> contradictions{};  // sentences: see dimensions_of_file.h

  bool has(Reading reading) const;
  // Domain: has(reading).
  const std::vector<double>& of(Reading reading) const;
  // The first displacement column.
  const std::vector<double>& displacement() const { return table.columns.front().values; }
};

// Reads the columns of the record of a case in SI: from a table with named columns, or from the
// export of a testing machine.
// Fails:      InputError as read_table and read_export; for a displacement whose place neither case
//             nor file states; for several specimens without a choice; for a missing specimen.
Readings read_readings(const Test& input, const Needs& needs);

// The row of a place, if it is a row of the record; otherwise `none`.
std::size_t row_or(const std::optional<PlaceInRecord>& place, std::size_t rows, std::size_t none);

}  // namespace flexslip
