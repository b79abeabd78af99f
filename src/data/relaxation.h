// The force lost while the stage is stationary, because the specimen or the rig relaxes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "numerics/statistics.h"

namespace flexslip {

// The rows [first, last] with the stage at one position.
struct StageRest {
  std::size_t first, last;
  double fall;   // [N] force of the first row minus mean of the last quarter
  double force;  // [N] force on the specimen, corrected for the zero
};

struct Relaxation {
  std::size_t rests, rows;  // `rows` excludes the first row of each rest
  Estimate share;           // [1] relative loss of force in all rests together
  double over_loading;      // [1] relative loss during the whole loading at the same rate
};

// The rests of a record, found by find_halts; `force` is the force column.
// Domain:     columns of equal length, the displacement in any unit.
std::vector<StageRest> find_rests(const std::vector<double>& displacement, std::span<const double> force);

// The relaxation rate of a record.
// Domain:     a loading of rows_of_loading rows at a constant rate; noise [N] >= 0 of one force
//             reading.
// Fails:      empty if the losses are below three standard errors, or if no rest carries a force.
// Max error:  in nine of ten cases the loading loses 0.5 to 2.2 times over_loading. This holds for
//             a standard linear solid with a time constant of 5 to 50 % of the record, and for
//             logarithmic relaxation (bench/relaxation.py).
// Method:     the loss is proportional to the force and to time.
std::optional<Relaxation> relaxation_at(const std::vector<StageRest>& rests, std::size_t rows_of_loading, double noise);

}  // namespace flexslip
