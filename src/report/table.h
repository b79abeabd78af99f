// Tables for people: every cell as it is printed; made of columns of numbers, or of the fields of an answer.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/quantity.h"
#include "result/fields.h"

namespace flexslip {

// Is a table on a page folded, so that its rows show when they are asked for?
enum class Folding { never, of_long, always };  // of_long: of more than 12 rows

// Columns of words stand to the left, as the first does; columns of numbers to the right.
struct PrintedTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> links{};  // where the first cells lead on a page; empty where nowhere
  Folding folding = Folding::of_long;
  // Headings of the columns that a terminal has room for, the last of them cut where the line ends; all if there are none.
  std::vector<std::string_view> on_terminal{};
};

// Has a column, beside the first, cells that begin as numbers do, and no others?
bool is_of_numbers(const PrintedTable& table, std::size_t column);

// Some columns of a table, by what their headings begin with; all if there are none.
// Domain:     headings of the table; std::invalid_argument otherwise.
PrintedTable picked(const PrintedTable& table, const std::vector<std::string_view>& columns);

// A column, made of a field by its name: a number (all in one unit, which stands in the heading), an estimate ("a ± b", each in its own
// unit), a count or words. An entry of a group is "group.entry".
struct Shown {
  std::string heading;
  std::string_view field;   // empty: 1, 2, 3, … from row to row
  int digits = 4;           // of the largest number
  double factor = 1;        // of numbers: 100 for a share in per cent
  std::string_view last{};  // field of the last of a range of counts, "a–b"
  std::vector<std::pair<std::string_view, std::string_view>> in_words{};  // what is shown for words of the answer
};

// A list in an answer, a row an entry; "cycles.loops" lies in a group. A cell is empty where there is nothing.
// Fails:      std::invalid_argument for a list or a field that is not described, or is none of these.
PrintedTable shown(const FieldList& answer, const void* of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns);

template <class Row>
PrintedTable shown(const Fields<Row>& answer, const Row& of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns) {
  return shown(answer.untyped(), &of, frame, list, columns);
}

// A group in an answer, a row a number, an estimate, a count or words that are there: its name, value, interval and meaning, as they are described. Folded.
// Fails:      std::invalid_argument for a group that is not described.
PrintedTable told(const FieldList& answer, const void* of, const Frame& frame, std::string_view group);

template <class Row>
PrintedTable told(const Fields<Row>& answer, const Row& of, const Frame& frame, std::string_view group) {
  return told(answer.untyped(), &of, frame, group);
}

}  // namespace flexslip
