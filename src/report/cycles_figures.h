// Load-unload-reload tests, drawn.
#pragma once

#include "case/fitted.h"
#include "report/figure.h"

namespace flexslip {

// Loops that have a panel of their own in boxes_figure: the first ones.
inline constexpr std::size_t most_drawn_loops = 4;

// Are there loops to draw?
bool has_loops(const FittedTest& test);

// For all: Domain: has_loops.

// Force against deflection, there and back, and the forces of one friction profile for all loops.
Figure loops_figure(const FittedTest& test);

// The loops as boxes in length and mobilised friction, and the friction of both directions on one axis, loop by loop.
Figure boxes_figure(const FittedTest& test);

}  // namespace flexslip
