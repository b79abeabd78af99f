// Where a specimen gave way.
#pragma once

#include <cstddef>

#include "data/record.h"

namespace flexslip {

enum class FailureStatus {
  found,
  none,  // the specimen survived: points = all points
};

struct Failure {
  FailureStatus status;
  std::size_t points;  // before the specimen broke: the last of them is point points - 1
  std::size_t fallen;  // the point at which the first fall of the failure has ended; all points of one that survived
};

// A specimen has broken when the force, while the stage runs forwards, drops below half its maximum for good, and does so by a fall and not by a
// decline: it loses a twentieth of the maximum within 1.5 % of the stage's travel up to it, over however many points, and either half as much again as it
// lost at once before or nearly all. Bent beyond its greatest force, one that slips falls below the half by a slip like others.
// So has one whose record ends with a fall of a tenth or more, four times what it lost at once before; and one whose stage turns back upon such a fall, if
// the force is then found below half its maximum within 1.5 % of the travel: a specimen that bears more has not broken.
// Breaks come in steps: one that is never made good belongs to the failure if it lies within 7 % of the travel before the next and loses a sixth of the
// maximum at once, or a twentieth and four times what any before it lost.
// Fails:  none, also where the force only declines smoothly, as that of a very flexible fibre does.
// Method: falls are told from noise as turning points of the force farther apart than it; the figures are chosen on 26 tests of spicules, of which
//         docs/validation.md shows the outcome. How often the force is read does not matter (tests/data/failure_test.cpp).
Failure find_failure(const Record& record);

}  // namespace flexslip
