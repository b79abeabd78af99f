// What the force loses while the stage rests: the specimen relaxes, or its rig.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "numerics/statistics.h"

namespace flexslip {

// The stage stays at one place for rows [first, last].
struct StageRest {
  std::size_t first, last;
  double fall;   // [N] from the force of the first row to the mean of the last quarter
  double force;  // [N] that the specimen carries there, from its own zero
};

struct Relaxation {
  std::size_t rests, rows;  // of the rows, those after the first of each rest
  Estimate share;           // [1] of the force, lost in all rests together
  double over_loading;      // [1] of the force, lost in the whole loading at the same rate
};

// The rests of a record, as find_halts tells them; `force` is that of the column.
// Domain:     columns of one length, the displacement in any unit.
std::vector<StageRest> find_rests(const std::vector<double>& displacement, std::span<const double> force);

// Domain:     a loading of so many rows, taken at a constant rate; noise [N] >= 0 of one force.
// Fails:      nothing where the falls are less than three of their standard errors, or no rest carries a force.
// Max error:  a loading loses 0.5 to 2.2 times over_loading in nine of ten cases, for a standard linear solid as slow as 5 to 50 % of the record and
//             for relaxation with the logarithm of time (bench/relaxation.py).
// Method:     a force falls in proportion to itself and to time.
std::optional<Relaxation> relaxation_at(const std::vector<StageRest>& rests, std::size_t rows_of_loading, double noise);

}  // namespace flexslip
