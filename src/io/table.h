// Tables whose columns are known by their titles: of readings, which are columns that a user names, or of words. One header line, units in it or
// in a line below; empty lines and comments, which start with #, are none of it.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/quantity.h"
#include "io/workbook.h"

namespace flexslip {

// The name of a column and its unit: "F_N [N]" is {"F_N", "N"}.
struct ColumnTitle {
  std::string name;
  std::string unit;  // empty if the title has none
};

// Splits off a unit in square brackets at the end.
// Fails:      InputError, without a place, if there is no name or the brackets hold no unit.
ColumnTitle parse_column_title(std::string_view title);

// A column to read. The unit may stand in the title asked for, in the file's header, or in a line of units below it:
// at least one of them, unless the kind is kind::number, and they must agree.
struct WantedColumn {
  std::string title;
  Kind kind;
};

struct Column {
  std::string name;
  std::vector<double> values;  // [SI unit of the kind wanted]
};

// Columns of readings, one row each on a line.
struct Table {
  std::string source;              // the file as the user named it
  std::vector<Column> columns;     // those wanted, in that order; all of the same length, at least 1
  std::vector<std::size_t> lines;  // of the file, counted from 1, on which each row stands
  std::vector<std::string>
      notes{};  // what was decided about it: a unit at the end of a name; rows left out; of a workbook, the sheet
  std::vector<std::size_t>
      missing_rows{};  // of a record: rows of the file without a number, which are left out; from 0, rising

  std::size_t rows() const { return columns.front().values.size(); }

  // Those of the file, with the missing ones.
  std::size_t rows_of_file() const { return rows() + missing_rows.size(); }

  // The row of the file that a row is, and how many rows lie before one of the file; from 0.
  std::size_t file_row(std::size_t row) const;
  std::size_t rows_before(std::size_t file_row) const;
};

// Reads the wanted columns of a table; other columns may hold anything. Every value is finite. Rows of statistics (statistics_rows.h) are left out.
// The decimal mark of a workbook is that of its numbers kept as words. A date or clock time in a column wanted is refused.
// Domain:     at least one wanted column; decimal is '.' or ',' (std::invalid_argument otherwise).
// Fails:      InputError with file, line and column, for anything that is not such a table.
// Cost:       10^7 rows of two columns in about 1.3 s; memory for the file, 4 bytes a cell of it, and 12 a row and 8 a number wanted.
Table read_table(const std::string& path, const std::vector<WantedColumn>& wanted, char decimal = '.',
                 const std::optional<SheetChoice>& sheet = {});

// The same from the bytes of a file.
Table table_in(std::string bytes, const std::string& source, const std::vector<WantedColumn>& wanted,
               char decimal = '.');

struct TextRow {
  std::size_t line;                // of the file, counted from 1
  std::vector<std::string> cells;  // one for each title; those that the line lacks are empty
};

// A table of words: what a person keeps in a spreadsheet.
struct TextTable {
  std::string source;  // the file as the user named it
  std::size_t header_line;
  std::vector<std::string> titles;  // none empty, none twice
  std::vector<TextRow> rows;
};

// Reads a table separated by commas, semicolons or tabs, or the first sheet with a number of a workbook. A cell is what without_formula was given:
// '=a is =a.
// Fails:      InputError with file and line: no header, a title that is missing or there twice, more cells than titles, a stray quote, a date.
TextTable read_text_table(const std::string& path);

// What stands in a table that is written: a number, or words.
using Cell = std::variant<double, std::string>;

// Gives the cells of the next row; false where there is none.
using NextRow = std::function<bool(std::vector<Cell>& cells)>;

// Writes CSV with a header. Numbers have the fewest digits (at most 17) that read back to the same bits.
// Domain:     a cell for each title; std::invalid_argument otherwise.
// Fails:      InputError if not all could be written.
void write_table(std::ostream& out, const std::vector<std::string>& titles, const NextRow& next);

// The same to a file, whole or not at all (OutputFile); "-" is standard output.
void write_table(const std::string& path, const std::vector<std::string>& titles, const NextRow& next);

}  // namespace flexslip
