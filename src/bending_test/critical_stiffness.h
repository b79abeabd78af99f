// How stiff a load train must be for the fibre not to snap.
#pragma once

#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

// The least stiffness of the load train [EI/L^3] with which no loading up to the deflection w_max [L] snaps: 0 where none snaps
// on any rig stiffer than 1e-6, infinite where one does even with the deflection itself controlled.
// Domain:     w_max >= 1e-6, finite; std::invalid_argument otherwise.
// Tolerance:  1e-9, relative: a snap at a stiffness above that would be shorter than the tracer tells (rig.h).
// Fails:      as trace_loading_curve (rig.h).
// Method:     continuation of the fold. G' = w' + F'/k vanishes where k = -F'/w', so that the folds of all rigs lie on one
//             curve k(S), and a pair of them vanishes in a cusp, at a maximum of k(S) or at the end of the range. From the pairs
//             that the tracer finds on a soft rig one is followed up to its cusp; just above it the curve is traced anew; and so on
//             until the tracer, which misses none, finds no fold. A maximum of k(S) is flat and needs no second derivatives
//             (theory.md, "The critical stiffness").
// Cost:       about three traces, and 20 µs for each cusp; at worst a trace for every maximum of k(S).
double critical_stiffness(const Friction& friction, double w_max, const Fibre& fibre = {});

// -F'/w' along q = μ(S) [EI/L^3]: on the rig of that stiffness the fibre is at a fold at this length.
// Domain:     S > 1, where a state exists.
// The friction is that met on the way (contact/over_rollers.h).
double stiffness_of_fold(const Friction& friction, double S, const Fibre& fibre = {});

}  // namespace flexslip
