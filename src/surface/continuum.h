// The smooth part of a spectrum: a surface without waves, and the white noise of the instrument.
#pragma once

#include <optional>
#include <vector>

#include "surface/spectrum.h"

namespace flexslip {

// level (1 + (f/knee)²)^-power exp(-f²/cut²) + noise. Surfaces with an exponential correlation have power 1 and no cut; Gaussian ones only the cut;
// fractal ones power H + 1/2.
struct Continuum {
  double level;    // [L^3]
  double knee;     // [1/L]
  double power;    // [1]
  double cut;      // [1/L] infinite: none
  double noise;    // [L^3] density of white noise; 0: none was found
  double folding;  // [1/L] the rate of sampling: what is finer is folded back

  double surface(double f) const;  // [L^3] without noise
  double operator()(double f) const { return surface(f) + noise; }
};

struct ContinuumFit {
  Continuum continuum;
  bool noise_found;    // by itself: not stated
  double noise_error;  // [1] relative, of the noise found; 0 of one that is stated
  double likelihood;   // ln, greatest
};

// Frequencies that are left out, as a wave's.
struct FrequencyRange {
  double from, to;  // [1/L]
};

// By the greatest (Whittle) likelihood, in bins of at most a twelfth of an octave.
// White noise is found where it gains 3 in ln L and is at least half of what is there at the highest frequency; a floor that folding explains is none.
// A spectrum that nothing but noise explains as well, to 5 in ln L, is noise.
// Domain:     noise stated >= 0.
// Cost:       10 ms.
ContinuumFit fit_continuum(const Spectrum& spectrum, const std::vector<FrequencyRange>& without,
                           std::optional<double> noise);

}  // namespace flexslip
