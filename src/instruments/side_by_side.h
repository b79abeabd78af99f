// Tables of several specimens beside each other: the same titles again and again on one line.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace flexslip {

// Which columns, counted from 0, belong to one specimen.
struct ColumnGroup {
  std::size_t first;                 // of its own columns
  std::vector<std::size_t> columns;  // those that all share, such as a time before the first, and its own
};

// The specimens on a line of titles: at least two with the same titles in the same order, a force among them, columns without a title
// between them at will; before the first, one column may stand that all share. Empty if that is not so.
std::vector<ColumnGroup> side_by_side(std::span<const std::string> titles);

}  // namespace flexslip
