// The rows of a record that carry information: loggers repeat rows, hold values, and interpolate.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

struct Sampling {
  std::vector<std::size_t> rows;  // the rows that count, rising
  std::size_t end;                // after the last row of the record
  std::size_t repeated;           // rows equal to the preceding row
  // rows with the force of the preceding row and a new displacement
  std::size_t held;
  std::size_t interpolated;  // rows interpolated between readings
  // rows far before and after the load, omitted from a long record
  std::size_t unloaded;
  std::size_t stride;  // of the other rows, every stride-th counts
  // rows omitted because the stage was stationary (no_readings.h)
  std::size_t at_rest = 0;
  std::size_t last_at_rest = 0;      // the last of these rows
  std::vector<std::size_t> halts{};  // the row before each stop, rising
  std::size_t spikes = 0;            // invalid readings that were omitted (no_readings.h)

  // The points of [first, last), counted from first, after which the stage stops (find_drops).
  std::vector<std::size_t> halts_between(std::size_t first, std::size_t last) const;

  // The same among the points at these places in `rows`, counted from the first of them.
  std::vector<std::size_t> halts_among(std::span<const std::size_t> points) const;

  // Omits rows at which the stage is stationary, given by their indices in `rows`, rising.
  void leave_out_at_rest(const std::vector<std::size_t>& points);
};

// The rows to evaluate: at most max_rows.
// Domain:     columns of equal length; max_rows >= 1.
// Method:     repeated rows never count. Held rows do not count if two conditions hold: they are a
//             quarter of the rows above a twentieth of the maximum force, and the median change of
//             the force exceeds four steps. (A coarse converter repeats values that are real.)
//             Interpolated: the exactly straight triples of rows outnumber those that bend by up to
//             one step by a tenth of the rows. The other triples must bend by more than four steps
//             in the median. Then only the rows where the record bends count, if they are at least
//             a hundred.
//             Above max_rows, rows with a stationary stage are omitted. Of the rows before and
//             after the load only the nearest count, up to a tenth of max_rows each. Of the rest,
//             every stride-th row counts, and the maximum force.
Sampling sampling_of(std::span<const double> displacement, std::span<const double> force, std::size_t max_rows);

}  // namespace flexslip
