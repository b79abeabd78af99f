// Statistics of order: medians, and sequences that do not fall.
#pragma once

#include <span>
#include <vector>

namespace flexslip {

// Of an even number of values the mean of the middle two; NaN of none.
double median_of(std::vector<double> values);

// The nearest non-falling sequence, in least squares.
// Method:     pool adjacent violators (Ayer et al. 1955).
std::vector<double> non_falling(std::span<const double> values);

// Each value, or the greatest before it, or 0: the positions of a stage whose readings jitter.
std::vector<double> advancing(std::span<const double> values);

}  // namespace flexslip
