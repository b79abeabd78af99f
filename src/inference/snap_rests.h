// The ends of the snaps of a record: at the nearest stable state, from which the specimen slides on
// at once, or beyond it, where it sticks until its mobilised friction reaches μ again (theory.md,
// "Where a snap comes to rest").
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

// The inverted readings of a loading.
struct InvertedReadings {
  std::span<const double> stage, force, S;  // [L], [EI/L^2], [L]
  std::span<const double> advance;          // [L] of S since the previous reading, for constant friction
  std::span<const double> noise;            // [L] of S
};

struct StuckReadings {
  std::size_t first, beyond;  // the reading where a snap ended, and the first that slides again
};

struct SnapRests {
  double log_evidence;  // of overshooting snaps against snaps that end at the nearest stable state; approximate
  std::vector<StuckReadings> stuck;  // after each snap, if they overshoot
};

// Domain:     a step of S is a jump if it exceeds the sum of jump_advances advances and jump_noise
//             errors of a length.
// Method:     The first half of each rise is fitted twice, with a length that is first constant and
//             then grows, and with one that grows at once, initially at half of its later rate or
//             faster.
SnapRests rests_of_snaps(const InvertedReadings& readings, double jump_advances, double jump_noise);

}  // namespace flexslip
