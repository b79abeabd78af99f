// What a record shows of how it was taken, and of its drops, without mechanics: statistics from which findings are read (finding/findings.cpp).
#pragma once

#include <cstddef>
#include <vector>

#include "data/drops.h"
#include "data/record.h"
#include "data/rounded_drops.h"
#include "numerics/elementary.h"

namespace flexslip {

// The farthest that the stage moves from one row to the next.
struct WidestStep {
  std::size_t behind = 0;      // point before it
  double length = 0;           // [m]
  double usual = 0;            // [m] median of all steps
  double share_of_travel = 0;  // [1] of the way from the first point to the last
};

// The farthest that the force, of medians of five rows, falls below what it was before, drops apart; it may rise again.
struct Sinking {
  std::size_t from = 0;  // point at which it begins to fall
  double share = 0;  // [1] of the greatest force; 0 of a record of fewer than 20 points, or without a force above zero
};

// What changes in drops beyond what changed in the rows before them. A load train of a stiffness k gives back (fall of the force)/k, which bends
// the specimen farther while the stage moves on evenly.
struct TrainInDrops {
  std::size_t drops = 0;  // that tell: with a row since the drop before, and a force that falls beyond its course
  std::size_t misfits =
      0;  // in which what the specimen bends farther is off by more than half of fall/k, and by more than the stage moves meanwhile
  double compliance = 0;  // [m/N] median of (what the specimen bends farther)/fall
  double leap =
      0;  // [1] what the stage leaps ahead, in parts of fall/k: 0 of a stage, 1 of a deflection that was taken for one
  double leap_error = not_a_number;  // [1] standard error, of two drops or more
};

struct RecordStatistics {
  RoundedDrops rounded{};
  double rows_between_drops =
      not_a_number;  // median number of rows from one drop to the next; NaN of fewer than three drops
  WidestStep widest_step{};
  Sinking sinking{};
  TrainInDrops train{};
};

// Domain:     a record without faults (check_record); drops of it, in order; load_train_stiffness [N/m] > 0, may be infinite: then leap is not valid.
RecordStatistics statistics_of(const Record& record, const std::vector<Drop>& drops, double load_train_stiffness);

}  // namespace flexslip
