// Columns whose decimal commas a spreadsheet has taken for separators of thousands.
//
// Opened in an English spreadsheet, "100,0292" is the integer 1000292 and is saved as "1,000,292"; "100,014" is saved as
// it was, and "100,01" and "0,1366", which no grouping explains, stay words. The digits are right; where the decimal
// comma was is not in the cell, but in its neighbours: a decimal more or less is a factor of ten.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace flexslip {

struct Regrouped {
  enum class Status { none, restored, ambiguous };
  Status status = Status::none;
  std::vector<double> values;  // unless ambiguous; NaN for a cell that is no number
  std::size_t moved = 0;       // cells whose decimal comma was elsewhere than the last comma
  std::size_t row = 0;         // ambiguous: the first that its neighbour does not decide
};

// The numbers of a column with decimal commas.
// Method:     the decimals of each cell such that the column varies least in all (a shortest path over the rows). That is
//             accepted only if some cell that cannot be regrouped anchors it, and each choice is at least thirty
//             times nearer to its neighbour than the next best.
// Cost:       linear.
Regrouped restored(std::span<const std::string_view> cells);

}  // namespace flexslip
