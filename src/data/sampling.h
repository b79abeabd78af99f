// Which rows of a record say something new: loggers repeat rows, hold values, and interpolate between readings.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

struct Sampling {
  std::vector<std::size_t> rows;  // those that count, rising; the first row of the record is one
  std::size_t repeated;           // rows that say what the row before says
  std::size_t held;               // rows whose force is that of the row before, while the displacement has moved on
  std::size_t interpolated;       // rows between readings
  std::size_t stride;             // of the rest one in so many counts
};

// Domain:     columns of one length; most >= 1: no more rows count.
// Method:     Repeated rows never count. Held ones do not where they are a quarter of the rows above a twentieth of the greatest force, and
//             forces change by more than four times their least change: a coarse converter repeats values, too, and means them. A
//             record of which a tenth goes straight on from row to row, to 1e-7 of the greatest force, is interpolated: the rows at which
//             it bends count, if they are a hundred.
Sampling sampling_of(std::span<const double> displacement, std::span<const double> force, std::size_t most);

}  // namespace flexslip
