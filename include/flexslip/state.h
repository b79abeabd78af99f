// Single states of a specimen between its supports: the elastica with friction, at any deflection.
#pragma once

#include "flexslip/test.h"

namespace flexslip::v1 {

struct State {
  double deflection;    // [m] at midspan
  double force;         // [N] at midspan
  double friction;      // [1] mobilised at the supports, tangential over normal force; below 0 while sliding out
  double length;        // [m] of the axis between the contacts
  double slid;          // [m] length of surface that has slid in, over both supports
  double slope;         // [rad] at the contacts
  double normal_force;  // [N] at one support
  double energy;        // [J] of bending
  double curvature;     // [1/m] at midspan; half the depth times it is the strain of the surface
};

// The state with a deflection and a mobilised friction. The load train has no effect.
// Domain:     a deflection above 0 and at most two spans; a friction from -20 to 20; a setup with a span and a
//             bending stiffness, stated or by modulus and section.
// Max error:  relative 1e-11 for a deflection up to 0.35 spans and a friction from -0.8 to 1.5.
// Fails:      Error outside the domain, and where no state with a force exists.
// Cost:       1 µs, and 50 µs to check the setup.
State state_at(const Setup& setup, double deflection, double friction);

// The state, with the friction that it needs, for a measured deflection and force.
// Domain:     as above; force >= 0 [N].
// Max error:  the force is reproduced to a relative 1e-12.
// Fails:      Error if no friction from -2 to 2 gives the force, or if the deflection is below two thicknesses.
State state_from_force(const Setup& setup, double deflection, double force);

}  // namespace flexslip::v1
