// Whether a trace can show a wave: its step, the width of its field, its pixel and its noise against wavelength and height.
#pragma once

#include <cstddef>

namespace flexslip {

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
  double least_by_spectrum;  // [L] the least amplitude that stands out of the spectrum, as least_amplitude has it
  double pixel_wanted;       // [L] by the paper's rule, for a wave of the amplitude asked for; NaN without one
  bool is_sampled;           // two heights a wave or more
  bool has_field;            // periods_wanted waves or more
};

// [L] The least amplitude h of a coherent wave that the spectrum shows in 95 of 100 traces, where one of 20 traces without a wave would show one:
//     h = √(2 P/W) (√ln(m/α) + 1.645/√2),  α = 0.05
// with P [L^3] the density of what else is there, noise and roughness, in the field W over m frequencies. In white noise of standard deviation σ
// P = 2 σ² step, so that h is 2 σ/√n times the bracket: it falls with the number n of heights, below a pixel if the noise dithers it.
// Domain:     density >= 0, width > 0, frequencies >= 1; std::invalid_argument otherwise.
double least_amplitude(double density, double width, std::size_t frequencies);

// Domain:     a trace of positive step and width; wavelength > 0; std::invalid_argument otherwise.
WaveResolution resolution_of(const TraceResolution& trace, double wavelength, double density, double amplitude);

// The field and the pixel that the paper's rule wants for an undulation of a height, crest to trough, and a length [L].
struct WantedImage {
  double field, pixel;  // [L]
};
WantedImage wanted_image(double wavelength, double crest_to_trough);

}  // namespace flexslip
