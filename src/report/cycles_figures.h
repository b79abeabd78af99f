// Load-unload-reload tests, drawn.
#pragma once

#include "case/fitted.h"
#include "report/plot.h"

namespace flexslip {

// Are there loops to draw?
bool has_loops(const FittedTest& test);

// For both: Domain: has_loops.

// Force against deflection, there and back, and the forces of one friction profile for all loops.
Plot loops_figure(const FittedTest& test);

// The loops as boxes in length and mobilised friction, and the friction of both directions on one axis, loop by loop: the first four of them.
Plot boxes_figure(const FittedTest& test);

}  // namespace flexslip
