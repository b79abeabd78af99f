// What a figure of an analysis shows beside the record: curves of the same specimen on the same rig. Reduced variables of the nominal bending
// stiffness.
#pragma once

#include <vector>

#include "bending_test/equilibrium.h"
#include "bending_test/history.h"
#include "inference/analysis.h"

namespace flexslip {

// Without friction up to the greatest deflection of the record or beyond, from the straight specimen on; at the bending stiffness of the fit, or,
// where there is no fit, that stated.
// Domain:     analysis.status is ok or not_explained.
std::vector<EquilibriumPoint> frictionless_curve(const TestAnalysis& analysis);

// The straight line of small deflections at that bending stiffness, [EI/L^2] at a deflection [L].
double euler_bernoulli_force(const TestAnalysis& analysis, double deflection);

// The mean of the fit run forward over all stage positions, not only those of the record.
// Domain:     analysis.status is ok.
History mean_run_forward(const TestAnalysis& analysis);

// The waves that the fit claims, about its mean and drift, over what has been drawn in.
struct FittedFriction {
  double S, mu;  // [L], [1]
};
// Domain:     analysis.status is ok. Empty if no wave is claimed.
std::vector<FittedFriction> claimed_waves(const TestAnalysis& analysis);

}  // namespace flexslip
