// What a bending standard reads off a specimen that stands on fixed supports with friction, over what is so: its formulas know of neither.
#pragma once

#include <optional>

#include "fibre/fibre.h"

namespace flexslip {

// [L] Deflections of one loading from the straight specimen on: those between which a modulus is told, and the greatest.
struct LoadingRead {
  double from, to;
  double greatest;
};

// What is read off is so many times what is so; and what friction took of the work up to the greatest deflection.
struct StandardReading {
  double modulus;  // [1] of F L^3/(48 I δ) between two deflections
  double stress;   // [1] of F L h/(8 I) at the greatest deflection, as bending has it at midspan
  double work;     // [1] share of ∫ F dw
};

// With a friction that is the same all along the specimen. Of one with a thickness the surface slides outwards first and bends the axis by a couple; drawn in,
// friction pulls at the axis: both make it stiffer.
// Domain:     0 <= friction <= fibre.max_friction(); 0 <= from < to <= greatest, 1e-6 <= greatest; std::invalid_argument otherwise.
// Max error:  1e-9, of a modulus times to/(to - from).
// Limit:      hardly bent, with τ = h/2L: 1/(1 - 3 μ τ), 1/(1 - 2 μ τ) and 3 μ τ (1 - 4 μ τ)/(1 - 3 μ τ) (docs/bending-standards.md).
// Fails:      none beyond deflections that the map has, or where the specimen slips through its supports.
// Cost:       some ms for a new fibre, of its tables; then 50 µs.
std::optional<StandardReading> standard_reading(const Fibre& fibre, double friction, const LoadingRead& read);

}  // namespace flexslip
