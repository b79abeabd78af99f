#include "report/implied_words.h"

#include <fmt/format.h>

#include "finding/digits.h"
#include "finding/printed.h"

namespace flexslip {
namespace {

std::string what_would_do(const FittedTest& test) {
  const ImpliedSurface& implied = *test.implied;
  const FrictionFit& fit = test.analysis.fit;
  const double unit = test.analysis.scales.span();
  const Kind length = Print(test).as(kind::length);
  const auto with_error = [&](const Estimate& estimate) {
    return readable(unit * estimate.value, unit * estimate.standard_error, length);
  };
  std::string words;
  if (!fit.waves.empty()) {
    const WaveEstimate& wave = fit.waves.front();
    const WantedImage wanted = wanted_image(unit * wave.wavelength.value, 2 * unit * wave.height.value);
    words = fmt::format(
        "A wave of the surface with an amplitude of {} (half of crest to trough) and a wavelength of {} would explain "
        "{}. By "
        "the paper's rule (ten pixels from crest to trough, ten waves in the field), an image with pixels of {} in a "
        "field of {} would show it. ",
        with_error(wave.height), with_error(wave.wavelength),
        fit.wave_claimed ? "the wave of friction" : "the likeliest wave of friction, which is only indicative",
        readable(wanted.pixel, length), readable(wanted.field, length));
  }
  return words + fmt::format(
                     "Slopes of {} rms and heights of {} rms, of waves up to {}, would explain all of the variation, "
                     "on a surface "
                     "whose friction is {} where it is flat.",
                     readable(implied.rms_slope.value, implied.rms_slope.standard_error, kind::number),
                     with_error(implied.rms_height), readable(unit * implied.longest, length),
                     significant(implied.base, 3));
}

std::string how_it_shows(const HeldSurface& held, const Kind& length) {
  if (held.texture.drowned) return fmt::format("The trace {} shows only noise.", held.file);
  std::string words =
      fmt::format("The trace {} has slopes of {} rms over wavelengths of {} to {}", held.file,
                  readable(held.texture.rms_slope.value, held.texture.rms_slope.standard_error, kind::number),
                  readable(held.texture.shortest, length), readable(held.texture.longest, length));
  if (!held.texture.waves.empty()) {
    const DominantWave& wave = held.texture.waves.front();
    words += fmt::format("; its highest wave has an amplitude of {} and a wavelength of {}",
                         readable(wave.amplitude.value, wave.amplitude.standard_error, length),
                         readable(wave.wavelength.value, wave.wavelength.standard_error, length));
  }
  if (held.wave) {
    words += fmt::format("; a wave as long as that of friction would stand out from an amplitude of {} on",
                         readable(held.wave->least_by_spectrum, length));
    if (held.pixel > 0)
      words += fmt::format(", and by the paper's rule, with pixels of {}, from {} on", readable(held.pixel, length),
                           readable(held.wave->least_by_pixels, length));
  }
  return words + ".";
}

std::string where_it_fits(const HeldSurface& held, const Kind& length) {
  constexpr double by_chance = 0.05;
  const Placement& placement = held.placement;
  const std::string found = fmt::format("correlation {}, p = {} over {} places", significant(placement.correlation, 2),
                                        significant(placement.p_value, 2), placement.places);
  if (placement.p_value > by_chance)
    return fmt::format("No place along the trace fits the friction better than chance ({}).", found);
  return fmt::format("The trace fits the friction best with the support at {} at first{} ({}).",
                     readable(held.begin, length), placement.turned ? " and the trace reversed" : "", found);
}

}  // namespace

std::vector<std::string> implied_in_words(const FittedTest& test) {
  if (!test.implied) return {};
  std::vector<std::string> all{what_would_do(test)};
  const Kind length = Print(test).as(kind::length);
  if (test.held) {
    all.push_back(how_it_shows(*test.held, length));
    all.push_back(where_it_fits(*test.held, length));
  }
  if (test.cycles)
    all.emplace_back(
        "Slopes make friction high in one direction where it is low in the other; where friction is the same in both "
        "directions at the same points, slopes are not the reason why it varies.");
  return all;
}

}  // namespace flexslip
