// A surface as a rounded edge sees it that is drawn over it: a circle that rolls on the profile does not reach into valleys narrower than itself.
#pragma once

#include <span>
#include <vector>

namespace flexslip {

// [L] Where the lowest point of the circle lies at each place of a trace: the dilation by the disk, max_j z_j + √(r² - (s_i - s_j)²) - r. What a support
// of that radius climbs when it stands at that place.
// Domain:     step > 0, radius >= 0; std::invalid_argument otherwise. Radius 0, and one below the step: the heights themselves.
// Max error:  rounding. The circle touches samples, no lines between them.
// Cost:       O(n log n): which sample is touched never falls along the trace.
std::vector<double> path_of_edge(std::span<const double> height, double step, double radius);

// [L] The envelope: the highest surface that the circle can be rolled over as it is over the heights (morphological closing, ISO 16610-41), the
// erosion of that path. On it lie the samples that are touched; between them its arcs bridge the valleys.
// Domain, cost: likewise.
std::vector<double> envelope(std::span<const double> height, double step, double radius);

}  // namespace flexslip
