// The wavelengths of the teeth in a friction profile: a likelihood for every wavelength, so that none is missed.
//
// A real profile drifts as it goes, and a plain least-squares periodogram takes the drift for long waves. Here the profile is a
// wave, a random walk along the fibre and white noise together; a Kalman filter removes the walk, and for each wavelength the
// rest is linear. The size of the walk is profiled out, wavelength by wavelength.
#pragma once

#include <span>
#include <vector>

#include "inference/profile.h"

namespace flexslip {

struct WaveCandidate {
  double wavelength;           // [L] along the fibre
  double cosine, sine;         // [1] of π (S - S_reference)/wavelength, in μ
  double log_likelihood_gain;  // [1] over no wave
  double walk;  // [1] variance of the random walk over a step, relative to that of the noise; 0: white residuals
};

struct WavelengthScan {
  double S_reference;                     // [L] the middle of the data
  std::vector<double> wavelengths;        // [L]
  std::vector<double> gains;              // [1] log-likelihood gain of each
  std::vector<WaveCandidate> candidates;  // local maxima, best first
};

struct ScanOptions {
  double least_wavelength;        // [L]
  double periods = 3.5;           // the longest wavelength fits that often into the slip seen: longer ones are drift
  double stiffness_error = 0.03;  // [1] prior standard deviation of ln EI
  int most_candidates = 6;
};

// Domain:     at least 20 points; std::invalid_argument otherwise.
// Method:     generalised least squares; frequencies an eighth of the resolution apart.
// Cost:       10 ms for 250 points and 250 wavelengths.
WavelengthScan scan_wavelengths(std::span<const ProfilePoint> unsorted, const ScanOptions& options);

}  // namespace flexslip
