// The loss of stiffness between two loadings of a record, from their forces at the same
// deflections. Reduced variables of the nominal EI.
#pragma once

#include <optional>
#include <vector>

#include "data/record.h"
#include "inference/passes.h"
#include "numerics/statistics.h"

namespace flexslip {

struct LoadingForces {
  bool is_followed;    // the other loading comes after the evaluated one
  Estimate loss;       // [1] share of the stiffness lost between the two loadings
  double loss_needed;  // [1] required by the drops of the evaluated loading as cracks only; 0 unless is_followed
};

// Compares the evaluated loading with the last one after it, or else the first loading with the
// evaluated one. Rows left out do not slide. Loss, settling, contact and wear change the force in
// different ways along the deflection.
// Max error:  a quarter of the loss and PassesOptions::of_forces, in addition to the error of the
//             fit.
// Fails:      empty without two loadings to the same deflections, if their forces scatter by a
//             tenth about the fit, or if the four effects cannot be distinguished.
std::optional<LoadingForces> compare_loading_forces(const PassesProblem& problem, const std::vector<Leg>& legs,
                                                    const std::vector<char>& left_out);

}  // namespace flexslip
