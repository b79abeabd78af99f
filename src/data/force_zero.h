// What a load cell shows before it carries anything: the zero of the force, from the rows before the contact.
#pragma once

#include <cstddef>
#include <span>

namespace flexslip {

enum class ForceZeroStatus {
  found,
  no_free_rows,  // the record begins in contact, or too few rows before it can be told from it
};

struct ForceZero {
  ForceZeroStatus status;
  double offset;       // [N] mean of the rows; 0 unless found
  double error;        // [N] its standard error; 0 unless found
  std::size_t points;  // the first of the record, that the mean is of
};

// The mean force before the specimen is touched.
// Domain: columns of one length, displacement rising but for noise, finite; noise [N] of one force reading, at least 0;
//         std::invalid_argument otherwise.
// Method: the force is level up to the last of the first rows that stay within 4 noise of their running mean; a specimen in
//         contact from the first row on would leave that band much earlier. The mean is of the first half of that way, which
//         keeps the toe, where the contact settles, out of it. Its error allows for drift from row to row (AR(1)).
ForceZero find_force_zero(std::span<const double> displacement, std::span<const double> force, double noise);

// Is an offset more than its error makes likely, four times as much?
bool is_significant(const ForceZero& zero);

}  // namespace flexslip
