// The bending stiffness of a specimen, as far as it is known without a fit.
#pragma once

#include "data/record.h"

namespace flexslip {

// Bending stiffness from the initial slope, F = 48 EI w/L^3.
struct StiffnessFromSlope {
  bool found = false;  // the record has a straight rising beginning; nothing else is valid without
  double value = 0;    // [N m^2] EI
  // [1] standard deviation: that of the slope, 3 % that friction and large deflection bend it, and 3 %
  double relative_error = 0;
};

// Domain:     stage and deflection counted from the contact; span [m] > 0.
// Method:     force over deflection by least squares, through the contact, over the points that find_contact looks at.
StiffnessFromSlope stiffness_from_slope(const Record& record, double span);

// The uncertainty of a bending stiffness that is stated without one [1]: a data sheet and a diameter to 0.5 % give no better.
inline constexpr double usual_stiffness_error = 0.03;

}  // namespace flexslip
