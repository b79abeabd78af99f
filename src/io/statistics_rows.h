// Rows below readings that say something of them: their mean, their greatest, their deviation. They are no readings.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

// Does a cell call its row a statistic: "Mean", "Std. Dev.", "Mittelwert", "Écart type", "平均"?
bool names_statistic(std::string_view cell);

// Letters, so that it can be the label of a row, and no number or unit with one.
bool is_label(std::string_view cell);

// A row whose first cell that is not empty is a label.
struct LabelledRow {
  std::size_t row;  // from 0
  bool is_statistic;
};

// Which of these are no readings: where labels are few, those that name a statistic, and those that stand below all rows without one.
// Where half of the rows or more have one, labels are data: phases, names.
std::vector<std::size_t> rows_below_readings(std::span<const LabelledRow> labelled, std::size_t rows);

// How many rows at the end are, each in all columns, the mean, the standard deviation, the sum, the least or the greatest of the
// numbers above, to three digits: 0 unless one of them is a mean, a deviation or a sum that is elsewhere than the row above it, by far
// more than readings are from each other in some column, or below a break.
// Domain:     columns of one length; of fewer than two columns or twelve rows, none. So many rows stand below a break; 0 without one.
// Cost:       linear.
std::size_t statistics_at_end(std::span<const std::span<const double>> columns, std::size_t below_break = 0);

// Are so few of the rows below a break that they may be no readings? More are another cycle.
bool are_few(std::size_t below_break, std::size_t rows);

// What is said of them, with their lines: "left out, as they hold statistics of the readings: lines 42 to 45".
std::string left_out_statistics(std::span<const std::size_t> lines);
// And of rows that may be some: "lines 42 to 43 stand below a break and count as readings: delete them if they are none".
std::string below_a_break(std::size_t first_line, std::size_t last_line);

}  // namespace flexslip
