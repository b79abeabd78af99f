// The effect of friction at fixed supports on the results of a bending standard, whose formulas
// assume no friction.
#pragma once

#include <optional>

#include "fibre/fibre.h"

namespace flexslip {

// [L] Deflections of a loading from the straight specimen: the range for the modulus, and the
// maximum.
struct LoadingRead {
  double from, to;
  double greatest;
};

// Ratios of the standard's results to the true values, and the friction share of the work up to the
// maximum deflection.
struct StandardReading {
  double modulus;  // [1] of F L^3/(48 I δ) between two deflections
  double stress;   // [1] of F L h/(8 I) at the maximum deflection, compared with bending at midspan
  double work;     // [1] share of ∫ F dw
};

// The ratios for a constant friction. With a thickness, the surface first slides outwards, and
// friction bends the axis by a couple. Later friction pulls at the axis. Both stiffen the specimen.
// Domain:     0 <= friction <= fibre.max_friction(); 0 <= from < to <= greatest, 1e-6 <= greatest;
//             std::invalid_argument otherwise.
// Max error:  1e-9; for the modulus times to/(to - from).
// Limit:      at small deflection, with τ = h/2L: 1/(1 - 3 μ τ), 1/(1 - 2 μ τ) and 3 μ τ (1 - 4 μ
//             τ)/(1 - 3 μ τ) (docs/bending-standards.md).
// Fails:      empty beyond the deflections of the map, or if the specimen slips through its
//             supports.
// Cost:       some ms to fill the tables of a new fibre; then 50 µs.
std::optional<StandardReading> standard_reading(const Fibre& fibre, double friction, const LoadingRead& read);

}  // namespace flexslip
