// Tables of answers, for CSV, XLSX and print: one row per item, one column per number. And JSON
// files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/table.h"
#include "result/fields.h"

namespace flexslip {

struct TableColumn {
  std::string name;  // "wavelength_low": as in JSON, unless the field has a title
  bool has_numbers;
  Kind kind;             // of numbers
  std::string unit;      // of numbers, "m"; empty for words and plain numbers
  std::string meaning;   // a short phrase
  std::string quantity;  // "wavelength": all columns of a quantity have the same unit
};

struct ResultTable {
  std::string name;  // "tests"
  std::vector<TableColumn> columns;
  std::vector<std::vector<Cell>> rows;  // NaN or empty words where there is no value
};

// The columns of fields. An estimate takes four: value, standard error and both ends of its
// interval. A group takes one per entry.
// Domain:     no lists except lists of words; std::invalid_argument otherwise.
std::vector<TableColumn> columns_of(const std::vector<Description>& fields, bool reduced);

// Appends the cells of one field.
void append_cells(std::vector<Cell>& cells, const Description& field, const Json& value);

template <class Row>
std::vector<Cell> cells_of(const Fields<Row>& fields, const Row& row, const Frame& frame) {
  std::vector<Cell> cells;
  for (const auto& field : fields) append_cells(cells, field.what, fields.of(field, row, frame));
  return cells;
}

template <class Row, class Rows>
ResultTable tabulated(std::string name, const Fields<Row>& fields, const Rows& rows, const Frame& frame = {}) {
  ResultTable table{std::move(name), columns_of(fields.descriptions(), frame.reduced), {}};
  for (const Row& row : rows) table.rows.push_back(cells_of(fields, row, frame));
  return table;
}

// "F [N]"
std::vector<std::string> titles_of(const std::vector<TableColumn>& columns);

// Writes CSV with units in the titles. Numbers have the fewest digits that restore the same bits; a
// missing number is "nan". Words that look like formulas are escaped.
// Fails:      throws InputError if the file cannot be written.
void write_csv(const std::string& path, const ResultTable& table, const CsvMarks& marks = {});

// The same row by row, without storing the table.
template <class Row, class Rows>
void write_csv(const std::string& path, const Fields<Row>& fields, const Rows& rows, const Frame& frame,
               const CsvMarks& marks = {}) {
  auto at = rows.begin();
  const auto next = [&](std::vector<Cell>& cells) {
    if (at == rows.end()) return false;
    cells = cells_of(fields, *at++, frame);
    return true;
  };
  write_table(path, titles_of(columns_of(fields.descriptions(), frame.reduced)), next, marks);
}

// The unit in which a column is shown.
struct TableUnit {
  std::string name;  // as parse_unit takes it
  double factor;     // from SI
};

// The unit that suits the median of the values, so that one outlier does not change it. NaN is
// ignored.
TableUnit best_unit_of(std::vector<double> values, const Kind& kind);

// The same table with each quantity in the unit that suits its first column.
// Domain:     units in SI.
ResultTable in_best_units(ResultTable table);

// Indented JSON with its last line end. Keys keep their order; numbers restore the same bits.
std::string json_text(const Json& json);

// Writes it to a file; "-" is standard output.
// Fails:      throws InputError if the file cannot be written completely.
void write_json(const std::string& path, const Json& json);

}  // namespace flexslip
