// The figures of the model: what a specimen and a rig do with a given friction, as Figs. 7 and 8 of the paper.
#pragma once

#include <span>
#include <vector>

#include "case/simulated_test.h"
#include "case/studies.h"
#include "report/plot.h"

namespace flexslip {

// All equilibria of the specimen in three spaces, if the study asks for the region: deflection and force, length and deflection, length and force
// (Fig. 7). Otherwise the curve along which it slides, with that of no friction and the Euler-Bernoulli line (Fig. 8A).
Plot equilibrium_figure(const EquilibriumStudy& study);

// For both: Domain: a test that was followed.

// What a test measures, its snaps dashed: over the equilibrium curve (Fig. 8C) if it only loads; otherwise its loops with their
// direction, beside the boxes that they are in length and mobilised friction.
Plot simulated_figure(const SimulatedTest& test, const std::vector<Crack>& cracks);

// The overall equilibria at some stage positions [L]: stable ones filled, unstable ones open, partially stable ones in red; load lines
// of the rig through them (Fig. 8B).
Plot equilibria_figure(const SimulatedTest& test, std::span<const double> stages);

}  // namespace flexslip
