// Tables for people, with every cell as printed. They are built from the fields of an answer.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/quantity.h"
#include "result/fields.h"

namespace flexslip {

// When a table on a page is folded. of_long: with more than 12 rows.
enum class Folding { never, of_long, always };

// A table. Columns of words and the first column are left-aligned, columns of numbers
// right-aligned.
struct PrintedTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> links{};  // targets of the first cells on a page; empty for none
  Folding folding = Folding::of_long;
  bool is_cut = false;  // a terminal cuts its rows to one line
  // The columns shown on a page, counted from 0, in their order. Default: all.
  std::vector<std::size_t> on_page{};
};

// True if all cells of a column after the first begin like numbers.
bool is_of_numbers(const PrintedTable& table, std::size_t column);

// These columns as head and rows, or all if none are given; without those in which no row has a
// value. Columns are counted from 0.
PrintedTable picked(const PrintedTable& table, std::vector<std::size_t> columns = {});

// A column made from a field: numbers (all in the unit in the heading), estimates ("a ± b", each in
// its own unit), counts or words. An entry of a group is "group.entry".
struct Shown {
  std::string heading;
  std::string_view field;  // empty: row numbers
  int digits = 4;          // of the largest number
  // 100 for a share in per cent
  double factor = 1;
  // last field of a range of counts, "a–b"
  std::string_view last{};
  // text shown for words of the answer
  std::vector<std::pair<std::string_view, std::string_view>> in_words{};
};

// A list in an answer as a table with one row per entry. "cycles.loops" is a list in a group.
// Missing values give empty cells.
// Fails:      throws std::invalid_argument for a list or field that does not exist.
PrintedTable shown(const FieldList& answer, const void* of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns);

template <class Row>
PrintedTable shown(const Fields<Row>& answer, const Row& of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns) {
  return shown(answer.untyped(), &of, frame, list, columns);
}

// A group in an answer as a folded table. Each present number, estimate, count or word gives a row
// with name, value, interval and meaning. A page shows the meaning instead of the name.
// Fails:      throws std::invalid_argument for a group that does not exist.
PrintedTable group_table(const FieldList& answer, const void* of, const Frame& frame, std::string_view group);

template <class Row>
PrintedTable group_table(const Fields<Row>& answer, const Row& of, const Frame& frame, std::string_view group) {
  return group_table(answer.untyped(), &of, frame, group);
}

}  // namespace flexslip
