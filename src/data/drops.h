// Drops of the force in a loading test: sudden falls that neither the noise nor the smooth course of the curve explains.
#pragma once

#include <cstddef>
#include <vector>

#include "data/record.h"

namespace flexslip {

struct DropOptions {
  // [1] drops to be expected in a test of this length without slips, see find_drops
  double false_alarms_per_test = 0.1;
  // Points after which the stage halted, rising: what the force did meanwhile is no drop.
  std::vector<std::size_t> halts{};
};

struct Drop {
  std::size_t before;  // point before the drop
  std::size_t after;   // point after it: before + 1, unless the drop took several steps
  double force_fall;   // [N] force[before] - force[after] > 0
  double advance;      // [m] deflection[after] - deflection[before]
  double
      significance;  // [1] fall beyond that of the smooth curve, in standard deviations of the noise; of the steepest part
};

enum class DropStatus {
  ok,         // all fields are valid; no drops is an answer
  too_short,  // fewer than 30 points: the noise cannot be told; nothing else is valid
};

struct Drops {
  DropStatus status;
  std::vector<Drop> drops;  // in the order of the record, not overlapping
  std::vector<Drop>
      slow_falls;  // likewise, those that take too many steps for a snap: sliding on falling friction, yielding, or relaxation at rest
  double smallest_fall;  // [N] a fall in one step smaller than this counts as noise
};

// The drops of a record. Take off what follows the failure first (find_failure).
//
// What the rate means: on a smooth curve, rising or falling, whose force carries Gaussian noise of the level measured (independent
// or correlated from point to point), at most false_alarms_per_test drops are found on average: about that many where the curve
// falls, fewer where it rises, as there noise must first undo the rise. tests/data/drops_test.cpp asserts it on simulated tests.
// What it does not promise: the irregularity of real tests has heavier tails, and some of that is slip. Resampled from the quiet
// parts of the authors' tests it gives, at a stated 0.1, about 0.3 false alarms on a curve like theirs, and 1.6 on one that
// falls for two thirds of the test. A smooth fall so steep that its slope changes by much more than the noise within 20 points
// (a fibre about to snap through) is taken for drops.
//
// Domain: a record without faults (check_record); 0 < false_alarms_per_test; std::invalid_argument otherwise.
// Fails:  too_short.
// Method: over one to three successive falling steps from i to j (a longer drop is found by its steepest part)
//             x = (min(0, smooth fall) - (F_j - F_i)) / noise over j - i steps,
//         with smooth_steps and StepNoise of record.h. The tail of Student's t (the noise is itself an estimate) at x, times the
//         number of stretches looked at, is the number of false alarms to be expected; it must not exceed that allowed.
//         A fall is beyond 2.5 steps of the resolution, too, which hides noise from StepNoise.
//         Of overlapping stretches the most significant counts; stretches that touch are one drop. A snap is vertical: one step takes six
//         tenths of its fall, or two steps beside each other three quarters; what falls more slowly is a slow fall.
//         Noise is absolute, so low force needs nothing special: near contact, where the force is hardly more than noise, the
//         same falls are required as anywhere else. That a drop runs along slope -k_c in (w0, F) is used nowhere: F = k_c (w_s -
//         w0) holds for every step, slip or noise, so it tells nothing.
Drops find_drops(const Record& record, const DropOptions& options = {});

}  // namespace flexslip
