// The curves of a specimen and its friction as a picture shows them: fine enough for every wave and every knot of the friction.
#pragma once

#include <span>
#include <vector>

#include "bending_test/equilibrium.h"
#include "bending_test/history.h"
#include "bending_test/rig.h"

namespace flexslip {

// The specimen by itself, up to a length (Figs. 7 and 8A).
struct EquilibriumPortrait {
  std::vector<EquilibriumPoint> in, out;        // q = μ and q = -μ
  std::vector<EquilibriumPoint> frictionless;   // q = 0
  std::vector<EquilibriumPoint> at_one_length;  // with every friction it may have, seven tenths of the way
};

// Domain: S_max > 1.
EquilibriumPortrait portrait_of(const Friction& friction, const Fibre& fibre, double S_max);

// The curves on which the specimen slides in a test, as far as it goes.
struct SlidingLimits {
  std::vector<EquilibriumPoint> in, out;  // none out of a friction that depends on where the specimen turns back
};
SlidingLimits limits_of(const BendingTest& test, const History& history);

// The overall equilibria at some stage positions [L] on the curve on which the specimen slides in (Fig. 8B).
// Domain: at least one stage position, each as overall_equilibria.
struct OverallPortrait {
  std::vector<EquilibriumPoint> in;
  std::vector<std::vector<OverallEquilibrium>> at_stage;
};
OverallPortrait overall_portrait(const Friction& friction, const Rig& rig, std::span<const double> stages);

// The curve without friction, from the straight fibre on: (0, 0), and sliding_up_to, whose domain it has.
std::vector<EquilibriumPoint> frictionless_up_to(double deflection, int n, const Fibre& fibre = {});

}  // namespace flexslip
