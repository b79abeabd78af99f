// Rows below readings that say something of them: their mean, their greatest, their deviation. They are no readings.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/sheet.h"

namespace flexslip {

// Does a cell call its row a statistic: "Mean", "Std. Dev.", "Mittelwert", "Écart type", "平均"?
bool names_statistic(std::string_view cell);

// The label of a line, its first cell that is not empty, if that holds letters and is no number or unit with one; empty otherwise.
std::string_view label_of(const Sheet& sheet, std::size_t line);

// Rows that are no readings, in their order, and what is said of them, and of those that may be none.
struct StatisticsRows {
  std::vector<std::size_t> rows;
  std::vector<std::string> notes;
};

// The rows of statistics among those of a table, which stand on these lines of a sheet, counted from 0 and rising. Lines that are known to be
// statistics are said with them.
// Domain:     columns of one length, that of the lines.
// Method:     by labels, where they are few: rows whose label names a statistic, and those below all rows without a label. Where half of the rows or
//             more have one, labels are data: phases, names. Or else by numbers: rows at the end that are, each in all columns, the mean, the standard
//             deviation, the sum, the least or the greatest of those above, to three digits; one of them a mean, a deviation or a sum that is
//             elsewhere than the row above it, by far more than readings are from each other in some column, or below a break.
//             Of fewer than two columns or twelve rows, none.
// Cost:       linear.
StatisticsRows statistics_among(const Sheet& sheet, std::span<const std::size_t> lines,
                                std::span<const std::vector<double>> columns,
                                std::vector<std::size_t> known_lines = {});

// The values of a column, one for each row, without those of some rows, which rise.
template <class Value>
std::vector<Value> without_rows(std::vector<Value> all, std::span<const std::size_t> rows) {
  if (rows.empty()) return all;
  std::vector<Value> kept;
  kept.reserve(all.size() - rows.size());
  auto next = rows.begin();
  for (std::size_t row = 0; row < all.size(); ++row)
    if (next != rows.end() && *next == row)
      ++next;
    else
      kept.push_back(all[row]);
  return kept;
}

}  // namespace flexslip
