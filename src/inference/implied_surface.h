// The surface that would explain a friction: that whose slopes, climbed by the supports, show the profile that was fitted.
//
// Lengths are those along the specimen if it slides over both supports at once (theory.md, "Two supports"). The friction of the flat surface is not
// known by itself: it is taken as that for which the slopes are zero on average (base_friction). Reduced variables.
#pragma once

#include <optional>
#include <vector>

#include "inference/fit.h"

namespace flexslip {

// Slopes and heights at places along the specimen.
struct ImpliedProfile {
  std::vector<double> slope;   // [1]
  std::vector<double> height;  // [L] on average 0, without tilt
};

struct ImpliedSurface {
  std::vector<double> position;  // [L] from midspan, rising, where the support was
  ImpliedProfile mean;           // of the mean of the fit
  std::vector<ImpliedProfile> draws;
  double longest;       // [L] wavelength, a quarter of the fibre seen: of no longer ones are the next two told
  Estimate rms_slope;   // [1] of the draws
  Estimate rms_height;  // [L] likewise
};

// None of a fit without draws, or on which the contacts roll back.
std::optional<ImpliedSurface> implied_surface(const FrictionFit& fit);

// The rms of slopes at places a mean distance apart, without waves longer than a cutoff (the Gaussian filter of ISO 16610-21).
// Domain:     as smoothed.
struct ShortWaves {
  double rms_slope, rms_height;  // [1], [L]
};
ShortWaves without_long_waves(const std::vector<double>& height, double step, double longest);

}  // namespace flexslip
