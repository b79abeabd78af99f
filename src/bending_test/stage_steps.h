// A stage that moves in steps.
#pragma once

#include <span>
#include <vector>

namespace flexslip {

// The stage positions of a programme that is moved through in steps: each turning point, and between two of them every step from the one
// before; the last may be shorter.
// Units:      any, of turns and step alike.
// Domain:     at least one turn; step > 0, and not so small that the positions fill the memory: std::invalid_argument otherwise.
std::vector<double> stage_steps(std::span<const double> turns, double step);

}  // namespace flexslip
