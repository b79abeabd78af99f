// What a levelled trace says of its surface: its waves, how high and steep it is and over which lengths, and what of it is noise.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "data/estimate.h"
#include "surface/continuum.h"
#include "surface/height_trace.h"
#include "surface/spectrum.h"

namespace flexslip {

struct TextureOptions {
  std::size_t tapers = 7;
  std::optional<double> shortest{}, longest{};  // [L] of the wavelengths that heights and slopes are told of
  std::optional<double> noise{};  // [L] standard deviation of a height, white; not given: found, if it shows
};

// A wave that stands out of what is smooth about it.
struct DominantWave {
  Estimate wavelength, amplitude;  // [L]
  double p_value;                  // [1] that one like it is found anywhere in the spectrum of a surface without waves
  bool coherent;                   // one phase all along: by the F test of the tapers
  double phase;                    // [rad] of a coherent one, at position 0: amplitude cos(2π s/wavelength + phase)
};

struct Texture {
  Spectrum spectrum;                // of the trace
  ContinuumFit continuum;           // of what is left without its waves
  std::vector<DominantWave> waves;  // the highest first
  double longest, shortest;         // [L] of the wavelengths that the next two are told of
  bool shortest_is_noise;           // where noise is as great as the surface; else 5 steps (ISO 3274), or as asked for
  bool drowned;                     // noise is as great as the surface at all lengths: the next two are not valid
  Estimate rms_height;              // [L] of the surface that the trace is a sample of
  Estimate rms_slope;               // [1] likewise
  double total_height;              // [L] rms of the levelled trace, noise included
  double noise;                     // [L] standard deviation of a height, stated or found; 0 if none is
  std::optional<Estimate>
      correlation_length;  // [L] where the correlation has fallen to 1/e; none if that is not within a tenth of the field
};

// The fewest heights that tell a spectrum.
inline constexpr std::size_t fewest_heights = 64;

// Domain:     at least fewest_heights finite heights that are not all alike; longest > shortest >= 2 steps, if they are given, longest at most the
//             field; noise >= 0; std::invalid_argument otherwise.
// Method:     the defaults of the band: the longest wave is a quarter of the field, half a bandwidth of seven tapers. Intervals of rms: chi squared with the
//             freedoms that the spectrum leaves a weighted sum of it; of the correlation length: by the
//             error of the correlation where it is 1/e.
// Tolerance:  95 % intervals hold the truth of simulated surfaces in 92 to 98 % (docs/validation.md, "Surfaces").
Texture texture_of(const HeightTrace& trace, const TextureOptions& options = {});

}  // namespace flexslip
