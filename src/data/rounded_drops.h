// Drops that a force follows too slowly, as a low-pass of the load cell or a loop of the machine rounds them off; or that a filter has spread to both sides.
#pragma once

#include <cstddef>

#include "data/record.h"

namespace flexslip {

struct RoundedDrops {
  std::size_t drops;  // told by so many
  // [rows] Time constant of the low-pass that would round them so; 0: they are not rounded, or too few tell.
  double lag;
  double
      spread;  // [rows] over which a filter that looks both ways has spread a drop; 0: over less than two, or too few tell
};

// Domain:     one loading without faults (check_record).
// Method:     Where friction makes the force fall slowly it does so before a snap; after it the force rises. Behind a low-pass it falls on. Of the steps that fall by
//             more than five standard deviations below the smooth curve, the deepest of its neighbours each: how much more the two after it fall
//             than the two before, over its own fall, all of them together. Rounded, if that is above a tenth by 1.3 + 1/drops of its error, of
//             three drops or more. The lag is that of which a snap at any time between two rows gives as much.
//             Behind a filter that looks both ways it falls on before and after it: spread, if that is above a third of its own fall in the step to
//             either side, by twice its error, and about as much on both. Friction that decreases slowly can make a fall as gentle,
//             but leaves the noise white: the force must also differ less from row to row, beside what it does over three.
// Accuracy:   of 30 simulated records each at a lag of 0, 1 and 2 rows at most 1, at least 10 and at least 20 are told, their mean lag to 40 %
//             (tests/data). The bounds are empirical.
RoundedDrops rounded_drops(const Record& record);

}  // namespace flexslip
