// The tables of an export: rows of numbers, titles, units, and other lines. Lines and columns count
// from 0.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/sheet.h"

namespace flexslip {

// Rows of numbers below a line of names and a line of units. Either line may be missing.
struct TableBlock {
  std::string name{};                  // of the specimen, if the line of titles begins with its number; otherwise empty
  std::vector<std::string> titles{};   // one for each column; empty if no line names the columns
  std::vector<std::string> units{};    // one for each column, without brackets; empty without a line of units
  std::size_t header_line = 0;         // line of the titles, otherwise of the units, otherwise of the first row
  std::vector<std::size_t> rows{};     // lines
  std::vector<std::size_t> misfits{};  // lines between the rows with another number of cells or only words
  std::vector<std::size_t> between{};  // lines of words within the table
  std::vector<std::size_t> remarks{};  // lines above the header outside any table
  std::string unplaced{};              // titles that match no column; otherwise empty
  std::vector<std::string> notes{};    // how titles and units were matched to columns, unless by counting
};

struct Layout {
  std::size_t columns = 0;    // in each row
  std::vector<bool> numeric;  // columns with numbers in most rows
  std::vector<TableBlock> blocks{};
  std::vector<std::size_t> remarks{};  // below the last block
  bool cut_off = false;                // the last line of the file had fewer cells and is not a row
  std::vector<std::string> notes{};    // on omitted rows of statistics and on doubtful rows
};

// The tables of a sheet.
// Method:     Most numbers of a file are in lines with numbers in the same columns: the rows. Lines
//             of names or units in between start another table. Titles are matched to columns by
//             the separator of the rows; on a line without it, by gaps, units in brackets and
//             words. A last cell that is empty in all rows has no title, a last title without a
//             meaning has no cells, and a first column that counts or names the rows may have no
//             title. Other titles are not used. A table without titles above one with titles is a
//             preamble if it has fewer rows than an evaluation needs.
// Fails:      InputError, without a file: no rows of numbers, or over a tenth of the lines have
//             another number of cells.
Layout layout_of(const Sheet& sheet);

bool has_number(std::string_view cell);  // in any notation, perhaps with its unit

}  // namespace flexslip
