// Figures of a simulated test.
#pragma once

#include <span>
#include <vector>

#include "case/simulated_test.h"
#include "report/figure.h"

namespace flexslip {

// For all: Domain: a test that was followed.

// As measured_figure; of a stage in steps also between its readings.
Figure simulated_figure(const SimulatedTest& test, const std::vector<Crack>& cracks);

// As overall_equilibria_figure.
Figure equilibria_figure(const SimulatedTest& test, std::span<const double> stages);

}  // namespace flexslip
