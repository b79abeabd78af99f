// Detection of force drops: sudden decreases that neither noise nor the smooth trend of the curve
// explains.
#pragma once

#include <cstddef>
#include <vector>

#include "data/record.h"

namespace flexslip {

struct DropOptions {
  // [1] expected number of false drops in a test of this length without slips, see find_drops
  double false_alarms_per_test = 0.1;
  // Points after which the stage stops, rising. A change of force during a stop is not a drop.
  std::vector<std::size_t> halts{};
};

struct Drop {
  std::size_t before;  // last point before the drop
  // first point after the drop: before + 1, or later if the drop takes several steps
  std::size_t after;
  double force_fall;  // [N] force[before] - force[after] > 0
  double advance;     // [m] deflection[after] - deflection[before]
  // [1] fall minus the fall of the smooth curve, over the standard deviation of the noise; of the
  // steepest part
  double significance;
};

enum class DropStatus {
  ok,         // all fields are valid, also without drops
  too_short,  // fewer than 30 points, too few to determine the noise; the other fields are invalid
};

struct Drops {
  DropStatus status;
  std::vector<Drop> drops;  // in the order of the record, not overlapping
  // Falls with too many steps for a snap: sliding on decreasing friction, yielding, or relaxation.
  // Ordered as drops are.
  std::vector<Drop> slow_falls;
  double smallest_fall;  // [N] a smaller fall in one step counts as noise
};

// The drops of a record. First remove the points after failure (find_failure).
//
// False alarms: on a smooth curve with Gaussian noise of the measured size, at most
// false_alarms_per_test drops are found on average. The noise may be autocorrelated. The number is
// close to the limit where the curve falls and smaller where it rises, because noise must first
// cancel the rise. tests/data/drops_test.cpp asserts this on simulated tests.
// Real tests are irregular, with heavier tails, partly due to slip. At a stated 0.1, resampled
// quiet parts of published tests give about 0.3 false alarms on a curve like theirs. On a curve
// that falls for two thirds of the test they give 1.6. A smooth fall is taken for drops if its
// slope changes by much more than the noise within 20 points, as just before a specimen slips
// through.
//
// Domain:     a record without faults (check_record); false_alarms_per_test > 0;
//             std::invalid_argument otherwise.
// Fails:      too_short.
// Method:     for one to three successive falling steps from i to j (a longer drop is found by its
//             steepest part)
//                 x = (min(0, smooth fall) - (F_j - F_i)) / noise over j - i steps,
//             with smooth_steps and StepNoise of record.h. The expected number of false alarms is
//             the tail of Student's t at x (the noise is an estimate) times the number of intervals
//             tested. A drop must also exceed 2.5 resolution steps, because a coarse resolution
//             hides the noise from StepNoise. Of overlapping intervals the most significant is
//             kept; adjacent intervals form one drop. A snap is vertical: one step takes six tenths
//             of its fall, or two adjacent steps three quarters; any other fall is a slow fall. The
//             noise is absolute, so the same falls are required near contact as elsewhere. The
//             slope -k_c in (w0, F) is no criterion: F = k_c (w_s - w0) holds for every step, slip
//             or noise.
Drops find_drops(const Record& record, const DropOptions& options = {});

}  // namespace flexslip
