#include "surface/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "fibre/chi_squared.h"
#include "fibre/elementary.h"
#include "surface/waves_in_trace.h"

namespace flexslip {
namespace {

constexpr double pi = std::numbers::pi;

// The root of a mean square whose estimate has so many freedoms.
Estimate root_of(double square, double variance) {
  const double freedoms = std::clamp(2 * square * square / std::max(variance, 1e-300), 1.0, 1e7);
  const double value = std::sqrt(square);
  return {value, value / std::sqrt(2 * freedoms), value * std::sqrt(freedoms / chi_squared_quantile(0.975, freedoms)),
          value * std::sqrt(freedoms / chi_squared_quantile(0.025, freedoms))};
}

struct Band {
  double least, greatest;  // [1/L]
};

// The mean square of the surface within a band, each frequency weighted; with the waves taken off before, and without noise.
template <class Weight>
Estimate rms_within(const Spectrum& rest, const ContinuumFit& fit, const std::vector<DominantWave>& coherent, Band band,
                    bool has_rest, Weight weight) {
  double square = 0, variance = 0, of_noise = 0;
  const double unbiased = 1 + 1 / static_cast<double>(rest.tapers);  // of the square of a density
  for (std::size_t j = 1; has_rest && j < rest.density.size(); ++j) {
    const double f = rest.frequency[j];
    const double inside = std::clamp(
        (std::min(f + 0.5 * rest.step, band.greatest) - std::max(f - 0.5 * rest.step, band.least)) / rest.step, 0.0,
        1.0);
    if (inside == 0) continue;
    const double w = weight(f) * inside * rest.step;
    square += w * (rest.density[j] - fit.continuum.noise);
    of_noise += w * fit.continuum.noise;
    variance += w * w * rest.density[j] * rest.density[j] * rest.inflation / (unbiased * rest.step * rest.width);
  }
  variance += fit.noise_error * fit.noise_error * of_noise * of_noise;
  for (const DominantWave& wave : coherent) {
    const double f = 1 / wave.wavelength.value;
    if (f < band.least || f > band.greatest) continue;
    const double part = 0.5 * weight(f) * wave.amplitude.value * wave.amplitude.value;
    square += part;
    const double relative = 2 * wave.amplitude.standard_error / wave.amplitude.value;
    variance += part * part * relative * relative;
  }
  return root_of(std::max(square, 0.0), variance);
}

// Where the correlation falls to 1/e; 0 if it does not.
double correlation_length_of(const Spectrum& spectrum, double noise, double most) {
  const auto& density = spectrum.density;
  Complexes both(2 * (spectrum.density.size() - 1), 0);
  for (std::size_t j = 0; j < density.size(); ++j) {
    const bool is_end = j == 0 || j + 1 == density.size();
    const double there = (density[j] - (is_end ? 0.5 : 1) * noise) * (is_end ? 1 : 0.5);
    both[j] = there;
    if (!is_end) both[both.size() - j] = there;
  }
  both = inverse_fourier(std::move(both));
  const double step = 1 / (spectrum.step * static_cast<double>(both.size()));
  const double wanted = both[0].real() / std::numbers::e;
  for (std::size_t i = 1; static_cast<double>(i) * step < most && i < both.size() / 2; ++i) {
    const double there = both[i].real(), before = both[i - 1].real();
    if (there <= wanted) return step * (static_cast<double>(i) - (wanted - there) / (before - there));
  }
  return 0;
}

// Its error is that of ∫ density (cos 2πfℓ - 1/e) df, which is zero at the length, over the slope of the correlation there.
std::optional<Estimate> correlation_length_in(const Spectrum& spectrum, double noise) {
  const double length = correlation_length_of(spectrum, noise, 0.1 * spectrum.width);
  if (!(length > 0)) return std::nullopt;
  const double unbiased = 1 + 1 / static_cast<double>(spectrum.tapers);  // of the square of a density
  double variance = 0, slope = 0;
  for (std::size_t j = 0; j + 1 < spectrum.density.size(); ++j) {
    const double f = spectrum.frequency[j], density = spectrum.density[j];
    const auto [sine, cosine] = elementary::sine_and_cosine(2 * pi * f * length);
    const double weight = (cosine - 1 / std::numbers::e) * density;
    variance += weight * weight * spectrum.step / spectrum.width * spectrum.inflation / unbiased;
    slope += 2 * pi * f * sine * (density - noise) * spectrum.step;
  }
  const double error = std::sqrt(variance) / (std::abs(slope) * length);  // of its logarithm
  return Estimate{length, length * error, length * elementary::exp(-1.96 * error),
                  length * elementary::exp(1.96 * error)};
}

void require(const HeightTrace& trace, const TextureOptions& options) {
  const auto& z = trace.height;
  if (z.size() < fewest_heights || !(trace.step > 0))
    throw std::invalid_argument("a texture of " + std::to_string(z.size()) + " heights, where it takes " +
                                std::to_string(fewest_heights));
  if (std::any_of(z.begin(), z.end(), [](double each) { return !std::isfinite(each); }))
    throw std::invalid_argument("a height that is no number");
  if (!(root_mean_square(z) > 0)) throw std::invalid_argument("heights that are all alike");
  const double shortest = options.shortest.value_or(2 * trace.step), longest = options.longest.value_or(trace.width());
  constexpr double rounding = 1e-9;
  if (!(shortest >= (2 - rounding) * trace.step && longest > shortest && longest <= (1 + rounding) * trace.width()))
    throw std::invalid_argument("wavelengths from " + std::to_string(shortest) + " to " + std::to_string(longest) +
                                " in a trace of step " + std::to_string(trace.step));
  if (options.noise && !(*options.noise >= 0)) throw std::invalid_argument("noise below 0");
}

// Where the surface is no longer greater than the noise, from the finest on; the wavelength.
double drowns_at(const Continuum& continuum, Band within) {
  constexpr double factor = 1.01;
  double f = within.greatest;
  while (f > within.least && continuum.surface(f) < continuum.noise) f /= factor;
  return 1 / std::max(f, within.least);
}

}  // namespace

Texture texture_of(const HeightTrace& trace, const TextureOptions& options) {
  require(trace, options);
  constexpr std::size_t most_waves_found = 8;
  constexpr double steps_of_shortest = 5;  // ISO 3274: heights to the shortest wave
  Texture out{};
  out.spectrum = spectrum_of(trace.height, trace.step, options.tapers);
  out.total_height = root_mean_square(trace.height);
  out.longest = options.longest.value_or(0.25 * trace.width());

  HeightTrace rest = trace;
  Spectrum of_rest = out.spectrum;
  std::vector<DominantWave> coherent;
  while (coherent.size() < most_waves_found) {
    const auto wave = coherent_wave_in(rest, of_rest);
    if (!wave) break;
    coherent.push_back(*wave);
    rest = without_wave(std::move(rest), *wave);
    of_rest = spectrum_of(rest.height, rest.step, options.tapers);
  }

  std::optional<double> density_of_noise;
  if (options.noise) density_of_noise = 2 * *options.noise * *options.noise * trace.step;
  out.continuum = fit_continuum(of_rest, {}, density_of_noise);
  std::vector<Peak> peaks = peaks_in(of_rest, out.continuum.continuum, trace.width() / 3);
  if (!peaks.empty()) {
    std::vector<FrequencyRange> without;
    without.reserve(peaks.size());
    for (const Peak& peak : peaks) without.push_back(peak.range);
    out.continuum = fit_continuum(of_rest, without, density_of_noise);
    peaks = peaks_in(of_rest, out.continuum.continuum, trace.width() / 3);
  }
  out.waves = coherent;
  for (const Peak& peak : peaks) out.waves.push_back(peak.wave);
  std::stable_sort(out.waves.begin(), out.waves.end(),
                   [](const DominantWave& a, const DominantWave& b) { return a.amplitude.value > b.amplitude.value; });

  const double density = out.continuum.continuum.noise;
  out.noise = std::sqrt(density / (2 * trace.step));
  const Band all{1 / out.longest, out.spectrum.frequency.back()};
  const double drowned_at = density > 0 ? drowns_at(out.continuum.continuum, all) : 0;
  const double usual = steps_of_shortest * trace.step;
  out.shortest = options.shortest.value_or(std::max(usual, drowned_at));
  out.shortest_is_noise = !options.shortest && drowned_at > usual;
  const bool has_rest = out.shortest < out.longest;
  out.drowned = !has_rest && coherent.empty();
  if (!has_rest) out.shortest = std::min(usual, 0.5 * out.longest);  // its waves alone tell
  const Band band{1 / out.longest, 1 / out.shortest};
  out.rms_height = rms_within(of_rest, out.continuum, coherent, band, has_rest, [](double) { return 1.0; });
  out.rms_slope =
      rms_within(of_rest, out.continuum, coherent, band, has_rest, [](double f) { return 4 * pi * pi * f * f; });
  out.correlation_length = correlation_length_in(out.spectrum, density);
  return out;
}

}  // namespace flexslip
