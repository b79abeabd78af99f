// Statistics of the sampling and the drops of a record, without mechanics. Findings use them
// (finding/findings.cpp).
#pragma once

#include <cstddef>
#include <vector>

#include "data/drops.h"
#include "data/record.h"
#include "data/rounded_drops.h"
#include "numerics/elementary.h"

namespace flexslip {

// The largest movement of the stage between successive rows.
struct WidestStep {
  std::size_t behind = 0;      // the point before it
  double length = 0;           // [m]
  double usual = 0;            // [m] median step
  double share_of_travel = 0;  // [1] of the distance between the first and the last point
};

// The largest decrease of the force, drops excluded. The force is smoothed by medians of five rows
// and may recover.
struct Sinking {
  std::size_t from = 0;  // the point at which the decrease begins
  // [1] of the maximum force; 0 with fewer than 20 points or without a positive force
  double share = 0;
};

// The changes during drops, beyond the trend of the rows before them. A load train of stiffness k
// recovers (force drop)/k, which bends the specimen while the stage moves uniformly.
struct TrainInDrops {
  // usable drops: with a row after the preceding drop, and a force that drops below its trend
  std::size_t drops = 0;
  std::size_t misfits =
      // Drops whose change of deflection differs from drop/k by more than half of it and by more
      // than the stage movement.
      0;
  double compliance = 0;  // [m/N] median of (change of deflection)/drop
  double leap =
      // [1] Advance of the stage, relative to drop/k: 0 for a stage, 1 for a deflection mistaken
      // for a stage.
      0;
  double leap_error = not_a_number;  // [1] standard error, with two or more drops
};

struct RecordStatistics {
  RoundedDrops rounded{};
  // Median number of rows between drops; NaN with fewer than three drops.
  double rows_between_drops = not_a_number;
  WidestStep widest_step{};
  Sinking sinking{};
  TrainInDrops train{};
};

// Domain:     a record without faults (check_record); its drops, in order; load_train_stiffness
//             [N/m] > 0. If that is infinite, leap is invalid.
RecordStatistics statistics_of(const Record& record, const std::vector<Drop>& drops, double load_train_stiffness);

}  // namespace flexslip
