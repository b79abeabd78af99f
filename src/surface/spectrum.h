// The power spectrum of a trace by several tapers, each an estimate of its own; and its smooth part.
//
// Sine tapers (Riedel and Sidorenko, IEEE Trans. Signal Process. 43, 1995): v_k(t) = √(2/(n+1)) sin(πk t/(n+1)), t = 1..n. Their mean over k = 1..K
// has chi squared of 2K freedoms, a half bandwidth of (K+1)/2 of the least frequency 1/(n step), and little bias beyond it.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "numerics/fourier.h"

namespace flexslip {

struct Spectrum {
  std::size_t tapers;     // K
  double width;           // [L] of the field, n step
  double step;            // [1/L] between frequencies, at most 0.5/width: padded to a power of two
  double half_bandwidth;  // [1/L]
  double
      inflation;  // [1] by how much more a sum over it varies than one over n even heights, since tapers leave out the ends
  std::vector<double> frequency;   // [1/L] from 0 to half of 1/(step of the trace)
  std::vector<double> density;     // [L^3] one-sided: its integral is the mean square of the heights
  std::vector<Complexes> tapered;  // the transforms of the tapered heights, taper by taper

  std::size_t at(double f) const;  // the index of the frequency nearest to f
};

// Domain:     at least 8 finite heights and twice as many as tapers, step > 0, 2 to 50 tapers; std::invalid_argument otherwise.
// Cost:       K/2 Fourier transforms.
Spectrum spectrum_of(std::span<const double> height, double step, std::size_t tapers);

// Of a density the factors to the ends of its 95 % interval: 2K over the quantiles of chi squared.
struct DensityInterval {
  double low, high;  // [1]
};
DensityInterval density_interval(std::size_t tapers);

// The F test for a coherent wave at a frequency (Thomson, Proc. IEEE 70, 1982): the wave that all tapers share against what they do not.
struct Coherence {
  std::complex<double> wave;  // [L] half its amplitude, with its phase at the first height
  double ratio;               // [1] F with 2 and 2K-2 freedoms if there is none
  double p_value;             // [1] of a single frequency
};
Coherence coherence_at(const Spectrum& spectrum, std::size_t index, std::size_t heights);

// The same at any frequency [1/L], between those of the spectrum; cost: a product for each height and taper.
Coherence coherence_at(std::span<const double> height, double step, std::size_t tapers, double frequency);

// The smooth part of a spectrum: a surface without waves, and the white noise of the instrument.

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
