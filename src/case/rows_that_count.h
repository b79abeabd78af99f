// Which rows of a record are points of it: its readings, once each, as many as a test has use for, up to the end of the load cell.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "case/preparation.h"
#include "data/record.h"
#include "io/table.h"

namespace flexslip {

// Of records of more rows that count every so many are used: a test has a few hundred features, whatever the readings of them.
inline constexpr std::size_t max_record_points = 2000;
inline constexpr std::size_t max_cyclic_points = 10000;  // of a test that is unloaded

// Rows of the table, counted from 0, as a case states them.
struct StatedRows {
  std::size_t first = 0;               // those before are left out
  std::optional<std::size_t> until{};  // so many, with those before the first; what lies behind decides nothing
};

struct CountedRows {
  Record record;  // the points
  Sampling sampling;
  bool ends_in_overload;
};

// Of every row of a table, whose displacement is given beside it as it was read; what is left out is noted, step by step.
// Domain:     columns as long as the table, first before until; stiffness > 0 [N/m] of the load train, or infinite.
// Returns:    the rows that count as those of the file.
CountedRows rows_that_count(Record every, const Table& table, std::span<const double> displacement,
                            const StatedRows& stated, double stiffness, Preparation& steps);

// The points before a row, counted from 0.
std::size_t points_before(std::size_t row, const Sampling& sampling);

// The last row, counted from 1, before that of the point after so many.
std::size_t rows_of_points(const Sampling& sampling, std::size_t points);

}  // namespace flexslip
