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
      .words("file", "the trace, as it was given", &HeldSurface::file)
      .own("step", kind::length, "between its heights", &HeldSurface::step)
      .own("field", kind::length, "its width", &HeldSurface::width)
      .own("pixel", kind::length, "least difference of its heights; null if they are as fine as their noise",
           [](H held) { return held.pixel > 0 ? std::optional(held.pixel) : std::nullopt; })
      .own_estimate("rms_slope", kind::number, "of the trace, of waves between the next two",
                    [](H held) { return held.texture.drowned ? std::nullopt : std::optional(held.texture.rms_slope); })
      .own("shortest", kind::length, "wavelength that it is told of", [](H held) { return held.texture.shortest; })
      .own("longest", kind::length, "likewise", [](H held) { return held.texture.longest; })
      .own("least_amplitude_by_spectrum", kind::length,
           "of a coherent wave as long as that of friction, that would stand out of the trace; null without a wave",
           [](H held) { return held.wave ? std::optional(held.wave->least_by_spectrum) : std::nullopt; })
      .own("least_amplitude_by_pixels", kind::length, "by the paper's rule; null where the pixel is not known",
           [](H held) {
             return held.wave && held.wave->least_by_pixels > 0 ? std::optional(held.wave->least_by_pixels)
                                                                : std::nullopt;
           })
      .number("correlation", "of the slopes, where they fit best", [](H held) { return held.placement.correlation; })
      .number("p_value", "that chance finds as high a correlation at any place, either way round",
              [](H held) { return held.placement.p_value; })
      .count("places", "that were tried, both ways round", [](H held) { return held.placement.places; })
      .own("begin", kind::length, "of the trace, where the support stood at first, at the best place",
           &HeldSurface::begin)
      .yes_no("turned", "the trace is run through the other way there", [](H held) { return held.placement.turned; })
      .own("overlap", kind::length, "of trace and friction there", [](H held) { return held.placement.overlap; });
}

}  // namespace

Fields<FittedTest> implied_fields() {
  const auto of = [](auto part) { return [part](T test) { return (*test.implied).*part; }; };
  const auto mean = [](std::vector<double> ImpliedProfile::*part) {
    return [part](T test) { return test.implied->mean.*part; };
  };
  return Fields<FittedTest>()
      .number("base_friction", "of the flat surface: that for which the slopes are zero on average",
              of(&ImpliedSurface::base))
      .estimate("rms_slope", kind::number, "of the slopes that would show the friction, of waves up to longest",
                of(&ImpliedSurface::rms_slope))
      .estimate("rms_height", kind::length, "of the heights, likewise", of(&ImpliedSurface::rms_height))
      .number("longest", kind::length, "wavelength that these are told of, a quarter of the fibre seen",
              of(&ImpliedSurface::longest))
      .estimate("wave_height", kind::length,
                "amplitude of the wave of height that would show the likeliest wave of friction; null without one",
                [](T test) { return wave_of(test) ? std::optional(wave_of(test)->height) : std::nullopt; })
      .number("wavelength", kind::length, "of that wave",
              [](T test) { return wave_of(test) ? std::optional(wave_of(test)->wavelength.value) : std::nullopt; })
      .yes_no("wave_claimed", "it is claimed by the evidence",
              [](T test) { return wave_of(test) ? std::optional(test.analysis.fit.wave_claimed) : std::nullopt; })
      .number("pixel_wanted", kind::length, "to see it by the paper's rule, ten pixels from crest to trough",
              [](T test) {
                return wave_of(test) ? std::optional(wanted_image(1, 2 * wave_of(test)->height.value).pixel)
                                     : std::nullopt;
              })
      .number("field_wanted", kind::length, "by that rule, ten waves",
              [](T test) {
                return wave_of(test) ? std::optional(wanted_image(wave_of(test)->wavelength.value, 0).field)
                                     : std::nullopt;
              })
      .group("profile", "along the specimen",
             Fields<FittedTest>()
                 .numbers("position", kind::length, "from midspan", of(&ImpliedSurface::position))
                 .numbers("slope", kind::number, "of the surface, by the mean of the fit", mean(&ImpliedProfile::slope))
                 .numbers("slope_deviation", kind::number, "standard deviation of the draws",
                          of(&ImpliedSurface::slope_deviation))
                 .numbers("height", kind::length, "by the mean of the fit, without tilt", mean(&ImpliedProfile::height))
                 .numbers("height_deviation", kind::length, "standard deviation of the draws",
                          of(&ImpliedSurface::height_deviation)))
      .group("against_trace", "a height trace it was held against; null without one", held_fields(),
             [](T test) { return test.held; });
}

}  // namespace flexslip
