// The tracer of sliding curves, which finds every fold.
#pragma once

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

// The curve for sliding in, from S = 1 to S_max, and for sliding out, from S_from to 1. The
// friction is a function of the contact point on the specimen.
// Domain:     rig.stiffness > 0, S_max > 1; S_from > 1, with a state at q = -μ;
//             std::invalid_argument otherwise.
// Tolerance:  no fold is missed whose snap is longer than 1e-6 of the period of friction, for any
//             wavelength. G is interpolated by Chebyshev polynomials of degree 12 on half the
//             shortest period, and between the knots of a table. The roots of G' are counted by
//             Descartes' rule in Bernstein form. If that is inconclusive, G' itself is
//             interpolated, and cells are halved until it is known to 1e-6 of its terms (theory.md,
//             "Folds"). Folds are then polished to the rounding of G'.
// Fails:      std::invalid_argument if the length contains more than 1e6 periods of friction, or
//             for periods below 1e-9 spans.
// Cost:       about 30 µs for each period of friction.
SlidingCurve trace_loading_curve(const Friction& friction, const Rig& rig, double S_max);
SlidingCurve trace_unloading_curve(const Friction& friction, const Rig& rig, double S_from);

}  // namespace flexslip
