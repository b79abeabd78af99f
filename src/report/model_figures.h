// The figures of the model: what a specimen and a rig do with a given friction, as Figs. 7 and 8 of the paper.
#pragma once

#include <span>

#include "bending_test/history.h"
#include "bending_test/rig.h"
#include "contact/friction.h"
#include "contact/friction_law.h"
#include "data/legs.h"
#include "data/scales.h"
#include "report/figure.h"

namespace flexslip {

// In which units a model is drawn.
struct DrawnIn {
  Scales scales;
  bool reduced;
  bool in_inches = false;
};

// For all: Domain: S_max > 1.

// All equilibria of the specimen in three spaces: deflection and force, length and deflection, length and force (Fig. 7).
Figure region_figure(const Friction& friction, const Fibre& fibre, double S_max, const DrawnIn& units);

// The curve along which the specimen slides, with that of no friction and the Euler-Bernoulli line (Fig. 8A).
Figure equilibrium_figure(const Friction& friction, const Fibre& fibre, double S_max, const DrawnIn& units);

// What a test measures, its snaps dashed: over the equilibrium curve (Fig. 8C) if it only loads; otherwise its loops with their
// direction, beside the boxes that they are in length and mobilised friction. The history is one followed continuously.
Figure measured_figure(const BendingTest& test, const History& history, std::span<const Leg> legs,
                       const DrawnIn& units);

// The overall equilibria at some stage positions [L]: stable ones filled, unstable ones open, partially stable ones in red; load lines
// of the rig through them (Fig. 8B).
Figure overall_equilibria_figure(const Friction& friction, const Rig& rig, std::span<const double> stages,
                                 const DrawnIn& units);

}  // namespace flexslip
