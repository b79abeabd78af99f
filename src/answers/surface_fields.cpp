#include "answers/surface_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "answers/mechanics_fields.h"

namespace flexslip {
namespace {

template <class Value>
std::optional<Value> unless(bool missing, Value value) {
  return missing ? std::nullopt : std::optional(std::move(value));
}

Fields<SurfaceStudy> file_fields() {
  return Fields<SurfaceStudy>()
      .words("name", "name of the file, as it was given", [](const SurfaceStudy& study) { return study.file.source; })
      .words("position", "column of the positions; null if their distance was stated",
             [](const SurfaceStudy& study) { return unless(study.file.position.empty(), study.file.position); })
      .words("height", "column of the heights", [](const SurfaceStudy& study) { return study.file.height; })
      .count("heights", "number of heights", [](const SurfaceStudy& study) { return study.trace.height.size(); })
      .own("step", kind::length, "distance between heights", [](const SurfaceStudy& study) { return study.trace.step; })
      .own("field", kind::length, "width of the trace", [](const SurfaceStudy& study) { return study.trace.width(); })
      .number("unevenness", "greatest relative departure of a distance between heights from the mean",
              [](const SurfaceStudy& study) { return study.file.sampled.unevenness; })
      .yes_no("interpolated", "heights were interpolated, as their distances differ by more than 1 %",
              [](const SurfaceStudy& study) { return study.file.sampled.interpolated; })
      .words("notes", "what was decided about the file", [](const SurfaceStudy& study) { return study.file.notes; });
}

Fields<SurfaceStudy> treatment_fields() {
  return Fields<SurfaceStudy>()
      .count("level", "degree of the polynomial that was subtracted",
             [](const SurfaceStudy& study) { return study.options.level; })
      .own("cutoff", kind::length, "cutoff of the Gaussian filter; null without one",
           [](const SurfaceStudy& study) { return study.options.cutoff; })
      .own("edge_radius", kind::length, "radius of the edge that is drawn over the surface",
           [](const SurfaceStudy& study) { return study.options.edge_radius; })
      .count("tapers", "number of tapers of the spectrum",
             [](const SurfaceStudy& study) { return study.texture.spectrum.tapers; });
}

Fields<DominantWave> dominant_wave_fields() {
  using W = const DominantWave&;
  return Fields<DominantWave>()
      .own_estimate("wavelength", kind::length, "wavelength along the trace", &DominantWave::wavelength)
      .own_estimate("amplitude", kind::length, "amplitude of the height, half of crest to trough",
                    &DominantWave::amplitude)
      .number("slope_amplitude", "amplitude of the slope, 2π amplitude/wavelength",
              [](W wave) { return 2 * std::numbers::pi * wave.amplitude.value / wave.wavelength.value; })
      .yes_no("coherent", "the wave keeps one phase along the whole trace", &DominantWave::coherent)
      .own("phase", kind::angle, "phase of a coherent wave at position 0; null for others",
           [](W wave) { return wave.coherent ? std::optional(wave.phase) : std::nullopt; })
      .number("p_value", "probability that a surface without waves shows a wave like this one anywhere",
              &DominantWave::p_value);
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
      .number("base", "friction of the flat surface, as stated",
              [](const SurfaceStudy& study) { return study.options.friction; })
      .number("mean", "mean of the friction that the slopes predict",
              [](const SurfaceStudy& study) {
                double sum = 0;
                for (const double mu : study.friction->mu) sum += mu;
                return sum / static_cast<double>(study.friction->mu.size());
              })
      .number("deviation", "standard deviation of the friction that the slopes predict",
              [](const SurfaceStudy& study) {
                double sum = 0, squares = 0;
                const auto n = static_cast<double>(study.friction->mu.size());
                for (const double mu : study.friction->mu) sum += mu / n;
                for (const double mu : study.friction->mu) squares += (mu - sum) * (mu - sum) / n;
                return std::sqrt(squares);
              })
      .number("low95", "friction below which a fortieth of the trace lies", quantile(0.025))
      .number("high95", "friction above which a fortieth of the trace lies", quantile(0.975));
}

Fields<WaveResolution> resolution_fields() {
  using R = const WaveResolution&;
  return Fields<WaveResolution>()
      .own("wavelength", kind::length, "wavelength in question", &WaveResolution::wavelength)
      .number("heights_a_wave", "heights per wave; at least two are needed", &WaveResolution::heights_a_wave)
      .number("waves_in_field", "waves in the field; the paper asks for ten", &WaveResolution::waves_in_field)
      .own("least_amplitude_by_pixels", kind::length,
           "smallest amplitude that shows by the paper's rule, ten pixels from crest to trough; null if the pixel is "
           "unknown",
           [](R wave) { return wave.least_by_pixels > 0 ? std::optional(wave.least_by_pixels) : std::nullopt; })
      .own("least_amplitude_by_spectrum", kind::length,
           "smallest amplitude of a coherent wave that stands out from noise and roughness in 95 of 100 such traces",
           &WaveResolution::least_by_spectrum)
      .own("pixel_wanted", kind::length,
           "pixel that the paper's rule asks for, for a wave of the amplitude asked for or found",
           &WaveResolution::pixel_wanted);
}

}  // namespace

Fields<SurfaceStudy> surface_fields() {
  const auto texture = [](auto part) { return [part](const SurfaceStudy& study) { return study.texture.*part; }; };
  return Fields<SurfaceStudy>()
      .words("status", "whether the trace shows a surface: ok, or noise",
             [](const SurfaceStudy& study) { return study.texture.drowned ? "noise" : "ok"; })
      .group("units", "units of plain numbers", units_of_numbers<SurfaceStudy>())
      .group("trace", "trace as it was read", file_fields())
      .group("treatment", "treatment of the heights", treatment_fields())
      .own("rms_height_of_trace", kind::length, "rms height of the levelled trace, including noise",
           texture(&Texture::total_height))
      .own("shortest", kind::length, "shortest wavelength in rms_height and rms_slope", texture(&Texture::shortest))
      .own("longest", kind::length, "longest wavelength in rms_height and rms_slope", texture(&Texture::longest))
      .words(
          "shortest_is", "where shortest comes from: noise (where it equals the surface), five_steps or stated",
          [](const SurfaceStudy& study) {
            return study.options.texture.shortest ? "stated" : study.texture.shortest_is_noise ? "noise" : "five_steps";
          })
      .own_estimate("rms_height", kind::length, "rms height of the surface between these wavelengths, without noise",
                    [](const SurfaceStudy& study) { return unless(study.texture.drowned, study.texture.rms_height); })
      .own_estimate("rms_slope", kind::number, "rms slope of the surface between these wavelengths, without noise",
                    [](const SurfaceStudy& study) { return unless(study.texture.drowned, study.texture.rms_slope); })
      .number("rms_slope_of_edge", "rms slope of the path of the edge, from height to height; null for a sharp edge",
              [](const SurfaceStudy& study) { return study.rms_slope_of_path; })
      .own_estimate("correlation_length", kind::length,
                    "distance at which the correlation has fallen to 1/e; null beyond a tenth of the field",
                    texture(&Texture::correlation_length))
      .own("noise", kind::length, "standard deviation of the white noise of a height", texture(&Texture::noise))
      .words(
          "noise_is", "where noise comes from: stated, found or not_found",
          [](const SurfaceStudy& study) {
            return study.options.texture.noise ? "stated" : study.texture.continuum.noise_found ? "found" : "not_found";
          })
      .list("waves", "waves that stand out from the spectrum, the highest first", dominant_wave_fields(),
            texture(&Texture::waves))
      .own("pixel", kind::length, "smallest difference between heights; null if heights are as fine as their noise",
           [](const SurfaceStudy& study) { return unless(study.pixel == 0, study.pixel); })
      .words("pixel_is", "where pixel comes from: stated, or heights (all are multiples of it); null without one",
             [](const SurfaceStudy& study) {
               return unless(study.pixel_source == PixelSource::none,
                             std::string(study.pixel_source == PixelSource::stated ? "stated" : "heights"));
             })
      .list("resolution", "resolution at the wavelengths asked for, those found, or a tenth of the field",
            resolution_fields(), &SurfaceStudy::resolution)
      .group("friction", "friction that the slopes predict; null if no friction of the flat surface is stated",
             predicted_fields(), [](const SurfaceStudy& study) { return study.friction ? &study : nullptr; });
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
      .own("position", kind::length, "position along the trace",
           [](P point) { return point.study.trace.position(point.index); })
      .own("height", kind::length, "height of the levelled trace",
           [](P point) { return point.study.trace.height[point.index]; })
      .own("envelope", kind::length, "surface as the edge touches it",
           [](P point) { return point.study.envelope[point.index]; })
      .own("edge", kind::length, "path of the edge", [](P point) { return point.study.path[point.index]; })
      .number("slope", "slope of the path of the edge, to the next position",
              [last](P point) {
                const auto& path = point.study.path;
                if (last(point)) return std::optional<double>();
                return std::optional((path[point.index + 1] - path[point.index]) / point.study.trace.step);
              })
      .number("mu", "friction that the slope predicts", [last](P point) {
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
      .own("frequency", kind::inverse_length, "frequency in waves per length", frequency)
      .own("wavelength", kind::length, "wavelength, the inverse of the frequency",
           [frequency](P point) { return 1 / frequency(point); })
      .number("density",
              "one-sided power spectral density, in m³; its integral over the frequency is the mean square height",
              density)
      .number("density_low", "lower end of the 95 % interval of density",
              [density](P point) { return density(point) * density_interval(point.study.texture.spectrum.tapers).low; })
      .number(
          "density_high", "upper end of the 95 % interval of density",
          [density](P point) { return density(point) * density_interval(point.study.texture.spectrum.tapers).high; })
      .number("background", "smooth part of the density, including noise, in m³",
              [frequency](P point) { return point.study.texture.continuum.continuum(frequency(point)); });
}

}  // namespace flexslip
