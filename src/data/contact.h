// Where a loading curve begins.
#pragma once

#include <cstddef>

#include "data/estimate.h"
#include "data/record.h"

namespace flexslip {

enum class ContactStatus {
  found,
  too_few_points,  // fewer than 5 in the range of force looked at: nothing else is valid
  not_rising,      // the force does not rise there: nothing else is valid
};

struct Contact {
  ContactStatus status;
  Estimate offset;            // [m] stage position, and so deflection, at which the contact begins
  Estimate slope;             // [N/m] initial dF/dw0, the stiffness of the specimen
  std::size_t points_before;  // points whose stage lies before the contact
  std::size_t first, last;    // points [first, last) the line was drawn through
  bool settles;               // the curve bends where it begins: the line is drawn through what comes above
};

// The straight beginning of a loading curve, force = slope (deflection - offset), between 0.02 and 0.15 of the maximum force: below, the
// contact may still be settling; above, curves of large deflection are no longer straight.
// Method: force and deflection are both regressed on the stage, which is imposed and so free of their noise; the slope is the
//         ratio. Standard errors allow for residuals correlated from point to point (AR(1)). Where the upper half of the range meets
//         zero force later than the lower one, by four standard errors, the contact settles: the line is then that of the upper
//         half and of as much above the range, and how far the result moves by that is part of its error.
Contact find_contact(const Record& record);

}  // namespace flexslip
