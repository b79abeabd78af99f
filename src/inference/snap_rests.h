// Where the snaps of a record came to rest: at the nearest stable state, from where the fibre slides on at once, or beyond it, where it sticks until
// its mobilised friction has grown to μ again (theory.md, "Where a snap comes to rest").
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

// Readings of a loading, as inverted.
struct InvertedReadings {
  std::span<const double> stage, force, S;  // [L], [EI/L^2], [L]
  std::span<const double> advance;          // [L] of S since the reading before, were friction constant
  std::span<const double> noise;            // [L] of S
};

struct StuckReadings {
  std::size_t first, beyond;  // of them: where a snap landed, and the first that slides again
};

struct SnapRests {
  double log_evidence;  // of snaps that overshoot over such as rest at the nearest stable state: a first look
  std::vector<StuckReadings> stuck;  // after each snap, if they overshoot
};

// Domain:     a step of S is a jump if it exceeds so many advances and so many errors of a length together.
// Method:     The first half of each rise is fitted twice, by a length that is constant and then grows, and by one that grows at once, at first at
//             half of its later rate or faster.
SnapRests rests_of_snaps(const InvertedReadings& readings, double jump_advances, double jump_noise);

}  // namespace flexslip
