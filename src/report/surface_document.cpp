#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "finding/printed.h"
#include "report/answer_documents.h"

namespace flexslip {
namespace {

std::string told_length(double value) { return readable(value, kind::length); }

// With its error, and in brackets the ends of its interval.
std::string with_ends(const Estimate& estimate) {
  const std::string_view unit = best_unit(std::abs(estimate.value), kind::length);
  const auto digits = matched_digits(estimate, from_si(1, parse_unit(unit)));
  return fmt::format("{} ± {} {} [{}, {}]", digits.value, digits.error, typeset(unit), digits.low, digits.high);
}

std::string noise_of_trace(const SurfaceStudy& study) {
  const Texture& texture = study.texture;
  if (study.options.texture.noise)
    return texture.noise > 0 ? fmt::format("white, {} per height, as stated; it is removed", told_length(texture.noise))
                             : "none, as stated";
  if (texture.continuum.noise_found)
    return fmt::format("white, {} per height, from the floor of the spectrum; it is removed",
                       told_length(texture.noise));
  return "the spectrum has no floor: any noise counts as surface; state it with --noise";
}

std::string friction_of_trace(const SurfaceStudy& study) {
  if (!study.friction) return "";
  double sum = 0, squares = 0;
  const double n = static_cast<double>(study.friction->mu.size());
  for (const double mu : study.friction->mu) sum += mu / n;
  for (const double mu : study.friction->mu) squares += (mu - sum) * (mu - sum) / n;
  std::string words = fmt::format("{:.3f} ± {:.3f} (standard deviation along the trace), from {:g} on the flat surface",
                                  sum, std::sqrt(squares), *study.options.friction);
  if (study.options.edge_radius > 0)
    words += fmt::format(", climbed by an edge with a radius of {}", told_length(study.options.edge_radius));
  const double mu = *study.options.friction;
  if (!study.texture.waves.empty() && mu > 0) {
    const DominantWave& wave = study.texture.waves.front();
    words += fmt::format("; the highest wave would appear as a wave of friction with A = {:.3f} and a wavelength of {}",
                         2 * std::numbers::pi * wave.amplitude.value / wave.wavelength.value * (1 + mu * mu) / mu,
                         told_length(wave.wavelength.value));
  }
  return words;
}

// Waves that stand out.
std::vector<std::string> waves_in_words(const SurfaceStudy& study) {
  std::vector<std::string> all;
  for (const DominantWave& wave : study.texture.waves)
    all.push_back(
        fmt::format("amplitude {}, wavelength {}, {} (p {})",
                    readable(wave.amplitude.value, wave.amplitude.standard_error, kind::length),
                    readable(wave.wavelength.value, wave.wavelength.standard_error, kind::length),
                    wave.coherent ? "one phase along the whole trace" : "a phase that wanders",
                    wave.p_value < 1e-4 ? std::string("below 0.0001") : "= " + format_significant(wave.p_value, 2)));
  if (all.empty()) all.emplace_back("none stands out from the spectrum");
  return all;
}

// What waves of some length would show.
std::vector<std::string> resolution_in_words(const SurfaceStudy& study) {
  std::vector<std::string> all;
  for (const WaveResolution& wave : study.resolution) {
    std::string words = fmt::format("{}: ", told_length(wave.wavelength));
    if (!wave.is_sampled) {
      all.push_back(words + fmt::format("cannot be seen, with {:.2g} heights per wave where at least 2 are needed",
                                        wave.heights_a_wave));
      continue;
    }
    words += fmt::format(
        "{:.3g} heights per wave, {:.3g} waves in the field{}; a coherent wave shows from an amplitude of {} on",
        wave.heights_a_wave, wave.waves_in_field,
        wave.has_field ? "" : fmt::format(" (the paper asks for {:g})", periods_wanted),
        told_length(wave.least_by_spectrum));
    if (wave.least_by_pixels > 0)
      words += fmt::format("; by the paper's rule ({:g} pixels of {} from crest to trough), from {} on", pixels_wanted,
                           told_length(study.pixel), told_length(wave.least_by_pixels));
    if (std::isfinite(wave.pixel_wanted))
      words += fmt::format("; by {} rule, {} needs pixels of {} in a field of {}",
                           wave.least_by_pixels > 0 ? "that" : "the paper's",
                           study.options.amplitude ? "the wave asked for" : "the wave found",
                           told_length(wave.pixel_wanted), told_length(periods_wanted * wave.wavelength));
    all.push_back(words);
  }
  return all;
}

std::string treatment_of_trace(const SurfaceStudy& study) {
  return fmt::format(
      "{} at a distance of {}, in a field of {}; {}{}", format_count(study.trace.height.size(), "height", "heights"),
      told_length(study.trace.step), told_length(study.trace.width()),
      study.options.level == 0   ? "their mean is subtracted"
      : study.options.level == 1 ? "levelled with a straight line"
                                 : fmt::format("a polynomial of degree {} is subtracted", study.options.level),
      study.options.cutoff ? fmt::format("; waves shorter than {} are filtered out", told_length(*study.options.cutoff))
                           : "");
}

}  // namespace

std::string surface_in_short(const SurfaceStudy& study) {
  const Texture& texture = study.texture;
  if (texture.drowned)
    return fmt::format("Noise of {} per height hides the surface at all wavelengths from {} to {}.",
                       told_length(texture.noise), told_length(2 * study.trace.step), told_length(texture.longest));
  const auto slope = matched_digits(texture.rms_slope, 1);
  return fmt::format("The surface slope is {} rms (95 %: {} to {}) over wavelengths of {} to {}.", slope.value,
                     slope.low, slope.high, format_roughly(texture.shortest, kind::length),
                     format_roughly(texture.longest, kind::length));
}

std::vector<Chapter> document_of(const SurfaceStudy& study) {
  const Texture& texture = study.texture;
  Rows rows{
      {"trace", treatment_of_trace(study)},
      {"height", texture.drowned ? ""
                                 : fmt::format("{} rms over the same wavelengths; {} for the whole levelled trace",
                                               with_ends(texture.rms_height), told_length(texture.total_height))},
      {"edge",
       !study.rms_slope_of_path
           ? ""
           : fmt::format("the path of an edge with a radius of {} has a slope of {} rms, from height to height",
                         told_length(study.options.edge_radius), format_significant(*study.rms_slope_of_path, 3))},
      {"correlation", texture.correlation_length
                          ? with_ends(*texture.correlation_length) + ", the distance at which it has fallen to 1/e"
                          : ""},
      {"noise", noise_of_trace(study)}};
  const auto add = [&](std::string_view label, const std::vector<std::string>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) rows.push_back({i == 0 ? std::string(label) : "", all[i]});
  };
  add("waves", waves_in_words(study));
  add("resolution", resolution_in_words(study));
  rows.push_back({"friction", friction_of_trace(study)});
  add("file", study.file.notes);
  return {{"", {fmt::format("{}: {}", study.file.source, surface_in_short(study)), rows}}};
}

}  // namespace flexslip
