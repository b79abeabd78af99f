// The columns of a record as its file has them, in SI: from a table whose columns the case names, or from the export of a
// testing machine, whose columns say themselves what they are.
#pragma once

#include <vector>

#include "case/case_file.h"
#include "case/preparation.h"
#include "io/table.h"

namespace flexslip {

enum class Reading { stage, deflection, force, length };

struct Readings {
  Case test;                     // the case, completed with what the file says of span and section
  Table table;                   // two columns [m], [N], and perhaps a length [m]
  std::vector<Reading> columns;  // what each of them is
  Preparation preparation;       // how they were found
};

// Domain:     a case with a record; std::invalid_argument otherwise.
// Fails:      InputError, besides what read_table and read_export throw: a displacement of which neither case nor file says what it
//             is one of, several specimens of which none is chosen, one that is not there.
Readings read_readings(const Case& input);

}  // namespace flexslip
