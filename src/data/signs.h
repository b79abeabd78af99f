// Which way a testing machine counts: compression is negative in many an export, of the force, the displacement or both.
#pragma once

#include <span>

namespace flexslip {

struct Signs {
  int displacement, force;  // 1: as a bending test counts, both positive in loading; -1: the other way
};

// The signs of a record, read off it as a whole.
// Domain: columns of one length, finite, in any units; std::invalid_argument for different lengths.
// Fails:  never: columns that do not change are taken as they are.
// Method: a specimen between its supports only pushes back, so that the force of greatest magnitude is one of compression. The
//         displacement advances from the least force before that one to it; after it, if the record begins with the greatest.
//         Wrong for a record whose force is tared by more than it rises.
Signs find_signs(std::span<const double> displacement, std::span<const double> force);

}  // namespace flexslip
