// Answers as tables: the rows of what describes itself, a column a number. What CSV, XLSX and print lay out; and answers as JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/table.h"
#include "result/fields.h"

namespace flexslip {

struct TableColumn {
  std::string name;  // "wavelength_low"; as in JSON, or the title that stands for it in tables
  bool has_numbers;
  Kind kind;             // of numbers
  std::string unit;      // of numbers, "m"; empty for words and plain numbers
  std::string meaning;   // in a few words
  std::string quantity;  // "wavelength": columns of one quantity have one unit
};

struct ResultTable {
  std::string name;  // "tests"
  std::vector<TableColumn> columns;
  std::vector<std::vector<Cell>> rows;  // NaN, or no words, where there is nothing
};

// The columns of fields, an estimate taking four, its value, standard error and the ends of its interval, and a group one for each entry.
// Domain:     no lists among them but of words; std::invalid_argument otherwise.
std::vector<TableColumn> columns_of(const std::vector<Description>& fields, bool reduced);

// Appends what stands in the columns of a field.
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

// CSV, units in the titles, the shortest digits that read back to the same bits; "nan" where there is no number. Words are kept from
// being taken for formulas.
// Fails:      InputError if it cannot be written.
void write_csv(const std::string& path, const ResultTable& table);

// The same row by row, of as many as there are.
template <class Row, class Rows>
void write_csv(const std::string& path, const Fields<Row>& fields, const Rows& rows, const Frame& frame) {
  auto at = rows.begin();
  write_table(path, titles_of(columns_of(fields.descriptions(), frame.reduced)), [&](std::vector<Cell>& cells) {
    if (at == rows.end()) return false;
    cells = cells_of(fields, *at++, frame);
    return true;
  });
}

// What a column is shown in.
struct TableUnit {
  std::string name;  // as parse_unit takes it
  double factor;     // from SI
};

// That of the median, which a single odd test does not move. NaN is passed over.
TableUnit best_unit_of(std::vector<double> values, const Kind& kind);

// The same table with every quantity in the unit that suits its first column.
// Domain:     units in SI.
ResultTable in_best_units(ResultTable table);

// Answers as JSON, for machines. Keys keep their order; numbers read back to the same bits; what does not exist is null.

// Writes indented JSON to a file; "-" is standard output.
// Fails:      InputError if not all could be written.
void write_json(const std::string& path, const Json& json);

}  // namespace flexslip
