// Where the tables of an export are: its rows of numbers, the titles and units above them, and what belongs to no table. Lines and columns count
// from 0.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/sheet.h"

namespace flexslip {

// Rows of numbers below a line of names and one of units, either of which may be missing.
struct TableBlock {
  std::string name{};                  // of the specimen, where the line of titles begins with its number; else empty
  std::vector<std::string> titles{};   // one for each column; empty if no line above names the columns
  std::vector<std::string> units{};    // likewise, without brackets
  std::size_t header_line = 0;         // that of the titles, or the units, or the first row
  std::vector<std::size_t> rows{};     // lines
  std::vector<std::size_t> misfits{};  // lines between the rows with more or fewer cells, or words only
  std::vector<std::size_t> between{};  // lines of words between the rows, which go on behind them
  std::vector<std::size_t> remarks{};  // lines above the header that belong to no table
  std::string unplaced{};              // which titles stand above the rows and cannot be told to columns; else empty
  std::vector<std::string> notes{};    // how titles and units came above their columns, where that is not by counting
};

struct Layout {
  std::size_t columns = 0;    // of each row
  std::vector<bool> numeric;  // which of them hold numbers in most rows
  std::vector<TableBlock> blocks{};
  std::vector<std::size_t> remarks{};  // below the last block
  bool cut_off = false;                // the last line of the file had fewer cells, and is no row
  std::vector<std::string> notes{};    // on rows of statistics, which are left out, and rows that may be some
};

// The tables of a sheet.
// Method:     Most numbers of a file stand in lines with numbers in the same columns: those are its rows. What looks like names or units between
//             them begins another table. Titles are never told to columns by anything but the separator of the rows, or, on a line without it, by
//             gaps, units in brackets and words; a last cell that is empty in all rows has no title, a last title that means nothing no cells, and
//             a first column that counts or names the rows may have none. Other titles are not used. A table without titles that has fewer rows
//             than an evaluation needs, above one with titles, is a preamble.
// Fails:      InputError, without a file: no rows of numbers, or more than a tenth of them have another number of cells.
Layout layout_of(const Sheet& sheet);

bool has_number(std::string_view cell);  // in some country's notation, perhaps with its unit

}  // namespace flexslip
