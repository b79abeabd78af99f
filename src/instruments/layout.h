// Where in an export the tables are, and what stands around them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/sheet.h"

namespace flexslip {

// A table: rows of numbers below a line of names and one of units, either of which may be missing. Lines count from 0.
struct TableBlock {
  std::vector<std::string> titles{};   // as many as columns; empty if no line above names the columns
  std::vector<std::string> units{};    // likewise, without brackets
  std::size_t header_line = 0;         // that of the titles, or the units, or the first row
  std::vector<std::size_t> rows{};     // lines
  std::vector<std::size_t> misfits{};  // lines between the rows with more or fewer cells, or words only
  std::vector<std::size_t> remarks{};  // lines above the header that belong to no table
};

struct Layout {
  std::size_t columns = 0;    // of each row
  std::vector<bool> numeric;  // which of them hold numbers in most rows
  std::vector<TableBlock> blocks{};
  std::vector<std::size_t> remarks{};  // below the last block
  bool cut_off = false;                // the last line of the file had fewer cells, and is no row
  std::vector<std::string> notes{};    // on rows of statistics, which are left out, and rows that may be some
};

// Method:     most numbers of a file stand in lines with numbers in the same columns: those are its rows. What looks like
//             names or units between them begins another table. Rows of statistics (io/statistics_rows.h) are none, by their labels, or
//             without one by their numbers.
// Fails:      InputError, without a file: no numbers; more than a tenth of the lines between rows are misfits.
Layout layout_of(const Sheet& sheet);

}  // namespace flexslip
