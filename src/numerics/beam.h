// A beam on two supports that is hardly bent, by Euler and Bernoulli: what every bent fibre begins as.
#pragma once

namespace flexslip {

inline constexpr double beam_stiffness = 48;  // [EI/L^3] force at midspan over the deflection there

// EI [N m^2] of a beam over a span [m] whose force rises by `slope` [N/m] with the deflection; and back.
inline double beam_bending_stiffness(double slope, double span) { return slope * span * span * span / beam_stiffness; }
inline double beam_slope(double bending_stiffness, double span) {
  return beam_stiffness * bending_stiffness / (span * span * span);
}

// The deflection [L] of a beam at a stage position [L] of a rig whose stiffness is in EI/L^3.
// Domain: stiffness > 0, or infinity.
inline double beam_deflection(double stage, double stiffness) { return stage / (1 + beam_stiffness / stiffness); }

}  // namespace flexslip
