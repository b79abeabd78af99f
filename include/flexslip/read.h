// Exports of testing machines: what a file holds.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace flexslip::v1 {

struct Column {
  std::string name;            // as in the file
  std::string unit;            // as in the file; may be empty
  std::string role;            // time, displacement, crosshead, deflection, force or other
  std::vector<double> values;  // [SI] of a column with a role and a unit; NaN where a cell holds no number
};

struct ExportedSpecimen {
  std::string name;                 // may be empty
  std::vector<Column> columns;      // of one length
  std::vector<std::size_t> lines;   // of each row in the file, from 1
  std::vector<std::string> unsure;  // questions that the file leaves open, such as a missing unit
};

struct Export {
  std::string format;  // "Instron Bluehill", …, "table"
  std::vector<ExportedSpecimen> specimens;
  std::vector<std::string> notes;  // decisions and omissions, sentences
};

// Reads text in any encoding of testing machines, or a workbook (.xlsx).
// Max error:  numbers are correctly rounded; a unit adds 1 ulp.
// Fails:      Error for a file that cannot be read, or without a table of numbers.
Export read_export(const std::string& path);

}  // namespace flexslip::v1
