// The point at which a specimen breaks.
#pragma once

#include <cstddef>

#include "data/record.h"

namespace flexslip {

enum class FailureStatus {
  found,
  none,  // the specimen did not break: points = all points
};

struct Failure {
  FailureStatus status;
  std::size_t points;  // number of points before the break
  // the point at which the first fall of the failure ends; without failure, the number of points
  std::size_t fallen;
};

// The failure of a specimen: a final drop of the force below half its maximum while the stage
// advances.
//
// The drop must be a fall, not a decline: the force loses a twentieth of the maximum within 1.5 %
// of the stage travel, and either 1.5 times the largest earlier loss or nearly all. (Beyond
// its maximum force, a specimen that slips falls below half by an ordinary slip.)
// A record that ends with a fall also fails if the fall is a tenth of the maximum or more and four
// times the largest earlier loss. If the stage reverses after such a fall, the force must then be
// below half its maximum within 1.5 % of the travel: a specimen that carries more has not broken.
// A break can take several falls. A fall that is never recovered belongs to the failure if it lies
// within 7 % of the travel before the next one. It must lose a sixth of the maximum at once, or a
// twentieth that is four times the largest earlier loss.
// The plies of a laminate can break one after another. No fall then takes half the maximum, but
// together they do. The failure is the first that is never recovered and four times the largest
// earlier loss.
// Fails:      none, also if the force only declines smoothly, as for a very flexible specimen.
// Method:     falls are turning points of the force farther apart than the noise, or separated by a
//             rest of 0.6 % of the travel. The limits were chosen on 26 tests of spicules
//             (docs/validation.md). The sampling rate does not matter (tests/data/failure_test.cpp).
Failure find_failure(const Record& record);

}  // namespace flexslip
