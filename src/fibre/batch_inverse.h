// The inverse of Ψ for arrays of states: the sliding length and mobilised friction for a deflection
// and a force.
//
// Reduced variables as in elastica.h. Each result depends on its own state alone and is the same on
// every processor.
#pragma once

#include <span>
#include <vector>

namespace flexslip {

// Both NaN if no friction in [-20, 20] explains deflection and force.
struct InverseArrays {
  std::vector<double> S;  // [L]
  std::vector<double> q;  // [1]
};

// Domain:     arrays of equal length; w >= 0 and F >= 0, finite; std::invalid_argument with the
//             index otherwise.
// Tolerance:  w and F are reproduced as by fibre_state_from_force.
// Method:     Newton's iteration in (σ, q) on the table (state_table.h), and a last step on the
//             exact map; fibre_state_from_force where this does not converge.
// Cost:       about 0.3 µs a state.
InverseArrays fibre_states_from_forces(std::span<const double> w, std::span<const double> F);

// The same without the last step.
// Tolerance:  w and F are reproduced to twice the error of the table; beyond the table as by
//             fibre_state_from_force.
// Cost:       about 0.15 µs a state.
InverseArrays tabulated_states_from_forces(std::span<const double> w, std::span<const double> F);

}  // namespace flexslip
