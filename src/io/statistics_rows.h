// Rows of statistics below the readings: mean, maximum, standard deviation. They are not readings.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/sheet.h"

namespace flexslip {

// True for a label of statistics: "Mean", "Std. Dev.", "Mittelwert", "Écart type", "平均".
bool names_statistic(std::string_view cell);

// The label of a line: its first non-empty cell, if it holds letters and is neither a number with a
// unit nor a unit. Otherwise empty.
std::string_view label_of(const Sheet& sheet, std::size_t line);

// Rows that are not readings, ascending, and notes on them and on doubtful rows.
struct StatisticsRows {
  std::vector<std::size_t> rows;
  std::vector<std::string> notes;
};

// The rows of statistics in a table. `lines` are the lines of its rows, from 0, ascending. Known
// lines of statistics are added to the notes.
// Domain:     columns as long as `lines`.
// Method:     by labels, if less than half of the rows have one: rows whose label names a
//             statistic, and labelled rows at the end. With more labels, the labels are data, such
//             as names of phases. Otherwise by numbers: a row at the end that is, in all columns
//             and to three digits, the mean, standard deviation, sum, minimum or maximum of the
//             rows above. One of these rows must be a mean, deviation or sum that lies below a
//             break, or that differs from the row above by far more than readings differ. Tables
//             with fewer than two columns or twelve rows have no such rows.
// Cost:       linear.
StatisticsRows statistics_among(const Sheet& sheet, std::span<const std::size_t> lines,
                                std::span<const std::vector<double>> columns,
                                std::vector<std::size_t> known_lines = {});

// The values of a column without some rows. The rows are ascending.
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
