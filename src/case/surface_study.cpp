#include "case/surface_study.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "case/case_file.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

std::string length(double value) { return readable(value, kind::length); }

void require_band(const TraceFile& file, const SurfaceOptions& options) {
  const HeightTrace& trace = file.sampled.trace;
  const auto refuse = [&](const char* flag, std::string expected, double found) {
    throw InputError({.file = file.source, .field = flag, .expected = std::move(expected), .found = length(found)});
  };
  constexpr double rounding = 1e-9;
  const double finest = 2 * trace.step, field = trace.width();
  const auto& [tapers, shortest, longest, noise] = options.texture;
  if (shortest && !(*shortest >= (1 - rounding) * finest && *shortest < field))
    refuse("--shortest",
           fmt::format("at least twice the distance between heights, {}, and less than the field of {}", length(finest),
                       length(field)),
           *shortest);
  if (longest && !(*longest > shortest.value_or(finest) && *longest <= (1 + rounding) * field))
    refuse("--longest",
           fmt::format("more than {} and at most the field of {}", length(shortest.value_or(finest)), length(field)),
           *longest);
  if (shortest && !longest && !(*shortest < 0.25 * field))
    refuse("--shortest",
           fmt::format("less than a quarter of the field, {}, unless --longest is given", length(0.25 * field)),
           *shortest);
  if (options.edge_radius > 1e6 * field)
    refuse("--edge-radius", fmt::format("a radius of at most a million fields, {}", length(1e6 * field)),
           options.edge_radius);
}

}  // namespace

PreparedTrace prepared(const Sampled& sampled, std::size_t level, std::optional<double> cutoff, double edge_radius) {
  HeightTrace trace = levelled(sampled.trace, level);
  if (cutoff) trace = smoothed(std::move(trace), *cutoff);
  std::vector<double> path = path_of_edge(trace.height, trace.step, edge_radius);
  return {std::move(trace), std::move(path)};
}

InputError refusal_of(const TooSteep& fault, const HeightTrace& trace, double mu, const std::string& source,
                      const Kind& kind) {
  const double place = trace.position(fault.interval);
  const double limit = fault.slope > 0 ? slope_of_friction(max_apparent, mu) : mu;
  const bool falls = fault.slope < 0;
  return InputError(
      {.file = source,
       .expected = fmt::format("slopes between {:.3g}, where a contact of friction {:g} slides by itself, and {:.3g}, "
                               "where it would show a friction of {:g}",
                               -mu, mu, slope_of_friction(max_apparent, mu), max_apparent),
       .found = fmt::format("a slope of {:.3g} at the position {}, {:.2g} times the limit", fault.slope,
                            readable(place, kind), std::abs(fault.slope) / limit),
       .remedy = falls ? "if it is noise, remove short waves with a cutoff, or state the radius of the edge; otherwise "
                         "check the unit of the heights"
                       : "if it is noise, remove short waves with a cutoff; otherwise check the unit of the heights"});
}

SurfaceStudy study_surface(TraceFile file, const SurfaceOptions& options) {
  require_band(file, options);
  PreparedTrace ready = prepared(file.sampled, options.level, options.cutoff, options.edge_radius);
  const double rounding =
      1e-12 * std::abs(*std::max_element(file.sampled.trace.height.begin(), file.sampled.trace.height.end(),
                                         [](double a, double b) { return std::abs(a) < std::abs(b); }));
  if (!(root_mean_square(ready.trace.height) > rounding))
    throw InputError({.file = file.source,
                      .expected = "heights that differ once the trace is levelled",
                      .found = "a straight line, or one height",
                      .remedy = "check the column, or --level"});
  Texture texture = texture_of(ready.trace, options.texture);
  SurfaceStudy study{
      std::move(file),   options, std::move(ready.trace), std::move(texture), std::move(ready.path), {}, {}, {}, 0,
      PixelSource::none, {}};
  const HeightTrace& trace = study.trace;
  study.envelope = envelope(trace.height, trace.step, options.edge_radius);
  if (options.edge_radius > 0) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i + 1 < study.path.size(); ++i)
      slopes.push_back((study.path[i + 1] - study.path[i]) / trace.step);
    study.rms_slope_of_path = root_mean_square(slopes);
  }
  if (options.friction) {
    if (const auto fault = too_steep(study.path, trace.step, *options.friction, max_apparent, false))
      throw refusal_of(*fault, trace, *options.friction, study.file.source, kind::length);
    study.friction = friction_of_heights(study.path, trace.step, *options.friction);
  }
  const double quantum = height_quantum(study.file.sampled.trace.height);
  study.pixel = options.pixel.value_or(study.file.sampled.interpolated ? 0 : quantum);
  study.pixel_source = options.pixel ? PixelSource::stated : study.pixel > 0 ? PixelSource::heights : PixelSource::none;
  std::vector<double> wavelengths = options.wavelengths;
  if (wavelengths.empty())
    for (const DominantWave& wave : study.texture.waves) wavelengths.push_back(wave.wavelength.value);
  if (wavelengths.empty()) wavelengths.push_back(trace.width() / periods_wanted);
  for (const double wavelength : wavelengths) {
    double amplitude = options.amplitude.value_or(not_a_number);
    for (const DominantWave& wave : study.texture.waves)
      if (!options.amplitude && wave.wavelength.value == wavelength) amplitude = wave.amplitude.value;
    study.resolution.push_back(resolution_of({trace.step, trace.width(), study.pixel}, wavelength,
                                             study.texture.continuum.continuum(1 / wavelength), amplitude));
  }
  return study;
}

SurfaceOptions options_of(const SurfaceChoice& choice) {
  const auto length = [&](const std::string& text, std::string_view flag,
                          Range range = Range::positive) -> std::optional<double> {
    if (text.empty()) return std::nullopt;
    return quantity_of_flag(flag, text, kind::length, range);
  };
  SurfaceOptions options;
  options.level = choice.level;
  options.cutoff = length(choice.cutoff, "--cutoff");
  options.edge_radius = length(choice.edge_radius, "--edge-radius", Range::non_negative).value_or(0);
  if (!choice.friction.empty())
    options.friction = quantity_of_flag("--friction", choice.friction, kind::number, Range::positive);
  options.pixel = length(choice.pixel, "--pixel");
  options.amplitude = length(choice.amplitude, "--amplitude");
  for (const std::string& text : choice.wavelengths) options.wavelengths.push_back(*length(text, "--wavelength"));
  options.texture.tapers = choice.tapers;
  options.texture.shortest = length(choice.shortest, "--shortest");
  options.texture.longest = length(choice.longest, "--longest");
  options.texture.noise = length(choice.noise, "--noise", Range::non_negative);
  return options;
}

}  // namespace flexslip
