// The forms that a profile of friction may have, and what it is at a length.
#pragma once

#include <vector>

namespace flexslip {

// One term of the roughness: amplitude cos(π S/wavelength + phase), relative to the mean.
struct Sinusoid {
  double amplitude;   // [1] relative to mu0, A of (4.25); >= 0
  double wavelength;  // [L] along the fibre, λ of (4.25); > 0
  double phase;       // [rad] φ of (4.25)
};

// mu0 (1 + Σ amplitude cos(π S/wavelength + phase)) + drift (S - S_reference), and zero where a drift would carry it below.
// Without terms and drift: constant friction.
struct FrictionWaves {
  double mu0;    // [1] mean coefficient of friction at S_reference
  double drift;  // [1/L] slope of the mean in S
  std::vector<Sinusoid> terms;
  double S_reference = 1;  // [L]
};

// Values at given lengths, interpolated monotonically (no over- or undershoot), constant beyond the ends.
struct FrictionTable {
  std::vector<double> S;   // [L] rising strictly
  std::vector<double> mu;  // [1] >= 0
};

// μ and dμ/dS at one length.
struct FrictionPoint {
  double mu;     // [1]
  double slope;  // [1/L]
};

// The same at many lengths.
struct FrictionArrays {
  std::vector<double> mu;     // [1]
  std::vector<double> slope;  // [1/L]
};

// A term as it is summed: height cos(2π (frequency S + phase)).
struct WaveTerm {
  double height;     // [1]
  double frequency;  // [1/L]
  double phase;      // [1] in turns
  double steepness;  // [1/L] the greatest slope
};

}  // namespace flexslip
