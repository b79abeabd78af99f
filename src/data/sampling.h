// Which rows of a record say something new: loggers repeat rows, hold values, and interpolate between readings.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

struct Sampling {
  std::vector<std::size_t> rows;     // those that count, rising
  std::size_t end;                   // after the last row of the record
  std::size_t repeated;              // rows that say what the row before says
  std::size_t held;                  // rows whose force is that of the row before, while the displacement has moved on
  std::size_t interpolated;          // rows between readings
  std::size_t unloaded;              // rows far before and after the load, of a record with too many
  std::size_t stride;                // of the rest one in so many counts
  std::size_t at_rest = 0;           // read while the stage halted, left out by whoever looked for them (no_readings.h)
  std::size_t last_at_rest = 0;      // the last of those rows
  std::vector<std::size_t> halts{};  // the row before each halt, rising
  std::size_t spikes = 0;            // readings that are none (no_readings.h), left out by whoever looked for them

  // Of the points [first, last), counted from first, those after which the stage halted (find_drops).
  std::vector<std::size_t> halts_between(std::size_t first, std::size_t last) const;

  // Leaves out rows at rest, given by their places among the rows that count, rising.
  void leave_out_at_rest(const std::vector<std::size_t>& points);
};

// Domain:     columns of one length; most >= 1: no more rows count.
// Method:     Repeated rows never count. Held rows do not count if they are a quarter of the rows above a twentieth of the greatest force, and
//             the median change of the force is more than four of its steps: a coarse converter repeats values, too, and means them.
//             A record is interpolated if exactly straight triples of rows exceed the triples that bend by up to one step of the force
//             by a tenth of the rows, and the other triples bend by more than four steps in the median. Only the rows where such a
//             record bends count, if they are a hundred. Where more than `most` rows are left, rows at rest do not count. Of the rows
//             before and after the load the nearest count, up to a tenth of `most` each. Of the rest, one row in so many counts, and
//             the greatest force.
Sampling sampling_of(std::span<const double> displacement, std::span<const double> force, std::size_t most);

}  // namespace flexslip
