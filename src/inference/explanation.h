// Ways in which friction along a fibre may explain a record, and what comes of them together.
#pragma once

#include <vector>

#include "data/estimate.h"
#include "inference/kernel.h"
#include "inference/normal_mixture.h"

namespace flexslip {

// A wave of friction, (4.25).
struct WaveEstimate {
  Estimate amplitude;        // [1] A, relative to mu0
  Estimate wavelength;       // [L] λ
  Estimate phase;            // [rad] φ of (4.25), at S = 0: strongly correlated with λ
  Estimate phase_at_middle;  // [rad] π S_middle/λ + φ, which is not
  Estimate height{};  // [L] amplitude of the surface wave that would show it: A μ λ/(2π (1 + μ²)), μ of the mean
};

// What a record says of a parameter beside what was known beforehand: their quotient is the record's own.
struct Marginal {
  NormalMixture posterior;
  double prior_mean, prior_deviation;  // of a normal distribution
};

// One explanation among those that the answer averages over.
struct Explanation {
  Kernel kernel;
  std::vector<double> wavelengths;  // [L] of its waves
  double log_evidence;
  double log_likelihood;  // where its posterior is greatest
  double weight;          // [1] of all; they add up to 1
};

struct ScannedWave {
  double wavelength;  // [L]
  double gain;        // of the logarithm of the evidence, by a wave added to what explains the record without one
};

// Friction along the fibre seen: at each of many lengths what is known of it.
struct ProfileBand {
  std::vector<double> S;                // [L] drawn in, rising
  std::vector<double> mean, deviation;  // [1]
};

}  // namespace flexslip
