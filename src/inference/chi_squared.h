// The tail of the distribution that sums of squares are judged by.
#pragma once

#include <cstddef>

namespace flexslip {

// P(chi squared > x).
// Domain:     freedoms >= 1, x >= 0.
// Max error:  1e-12.
double chi_squared_beyond(double x, std::size_t freedoms);

}  // namespace flexslip
