// The trace of a sliding curve: what finds every fold.
#pragma once

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

// The curve on which the fibre is drawn in, from S = 1 to S_max; and that on which it is let out, from S_from down to 1: of a friction of the
// specimen's points.
// Domain:     rig.stiffness > 0, S_max > 1; S_from > 1, where a state with q = -μ exists; std::invalid_argument otherwise.
// Tolerance:  no fold is missed whose snap is longer than 1e-6 of the roughness's period, whatever the wavelength: G is
//             interpolated by Chebyshev polynomials of degree 12 on half the shortest period (and the pieces between
//             the knots of a table), and the roots of G' are counted by Descartes' rule in Bernstein form. Where that does not
//             decide, G' itself is interpolated, and cells are halved until it is known to 1e-6 of its terms (theory.md,
//             "Folds"). Folds are then polished to the rounding of G'.
// Fails:      std::invalid_argument if the roughness has more than 1e6 periods on this length, or periods below 1e-9 spans.
// Cost:       about 30 µs for each period of the roughness.
SlidingCurve trace_loading_curve(const Friction& friction, const Rig& rig, double S_max);
SlidingCurve trace_unloading_curve(const Friction& friction, const Rig& rig, double S_from);

}  // namespace flexslip
