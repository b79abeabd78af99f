// One height trace together with all that is asked of it: what JSON, text and figures of a surface present.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "instruments/trace_file.h"
#include "io/input_error.h"
#include "surface/slope_friction.h"
#include "surface/texture.h"

namespace flexslip {

// Units: SI.
struct SurfaceOptions {
  std::size_t level = 1;              // degree of the polynomial that is taken off
  std::optional<double> cutoff{};     // [m] of a Gaussian filter that takes shorter waves out
  double edge_radius = 0;             // [m] of the support
  std::optional<double> friction{};   // [1] of the flat surface
  std::optional<double> pixel{};      // [m] the least difference in height that is told
  std::vector<double> wavelengths{};  // [m] in question
  std::optional<double> amplitude{};  // [m] of the wave in question
  TextureOptions texture{};
};

enum class PixelSource { stated, heights, none };  // heights: all are multiples of it

struct SurfaceStudy {
  TraceFile file;
  SurfaceOptions options;
  HeightTrace trace;                        // levelled, and through the filter
  Texture texture;                          // of it
  std::vector<double> path;                 // [m] of the edge over it; the trace itself without a radius
  std::vector<double> envelope;             // [m] what the edge sees
  std::optional<double> rms_slope_of_path;  // [1] between neighbouring heights; none without a radius
  std::optional<SlopeFriction> friction;    // between neighbouring heights, if a friction is stated
  double pixel;                             // [m] 0 if heights are told as finely as their noise
  PixelSource pixel_source;
  std::vector<WaveResolution>
      resolution;  // of the wavelengths in question; else of those found; else of a tenth of the field
};

// [1] As of any friction that is computed with.
inline constexpr double max_apparent = 20;

// What a trace would make of the friction of a support: levelled, filtered and rolled over. Both have as many heights as the trace.
struct PreparedTrace {
  HeightTrace trace;
  std::vector<double> path;
};
PreparedTrace prepared(const Sampled& sampled, std::size_t level, std::optional<double> cutoff, double edge_radius);

// Why a path shows no friction: the place and the limit. [m], [1]
InputError refusal_of(const TooSteep& fault, const HeightTrace& trace, double mu, const std::string& source,
                      const Kind& kind);

// Fails:      InputError for what the trace does not allow: a band of wavelengths beyond it, heights that are all alike, slopes too steep for the friction.
SurfaceStudy study_surface(TraceFile file, const SurfaceOptions& options);

// Quantities with their units; empty where nothing is said.
struct SurfaceChoice {
  std::string cutoff, edge_radius, friction, pixel, amplitude, shortest, longest, noise;
  std::vector<std::string> wavelengths{};
  std::size_t level = SurfaceOptions{}.level;    // as SurfaceOptions
  std::size_t tapers = TextureOptions{}.tapers;  // from min_tapers to max_tapers
};

inline constexpr std::size_t min_tapers = 2, max_tapers = 30;

// Fails:      InputError that names the flag.
SurfaceOptions options_of(const SurfaceChoice& choice);

}  // namespace flexslip
