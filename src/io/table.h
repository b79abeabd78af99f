// Tables of readings or of words. A table has one header line with titles. Units are in this line
// or in the line below. Empty lines and comments, which start with #, are skipped.
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

// A column to read. Its unit is given in the requested title, in the header, or in a line of units below the header. At
// least one of them must give it, unless the kind is kind::number, and all must agree.
struct WantedColumn {
  std::string title;
  Kind kind;
};

struct Column {
  std::string name;
  std::vector<double> values;  // [SI unit of the requested kind]
};

// Columns of readings, one row per line.
struct Table {
  std::string source;                // the file as the user named it
  std::vector<Column> columns;       // the requested columns, in order; all of the same length, at least 1
  std::vector<std::size_t> lines;    // the line of each row in the file, counted from 1
  std::vector<std::string> notes{};  // decisions: a unit at the end of a name; omitted rows; the sheet of a workbook
  std::vector<std::size_t> missing_rows{};  // omitted rows of a record, which have no number; from 0, ascending

  std::size_t rows() const { return columns.front().values.size(); }

  // The number of rows of the file, including the missing rows.
  std::size_t rows_of_file() const { return rows() + missing_rows.size(); }

  // The row of the file for a row, and the number of rows before a row of the file; from 0.
  std::size_t file_row(std::size_t row) const;
  std::size_t rows_before(std::size_t file_row) const;
};

// Reads the requested columns of a table; other columns may hold anything. Every value is finite. Rows of statistics
// (statistics_rows.h) are omitted. In a workbook, `decimal` applies to numbers that are stored as words.
// Domain:     at least one wanted column; decimal is '.' or ',' (std::invalid_argument otherwise).
// Fails:      InputError with file, line and column, for any other content, and for a date or clock
//             time in these columns.
// Cost:       1.3 s for 10^7 rows of two columns. Memory: the file, 4 bytes a cell, 12 bytes a row
//             and 8 bytes a number.
Table read_table(const std::string& path, const std::vector<WantedColumn>& wanted, char decimal = '.',
                 const std::optional<SheetChoice>& sheet = {});

// Reads a table from the bytes of a file.
Table table_in(std::string bytes, const std::string& source, const std::vector<WantedColumn>& wanted,
               char decimal = '.');

struct TextRow {
  std::size_t line;                // in the file, counted from 1
  std::vector<std::string> cells;  // one for each title; empty if the line is too short
};

// A table of words, as people keep it in a spreadsheet.
struct TextTable {
  std::string source;  // the file as the user named it
  std::size_t header_line;
  std::vector<std::string> titles;  // not empty, and all different
  std::vector<TextRow> rows;
};

// Reads a table separated by commas, semicolons or tabs, or the first sheet of a workbook with a
// number. A cell '=a is read as =a, the inverse of without_formula.
// Fails:      InputError with file and line: no header, a missing or repeated title, more cells
//             than titles, a stray quote, a date.
TextTable read_text_table(const std::string& path);

// A cell of a written table: a number or words.
using Cell = std::variant<double, std::string>;

// Supplies the cells of the next row; false after the last row.
using NextRow = std::function<bool(std::vector<Cell>& cells)>;

// The decimal mark of written CSV. A decimal comma leaves semicolons to separate the cells.
struct CsvMarks {
  char decimal = '.';  // or ','

  constexpr char separator() const { return decimal == ',' ? ';' : ','; }
};

// Writes CSV with a header. Numbers have the fewest digits (at most 17) that read back to the same bits.
// Domain:     a cell for each title; std::invalid_argument otherwise.
// Fails:      InputError if the output is incomplete.
void write_table(std::ostream& out, const std::vector<std::string>& titles, const NextRow& next,
                 const CsvMarks& marks = {});

// Writes the table to a file, completely or not at all (OutputFile); "-" is standard output.
void write_table(const std::string& path, const std::vector<std::string>& titles, const NextRow& next,
                 const CsvMarks& marks = {});

}  // namespace flexslip
