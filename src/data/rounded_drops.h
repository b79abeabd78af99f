// Drops that are smoothed by a slow load cell (a causal low-pass) or by a symmetric filter.
#pragma once

#include <cstddef>

#include "data/record.h"

namespace flexslip {

struct RoundedDrops {
  std::size_t drops;  // number of usable drops
  // [rows] Time constant of the equivalent low-pass; 0 if drops are sharp, or too few are usable.
  double lag;
  // [rows] Half width of the equivalent symmetric filter; 0 if below two, or if too few drops are
  // usable.
  double spread;
};

// The smoothing of the drops of a record.
// Domain:     one loading without faults (check_record).
// Max error:  of 30 simulated records each at a lag of 0, 1 and 2 rows, at most 1, at least 10 and
//             at least 20 are detected. The mean lag is right to 40 % (tests/data). The limits are
//             empirical.
// Method:     the statistics use every step that falls more than five standard deviations below the
//             smooth trend and is deeper than its neighbours.
//             Low-pass: the force continues to fall after a drop. (With friction alone it falls
//             slowly before a snap and rises after it.) The statistic is the fall of the two steps
//             after minus the two before, over the drop, for all drops together. It must exceed a
//             tenth by 1.3 + 1/drops of its error, with three drops or more. The lag is the one
//             that explains it for a snap at a random time between two rows.
//             Symmetric filter: each adjacent step falls by more than a third of the drop, by twice
//             the error, and both about equally. Slowly decreasing friction can look the same but
//             leaves the noise white. The force must therefore also vary less from row to row than
//             over three rows.
RoundedDrops rounded_drops(const Record& record);

}  // namespace flexslip
