// The inverse of Ψ for arrays of states: which length and which mobilised friction belong to a deflection and a force.
//
// Reduced variables as in elastica.h. Each answer depends on its own state alone and is the same on every processor.
#pragma once

#include <span>
#include <vector>

namespace flexslip {

// Both NaN where no friction in [-20, 20] explains deflection and force.
struct InverseArrays {
  std::vector<double> S;  // [L]
  std::vector<double> q;  // [1]
};

// Domain:     arrays of one length; w >= 0 and F >= 0, finite; std::invalid_argument, naming the index, otherwise.
// Tolerance:  w and F are reproduced as fibre_state_from_force does.
// Method:     Newton's iteration in (σ, q) on the table (state_table.h), and a last step on the exact map. What does not get there is left to
//             fibre_state_from_force.
// Cost:       about 0.3 µs a state.
InverseArrays fibre_states_from_forces(std::span<const double> w, std::span<const double> F);

// Without the last step.
// Tolerance:  w and F are reproduced to twice the error of the table; beyond it as fibre_state_from_force does.
// Cost:       about 0.15 µs a state.
InverseArrays tabulated_states_from_forces(std::span<const double> w, std::span<const double> F);

}  // namespace flexslip
