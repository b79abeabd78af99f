// Ψ tabulated: for work that needs very many states and no more than 12 digits of each.
//
// Piecewise Chebyshev interpolation of w/σ and F/σ in σ = √(S - 1) and q: in these Ψ is smooth down to the straight fibre, and nothing of
// the friction law or the rig is in it. It is built cell by cell, where it is asked for (cell_table.h). Reduced variables as in elastica.h; arrays and their
// properties as in batch.h, but for the accuracy.
#pragma once

#include "fibre/batch.h"

namespace flexslip {

// Where states are interpolated: 0 < σ < table_sigma, q in [table_q.least, table_q.greatest); beyond, and where the branch ends nearby, they are computed as by batch.h.
inline constexpr double table_sigma = 1.05;  // [√L] S up to 2.1
struct FrictionRange {
  double least, greatest;  // [1]
};
inline constexpr FrictionRange table_q{-2, 4};

// Domain:     as fibre_states.
// Max error:  relative, 1e-12 in w; in F 1e-12 times its condition number (elastica.h).
// Cost:       about 10 ns a state; 4 µs for the first in a cell.
StateArrays tabulated_states(const FibrePoints& points);

// With the derivatives of the interpolants.
// Max error:  of w and F as above; of X_S 1e-10 of the larger of |X_S| and |X|/(S - 1), of X_q 1e-10 of the larger of |X_q| and
//             |X|/(1 + |q|); for X = F that times the condition number of F.
// Cost:       about 20 ns a state.
SlopeArrays tabulated_states_slopes(const FibrePoints& points);

}  // namespace flexslip
