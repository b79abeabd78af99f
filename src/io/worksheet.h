// One sheet of a workbook as text: what its file would be if it had been saved as CSV, with tabs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/cell_kinds.h"
#include "io/zip_archive.h"

namespace flexslip {

struct Worksheet {
  // A line for each row, so that line n is row n; cells apart by tabs, in quotes where they need them. Numbers as the workbook has
  // them, digit for digit; formulas by their stored values; TRUE and FALSE; dates as the numbers of days that they are, told by
  // `kinds`. Or, of a sheet that holds words in one column alone, these as they stand: a text file that was opened as a workbook.
  std::string text;
  CellKinds kinds;
  bool one_column = false;             // of words
  std::size_t rows_of_readings = 0;    // with two numbers or more, or numbers alone
  std::size_t numbers = 0;             // cells
  std::size_t numeric_words = 0;       // cells whose words are digits and marks
  std::size_t first_numeric_word = 0;  // row, from 1
  std::size_t without_value = 0;       // formulas that no spreadsheet program has computed
};

// Fails:      InputError, without a file, with the row as its line: damaged, a cell that is out of place or no number, more text than
//             512 MiB.
// Cost:       memory that of the text.
Worksheet read_worksheet(const ZipArchive& archive, const std::string& part,
                         const std::vector<std::string>& shared_strings, const std::vector<CellKind>& styles = {});

// The strings that the cells of a workbook refer to.
std::vector<std::string> read_shared_strings(const ZipArchive& archive, const std::string& part);

}  // namespace flexslip
