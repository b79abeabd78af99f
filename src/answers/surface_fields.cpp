#include "answers/surface_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "data/names.h"
#include "result/mechanics.h"

namespace flexslip {
namespace {

template <class Value>
std::optional<Value> unless(bool missing, Value value) {
  return missing ? std::nullopt : std::optional(std::move(value));
}

Fields<SurfaceStudy> file_fields() {
  return Fields<SurfaceStudy>()
      .words("name", "as it was given", [](const SurfaceStudy& study) { return study.file.source; })
      .words("position", "column of the positions; null where their distance was stated",
             [](const SurfaceStudy& study) { return unless(study.file.position.empty(), study.file.position); })
      .words("height", "column of the heights", [](const SurfaceStudy& study) { return study.file.height; })
      .count("heights", "that it has", [](const SurfaceStudy& study) { return study.trace.height.size(); })
      .own("step", kind::length, "between heights", [](const SurfaceStudy& study) { return study.trace.step; })
      .own("field", kind::length, "width of the trace", [](const SurfaceStudy& study) { return study.trace.width(); })
      .number("unevenness", "greatest departure of a distance from their mean, relative",
              [](const SurfaceStudy& study) { return study.file.sampled.unevenness; })
      .yes_no("interpolated", "as distances differ by more than 1 %",
              [](const SurfaceStudy& study) { return study.file.sampled.interpolated; })
      .words("notes", "what was decided about the file", [](const SurfaceStudy& study) { return study.file.notes; });
}

Fields<SurfaceStudy> treatment_fields() {
  return Fields<SurfaceStudy>()
      .count("level", "degree of the polynomial taken off",
             [](const SurfaceStudy& study) { return study.options.level; })
      .own("cutoff", kind::length, "of the Gaussian filter; null without one",
           [](const SurfaceStudy& study) { return study.options.cutoff; })
      .own("edge_radius", kind::length, "of the edge that is drawn over it",
           [](const SurfaceStudy& study) { return study.options.edge_radius; })
      .count("tapers", "of the spectrum", [](const SurfaceStudy& study) { return study.texture.spectrum.tapers; });
}

Fields<DominantWave> dominant_wave_fields() {
  using W = const DominantWave&;
  return Fields<DominantWave>()
      .own_estimate("wavelength", kind::length, "along the trace", &DominantWave::wavelength)
      .own_estimate("amplitude", kind::length, "of the height, half of crest to trough", &DominantWave::amplitude)
      .number("slope_amplitude", "2π amplitude over wavelength",
              [](W wave) { return 2 * std::numbers::pi * wave.amplitude.value / wave.wavelength.value; })
      .yes_no("coherent", "one phase all along the trace", &DominantWave::coherent)
      .own("phase", kind::angle, "of a coherent one, at position 0; null of others",
           [](W wave) { return wave.coherent ? std::optional(wave.phase) : std::nullopt; })
      .number("p_value", "that a surface without waves shows one like it anywhere", &DominantWave::p_value);
}

Fields<SurfaceStudy> predicted_fields() {
  const auto quantile = [](double share) {
    return [share](const SurfaceStudy& study) {
      std::vector<double> mu = study.friction->mu;
      const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(mu.size() - 1));
      std::nth_element(mu.begin(), mu.begin() + at, mu.end());
      return mu[static_cast<std::size_t>(at)];
    };
  };
  return Fields<SurfaceStudy>()
      .number("base", "of the flat surface, as stated",
              [](const SurfaceStudy& study) { return study.options.friction; })
      .number("mean", "of what the slopes show",
              [](const SurfaceStudy& study) {
                double sum = 0;
                for (const double mu : study.friction->mu) sum += mu;
                return sum / static_cast<double>(study.friction->mu.size());
              })
      .number("deviation", "standard deviation of it",
              [](const SurfaceStudy& study) {
                double sum = 0, squares = 0;
                const auto n = static_cast<double>(study.friction->mu.size());
                for (const double mu : study.friction->mu) sum += mu / n;
                for (const double mu : study.friction->mu) squares += (mu - sum) * (mu - sum) / n;
                return std::sqrt(squares);
              })
      .number("low95", "a fortieth of the trace shows less", quantile(0.025))
      .number("high95", "a fortieth of the trace shows more", quantile(0.975));
}

Fields<WaveResolution> resolution_fields() {
  using R = const WaveResolution&;
  return Fields<WaveResolution>()
      .own("wavelength", kind::length, "in question", &WaveResolution::wavelength)
      .number("heights_a_wave", "two are the least", &WaveResolution::heights_a_wave)
      .number("waves_in_field", "the paper asks for ten", &WaveResolution::waves_in_field)
      .own("least_amplitude_by_pixels", kind::length,
           "by the paper's rule, ten pixels from crest to trough; null where the pixel is not known",
           [](R wave) { return wave.least_by_pixels > 0 ? std::optional(wave.least_by_pixels) : std::nullopt; })
      .own("least_amplitude_by_spectrum", kind::length,
           "of a coherent wave that stands out of noise and roughness in 95 of 100 such traces",
           &WaveResolution::least_by_spectrum)
      .own("pixel_wanted", kind::length, "by the paper's rule, for a wave of the amplitude asked for or found",
           &WaveResolution::pixel_wanted);
}

}  // namespace

