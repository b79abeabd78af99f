// Tables of numbers, or of words: CSV, or text separated by semicolons, tabs or spaces, one header line, units in the column names.
//
// Read: UTF-8 with or without byte order mark, any line ending, cells quoted or not, comment lines that start with #,
// empty lines, and a line of units below the header are all taken as what they are.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
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

// Lines without gaps: the row `row` and those after it stand on line `line` and those after it.
struct LineRun {
  std::size_t row;
  std::size_t line;
};

struct Table {
  std::string source;           // the file as the user named it
  std::vector<Column> columns;  // those wanted, in that order; all of the same length, at least 1
  std::vector<LineRun> lines;
  std::vector<std::string>
      notes{};  // what was decided about it: a unit at the end of a name; rows left out; of a workbook, the sheet

  std::size_t rows() const { return columns.front().values.size(); }
  std::size_t line_of(std::size_t row) const;  // 1-based line of a 0-based row, for messages
};

// Reads the wanted columns of a table; other columns may hold anything. Every value is finite. Rows of statistics (statistics_rows.h) are left out.
// Domain:     at least one wanted column; decimal is '.' or ',' (std::invalid_argument otherwise).
// Fails:      InputError with file, line and column, for anything that is not such a table.
// Cost:       10^7 rows of three columns in about 2 s; memory 8 bytes a value kept, up to twice that while reading.
Table read_table(std::istream& in, std::string source, const std::vector<WantedColumn>& wanted, char decimal = '.');

// The same from a file, or from a sheet of a workbook (workbook.h), whose rows are the lines; "-" is standard input. The decimal mark of a workbook is that
// of its numbers kept as words. A date or clock time in a column wanted is refused.
Table read_table(const std::string& path, const std::vector<WantedColumn>& wanted, char decimal = '.',
                 const std::optional<SheetChoice>& sheet = {});

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

// A file to read from; "-" is standard input.
// Fails:      OutputClash if the call writes it; InputError if it is missing, a directory or cannot be opened.
std::shared_ptr<std::istream> open_to_read(const std::string& path);

}  // namespace flexslip
