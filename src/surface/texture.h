// What a levelled trace says of its surface: its waves, how high and steep it is and over which lengths, what of it is noise, and
// whether a trace can show a wave.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "numerics/statistics.h"
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

// Waves in a trace that stand out of the smooth part of its spectrum.

// The likeliest coherent wave that no other explains; none where the F test finds none at 1 % over all frequencies.
std::optional<DominantWave> coherent_wave_in(const HeightTrace& trace, const Spectrum& spectrum);

// Taken off, as it was fitted.
HeightTrace without_wave(HeightTrace trace, const DominantWave& wave);

// Peaks that are no coherent waves: they stand out of the continuum, and of their neighbours, at 1 % over all frequencies.
struct Peak {
  DominantWave wave;
  FrequencyRange range;
};
std::vector<Peak> peaks_in(const Spectrum& spectrum, const Continuum& continuum, double longest);

// Whether a trace can show a wave: its step, the width of its field, its pixel and its noise against wavelength and height.

// What the paper asks of an image (its section 5): a field ten wavelengths wide, and ten pixels over the height of an undulation, crest to trough.
inline constexpr double periods_wanted = 10, pixels_wanted = 10;

struct TraceResolution {
  double step;   // [L] between heights
  double width;  // [L] of the field
  double
      pixel;  // [L] the least difference in height that is told: the pixel of an image; 0 if it is as fine as its noise
};

// How a wave of one length would show in a trace.
struct WaveResolution {
  double wavelength;         // [L]
  double heights_a_wave;     // [1] λ/step
  double waves_in_field;     // [1] width/λ
  double least_by_pixels;    // [L] the least amplitude, by the paper's rule: pixels_wanted pixel/2
  double least_by_spectrum;  // [L] the least amplitude that stands out of the spectrum, as min_amplitude has it
  double pixel_wanted;       // [L] by the paper's rule, for a wave of the amplitude asked for; NaN without one
  bool is_sampled;           // two heights a wave or more
  bool has_field;            // periods_wanted waves or more
};

// [L] The least amplitude h of a coherent wave that the spectrum shows in 95 of 100 traces, where one of 20 traces without a wave would show one:
//     h = √(2 P/W) (√ln(m/α) + 1.645/√2),  α = 0.05
// with P [L^3] the density of what else is there, noise and roughness, in the field W over m frequencies. In white noise of standard deviation σ
// P = 2 σ² step, so that h is 2 σ/√n times the bracket: it falls with the number n of heights, below a pixel if the noise dithers it.
// Domain:     density >= 0, width > 0, frequencies >= 1; std::invalid_argument otherwise.
double min_amplitude(double density, double width, std::size_t frequencies);

// Domain:     a trace of positive step and width; wavelength > 0; std::invalid_argument otherwise.
WaveResolution resolution_of(const TraceResolution& trace, double wavelength, double density, double amplitude);

// The field and the pixel that the paper's rule wants for an undulation of a height, crest to trough, and a length [L].
struct WantedImage {
  double field, pixel;  // [L]
};
WantedImage wanted_image(double wavelength, double crest_to_trough);

}  // namespace flexslip