Fields<SurfaceStudy> surface_fields() {
  const auto texture = [](auto part) { return [part](const SurfaceStudy& study) { return study.texture.*part; }; };
  return Fields<SurfaceStudy>()
      .words("status", "ok, or noise: no surface is seen in it",
             [](const SurfaceStudy& study) { return study.texture.drowned ? "noise" : "ok"; })
      .group("units", "of plain numbers", units_of_numbers<SurfaceStudy>())
      .group("trace", "as it was read", file_fields())
      .group("treatment", "of the heights", treatment_fields())
      .own("rms_height_of_trace", kind::length, "of the levelled trace, noise included",
           texture(&Texture::total_height))
      .own("shortest", kind::length, "wavelength that rms_height and rms_slope are told of",
           texture(&Texture::shortest))
      .own("longest", kind::length, "likewise", texture(&Texture::longest))
      .words(
          "shortest_is", "noise: where it is as great as the surface; five_steps; stated",
          [](const SurfaceStudy& study) {
            return study.options.texture.shortest ? "stated" : study.texture.shortest_is_noise ? "noise" : "five_steps";
          })
      .own_estimate("rms_height", kind::length, "of the surface, of wavelengths between these, without noise",
                    [](const SurfaceStudy& study) { return unless(study.texture.drowned, study.texture.rms_height); })
      .own_estimate("rms_slope", kind::number, "likewise",
                    [](const SurfaceStudy& study) { return unless(study.texture.drowned, study.texture.rms_slope); })
      .number("rms_slope_of_edge", "of the path of the edge, from height to height; null of a sharp one",
              [](const SurfaceStudy& study) { return study.rms_slope_of_path; })
      .own_estimate("correlation_length", kind::length,
                    "where the correlation has fallen to 1/e; null beyond a tenth of the field",
                    texture(&Texture::correlation_length))
      .own("noise", kind::length, "standard deviation of a height, white", texture(&Texture::noise))
      .words(
          "noise_is", "stated, found or not_found",
          [](const SurfaceStudy& study) {
            return study.options.texture.noise ? "stated" : study.texture.continuum.noise_found ? "found" : "not_found";
          })
      .list("waves", "that stand out of the spectrum, the highest first", dominant_wave_fields(),
            texture(&Texture::waves))
      .own("pixel", kind::length, "least difference of heights that is told; null if they are as fine as their noise",
           [](const SurfaceStudy& study) { return unless(study.pixel == 0, study.pixel); })
      .words("pixel_is", "stated, heights: all are multiples of it; null without one",
             [](const SurfaceStudy& study) {
               return unless(study.pixel_source == PixelSource::none,
                             std::string(study.pixel_source == PixelSource::stated ? "stated" : "heights"));
             })
      .list("resolution", "of the wavelengths in question, of those found, or of a tenth of the field",
            resolution_fields(), &SurfaceStudy::resolution)
      .group("friction", "that its slopes predict; null where none is stated", predicted_fields(),
             [](const SurfaceStudy& study) { return study.friction ? &study : nullptr; });
}

std::vector<TracePoint> points_of(const SurfaceStudy& study) {
  std::vector<TracePoint> points;
  for (std::size_t i = 0; i < study.trace.height.size(); ++i) points.push_back({study, i});
  return points;
}

Fields<TracePoint> trace_fields() {
  using P = const TracePoint&;
  const auto last = [](P point) { return point.index + 1 == point.study.trace.height.size(); };
  return Fields<TracePoint>()
      .own("position", kind::length, "along the trace", [](P point) { return point.study.trace.position(point.index); })
      .own("height", kind::length, "levelled", [](P point) { return point.study.trace.height[point.index]; })
      .own("envelope", kind::length, "the surface as the edge sees it",
           [](P point) { return point.study.envelope[point.index]; })
      .own("edge", kind::length, "path of the edge", [](P point) { return point.study.path[point.index]; })
      .number("slope", "of that path, to the next position",
              [last](P point) {
                const auto& path = point.study.path;
                if (last(point)) return std::optional<double>();
                return std::optional((path[point.index + 1] - path[point.index]) / point.study.trace.step);
              })
      .number("mu", "friction that it predicts there", [last](P point) {
        if (!point.study.friction || last(point)) return std::optional<double>();
        return std::optional(point.study.friction->mu[point.index]);
      });
}

std::vector<SpectrumPoint> spectrum_points_of(const SurfaceStudy& study) {
  std::vector<SpectrumPoint> points;
  for (std::size_t j = 1; j < study.texture.spectrum.density.size(); ++j) points.push_back({study, j});
  return points;
}

Fields<SpectrumPoint> spectrum_fields() {
  using P = const SpectrumPoint&;
  const auto frequency = [](P point) { return point.study.texture.spectrum.frequency[point.index]; };
  const auto density = [](P point) { return point.study.texture.spectrum.density[point.index]; };
  return Fields<SpectrumPoint>()
      .own("frequency", kind::inverse_length, "in waves per length", frequency)
      .own("wavelength", kind::length, "its inverse", [frequency](P point) { return 1 / frequency(point); })
      .number("density",
              "one-sided power spectral density, in m³; its integral over the frequency is the mean square height",
              density)
      .number("density_low", "lower end of its 95 % interval",
              [density](P point) { return density(point) * density_interval(point.study.texture.spectrum.tapers).low; })
      .number(
          "density_high", "upper end",
          [density](P point) { return density(point) * density_interval(point.study.texture.spectrum.tapers).high; })
      .number("background", "its smooth part, noise included, in m³",
              [frequency](P point) { return point.study.texture.continuum.continuum(frequency(point)); });
}

}  // namespace flexslip
