#include "answers/implied_fields.h"

#include <optional>

namespace flexslip {
namespace {

using T = const FittedTest&;

const WaveEstimate* wave_of(T test) {
  return test.analysis.fit.waves.empty() ? nullptr : &test.analysis.fit.waves.front();
}

Fields<HeldSurface> held_fields() {
  using H = const HeldSurface&;
  return Fields<HeldSurface>()
      .words("file", "file of the trace, as it was given", &HeldSurface::file)
      .own("step", kind::length, "distance between the heights of the trace", &HeldSurface::step)
      .own("field", kind::length, "width of the trace", &HeldSurface::width)
      .own("pixel", kind::length, "smallest difference between heights; null if heights are as fine as their noise",
           [](H held) { return held.pixel > 0 ? std::optional(held.pixel) : std::nullopt; })
      .own_estimate("rms_slope", kind::number, "rms slope of the trace, of waves from shortest to longest",
                    [](H held) { return held.texture.drowned ? std::nullopt : std::optional(held.texture.rms_slope); })
      .own("shortest", kind::length, "shortest wavelength in rms_slope", [](H held) { return held.texture.shortest; })
      .own("longest", kind::length, "longest wavelength in rms_slope", [](H held) { return held.texture.longest; })
      .own("least_amplitude_by_spectrum", kind::length,
           "smallest amplitude of a coherent wave, as long as that of friction, that would stand out from the trace; "
           "null without a wave",
           [](H held) { return held.wave ? std::optional(held.wave->least_by_spectrum) : std::nullopt; })
      .own("least_amplitude_by_pixels", kind::length,
           "smallest amplitude that shows by the paper's rule; null if the pixel is unknown",
           [](H held) {
             return held.wave && held.wave->least_by_pixels > 0 ? std::optional(held.wave->least_by_pixels)
                                                                : std::nullopt;
           })
      .number("correlation", "correlation of the slopes at the best place",
              [](H held) { return held.placement.correlation; })
      .number("p_value", "probability that chance gives as high a correlation at any place, in either direction",
              [](H held) { return held.placement.p_value; })
      .count("places", "number of places that were tried, in both directions",
             [](H held) { return held.placement.places; })
      .own("begin", kind::length, "position on the trace at which the support stood at first, at the best place",
           &HeldSurface::begin)
      .yes_no("turned", "the trace runs in the other direction at the best place",
              [](H held) { return held.placement.turned; })
      .own("overlap", kind::length, "overlap of trace and friction at the best place",
           [](H held) { return held.placement.overlap; });
}

}  // namespace

Fields<FittedTest> implied_fields() {
  const auto of = [](auto part) { return [part](T test) { return (*test.implied).*part; }; };
  const auto mean = [](std::vector<double> ImpliedProfile::*part) {
    return [part](T test) { return test.implied->mean.*part; };
  };
  return Fields<FittedTest>()
      .number("base_friction", "friction of the flat surface, for which the slopes are zero on average",
              of(&ImpliedSurface::base))
      .estimate("rms_slope", kind::number, "rms slope that would explain the friction, of waves up to longest",
                of(&ImpliedSurface::rms_slope))
      .estimate("rms_height", kind::length, "rms height that would explain the friction, of waves up to longest",
                of(&ImpliedSurface::rms_height))
      .number("longest", kind::length, "longest wavelength in rms_slope and rms_height, a quarter of the specimen seen",
              of(&ImpliedSurface::longest))
      .estimate("wave_height", kind::length,
                "amplitude of the wave of height that would explain the likeliest wave of friction; null without one",
                [](T test) { return wave_of(test) ? std::optional(wave_of(test)->height) : std::nullopt; })
      .number("wavelength", kind::length, "wavelength of the likeliest wave of friction",
              [](T test) { return wave_of(test) ? std::optional(wave_of(test)->wavelength.value) : std::nullopt; })
      .yes_no("wave_claimed", "the evidence supports the wave",
              [](T test) { return wave_of(test) ? std::optional(test.analysis.fit.wave_claimed) : std::nullopt; })
      .number("pixel_wanted", kind::length,
              "pixel needed to see the wave by the paper's rule, ten pixels from crest to trough",
              [](T test) {
                return wave_of(test) ? std::optional(wanted_image(1, 2 * wave_of(test)->height.value).pixel)
                                     : std::nullopt;
              })
      .number("field_wanted", kind::length, "field needed to see the wave by the paper's rule, ten waves",
              [](T test) {
                return wave_of(test) ? std::optional(wanted_image(wave_of(test)->wavelength.value, 0).field)
                                     : std::nullopt;
              })
      .group("profile", "surface along the specimen",
             Fields<FittedTest>()
                 .numbers("position", kind::length, "position from midspan", of(&ImpliedSurface::position))
                 .numbers("slope", kind::number, "slope of the surface, from the mean of the fit",
                          mean(&ImpliedProfile::slope))
                 .numbers("slope_deviation", kind::number, "standard deviation among the draws",
                          of(&ImpliedSurface::slope_deviation))
                 .numbers("height", kind::length, "height of the surface, from the mean of the fit, without tilt",
                          mean(&ImpliedProfile::height))
                 .numbers("height_deviation", kind::length, "standard deviation among the draws",
                          of(&ImpliedSurface::height_deviation)))
      .group("against_trace", "comparison with a measured height trace; null without one", held_fields(),
             [](T test) { return test.held; });
}

}  // namespace flexslip
