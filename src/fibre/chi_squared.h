// The distribution that sums of squares are judged by: its tails and quantiles, with freedoms that need not be whole (of variances that are
// sums of unequal parts).
#pragma once

namespace flexslip {

// P(chi squared > x).
// Domain:     x >= 0, 0 < freedoms <= 1e7.
// Max error:  1e-12, and 1e-10 of the smaller of it and its complement.
double chi_squared_beyond(double x, double freedoms);

// x with P(chi squared < x) = probability.
// Domain:     1e-6 < probability < 1 - 1e-6, 1 <= freedoms <= 1e7; std::invalid_argument otherwise.
// Max error:  1e-9 relative.
double chi_squared_quantile(double probability, double freedoms);

}  // namespace flexslip
