// Tables for people, made of the fields of an answer: which of them, under which headings.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "finding/printed.h"
#include "result/fields.h"

namespace flexslip {

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

// A list in an answer, a row an entry; "teeth.teeth" lies in a group. A cell is empty where there is nothing.
// Fails:      std::invalid_argument for a list or a field that is not described, or is none of these.
PrintedTable shown(const FieldList& answer, const void* of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns);

template <class Row>
PrintedTable shown(const Fields<Row>& answer, const Row& of, const Frame& frame, std::string_view list,
                   const std::vector<Shown>& columns) {
  return shown(answer.untyped(), &of, frame, list, columns);
}

}  // namespace flexslip
