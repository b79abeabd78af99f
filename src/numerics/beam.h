// A beam on two supports in linear (Euler-Bernoulli) theory: the limit of small deflection.
#pragma once

namespace flexslip {

inline constexpr double beam_stiffness = 48;  // [EI/L^3] force/deflection at midspan

// [N m^2] The bending stiffness EI of a beam over a span [m] with the initial slope `slope` [N/m]
// of force against deflection. beam_slope is the inverse.
inline double beam_bending_stiffness(double slope, double span) { return slope * span * span * span / beam_stiffness; }
inline double beam_slope(double bending_stiffness, double span) {
  return beam_stiffness * bending_stiffness / (span * span * span);
}

// [L] The deflection of a beam at a stage position [L], on a rig of this stiffness [EI/L^3].
// Domain:     stiffness > 0, or infinity.
inline double beam_deflection(double stage, double stiffness) { return stage / (1 + beam_stiffness / stiffness); }

}  // namespace flexslip
