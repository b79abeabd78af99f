// The stiffness lost between two loadings of a record, by their forces at the same deflections.
// Reduced variables of the nominal EI.
#pragma once

#include <optional>
#include <vector>

#include "data/record.h"
#include "inference/passes.h"
#include "numerics/statistics.h"

namespace flexslip {

struct LoadingForces {
  bool is_followed;  // the other loading comes after the evaluated one
  Estimate loss;     // [1] share of the stiffness lost from one to the other
  double
      loss_needed;  // [1] likewise, by the drops of the evaluated loading if they were cracks only; 0 unless it is followed
};

// The evaluated loading and the last after it, or else the first and the evaluated one. Rows that are left out show no sliding.
// The loss, what settled, the contact and the wear of friction act on the force each in its way along the deflection.
// Error:      a quarter of the loss, and PassesOptions::of_forces, besides that of the fit.
// Fails:      none of a record without two loadings that reach the same deflections, or whose forces scatter by a tenth about these four, or do not
//             tell them apart.
std::optional<LoadingForces> compare_loading_forces(const PassesProblem& problem, const std::vector<Leg>& legs,
                                                    const std::vector<char>& left_out);

}  // namespace flexslip
