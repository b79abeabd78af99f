// Drops that a force follows too slowly: a low-pass of the load cell, or a loop of the machine, rounds them off.
#pragma once

#include <cstddef>

#include "data/record.h"

namespace flexslip {

struct RoundedDrops {
  std::size_t drops;  // told by so many
  double
      lag;  // [rows] time constant of the low-pass that would round them so; 0: they are not rounded, or too few tell
};

// Domain:     one loading without faults (check_record).
// Method:     A specimen about to snap loses force before the snap, if at any time, and gains it after; what is rounded falls on. Of the steps that fall by
//             more than five standard deviations below the smooth curve, the deepest of its neighbours each: how much more the two after it fall
//             than the two before, over its own fall, all of them together. Rounded, if that is above a tenth by 1.3 + 1/drops of its error, of
//             three drops or more. The lag is that of which a snap at any time between two rows gives as much.
// Accuracy:   of 483 simulated records on rigs that do not lag 3 are called rounded; of those that lag by a row or two, half are.
RoundedDrops rounded_drops(const Record& record);

}  // namespace flexslip
