#include "surface/texture.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/effort.h"
#include "numerics/elementary.h"
#include "numerics/minimum.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using std::numbers::pi;

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
  return scaled(exponential(normal_estimate(0, error)), length);
}

void require_texture(const HeightTrace& trace, const TextureOptions& options) {
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
  require_texture(trace, options);
  constexpr std::size_t max_waves_found = 8;
  constexpr double steps_of_shortest = 5;  // ISO 3274: heights to the shortest wave
  Texture out{};
  out.spectrum = spectrum_of(trace.height, trace.step, options.tapers);
  out.total_height = root_mean_square(trace.height);
  out.longest = options.longest.value_or(0.25 * trace.width());

  HeightTrace rest = trace;
  Spectrum of_rest = out.spectrum;
  std::vector<DominantWave> coherent;
  while (coherent.size() < max_waves_found) {
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

namespace {

constexpr double leaks = 1e-5;  // of the highest density: below, tapers leak, and neighbours are not independent

// Σ weight z exp(-2πi f s) over the trace, s from its middle; the weights are those of the first sine taper.
class Demodulator {
 public:
  explicit Demodulator(const HeightTrace& trace) : trace_(trace) {
    const std::size_t n = trace.height.size();
    for (std::size_t t = 0; t < n; ++t) {
      const double weight =
          elementary::sine_and_cosine(pi * static_cast<double>(t + 1) / static_cast<double>(n + 1)).sine;
      const double x = trace.step * (static_cast<double>(t) - 0.5 * static_cast<double>(n - 1));
      weight_.push_back(weight);
      sum_ += weight;
      squares_ += weight * weight;
      spread_ += weight * x * x;
      square_spread_ += weight * weight * x * x;
    }
  }

  // Amplitude and phase of the wave of least squares, as a complex number.
  std::complex<double> wave(double f) const {
    constexpr std::size_t anew = 256;  // steps after which the turning begins from an exact angle
    const std::size_t n = weight_.size();
    effort_spent += n;
    std::complex<double> sum = 0, turn = 1;
    const auto one = elementary::sine_and_cosine(2 * pi * std::fmod(f * trace_.step, 1));
    const std::complex<double> step{one.cosine, -one.sine};
    for (std::size_t t = 0; t < n; ++t) {
      if (t % anew == 0) {
        const double turns = f * trace_.step * (static_cast<double>(t) - 0.5 * static_cast<double>(n - 1));
        const auto at = elementary::sine_and_cosine(2 * pi * std::fmod(turns, 1));
        turn = {at.cosine, -at.sine};
      }
      sum += weight_[t] * trace_.height[t] * turn;
      turn = {turn.real() * step.real() - turn.imag() * step.imag(),
              turn.real() * step.imag() + turn.imag() * step.real()};
    }
    return 2.0 * sum / sum_;
  }

  double middle() const { return trace_.begin + 0.5 * trace_.step * static_cast<double>(weight_.size() - 1); }

  // Standard errors in white noise of a density [L^3].
  double amplitude_error(double density) const { return std::sqrt(2 * squares_ * density / (2 * trace_.step)) / sum_; }
  double frequency_error(double density, double amplitude) const {
    return std::sqrt(2 * square_spread_ * density / (2 * trace_.step)) / (amplitude * spread_ * 2 * pi);
  }

 private:
  const HeightTrace& trace_;
  std::vector<double> weight_;
  double sum_ = 0, squares_ = 0, spread_ = 0, square_spread_ = 0;
};

// The frequency of the greatest amplitude about a guess.
double refined(const Demodulator& demodulator, double guess, double half_range) {
  const auto power = [&](double frequency) { return std::norm(demodulator.wave(frequency)); };
  return greatest_within(power, guess - half_range, guess + half_range, 1e-9 * guess).at;
}

// [L^3] Of the neighbours of a frequency on both sides, beyond the bandwidth; null where there are none below.
std::optional<double> density_about(const Spectrum& spectrum, double f) {
  const double band = 2 * spectrum.half_bandwidth;
  if (f - 2 * band < 1 / spectrum.width) return std::nullopt;
  // Medians, which a wave among the neighbours does not raise.
  const auto usual = [&](double from, double to) {
    const auto first = static_cast<std::ptrdiff_t>(spectrum.at(std::max(from, 1 / spectrum.width)));
    const auto last = static_cast<std::ptrdiff_t>(spectrum.at(to)) + 1;
    std::vector<double> some(spectrum.density.begin() + first, spectrum.density.begin() + last);
    std::nth_element(some.begin(), some.begin() + (last - first) / 2, some.end());
    const double freedoms = 2 * static_cast<double>(spectrum.tapers), root = 1 - 2 / (9 * freedoms);
    return some[static_cast<std::size_t>(last - first) / 2] /
           (root * root * root);  // Wilson and Hilferty: mean over median
  };
  const double below = usual(f - 3 * band, f - band), above = usual(f + band, f + 3 * band);
  return std::max(std::sqrt(below * above), above);
}

double independent_frequencies(const Spectrum& spectrum) { return spectrum.width * spectrum.frequency.back(); }

}  // namespace

std::optional<DominantWave> coherent_wave_in(const HeightTrace& trace, const Spectrum& spectrum) {
  constexpr double level = 0.01;
  constexpr double worth_a_look = 1e-3;  // on the grid, which may miss the wave's frequency by a quarter of 1/width
  constexpr std::size_t max_looks = 10;
  const double first = 1.5 * spectrum.half_bandwidth, last = spectrum.frequency.back() - spectrum.half_bandwidth;
  const double among = independent_frequencies(spectrum);
  const std::size_t n = trace.height.size();
  const double least = leaks * *std::max_element(spectrum.density.begin(), spectrum.density.end());
  std::vector<std::pair<double, std::size_t>> candidates;
  for (std::size_t j = spectrum.at(first); j <= spectrum.at(last); ++j) {
    if (!(spectrum.density[j] > least)) continue;
    const Coherence coherence = coherence_at(spectrum, j, n);
    if (!(coherence.p_value < worth_a_look)) continue;
    const auto about = density_about(spectrum, spectrum.frequency[j]);
    if (about && spectrum.density[j] > 3 * *about) candidates.emplace_back(std::norm(coherence.wave), j);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  if (candidates.size() > max_looks) candidates.resize(max_looks);
  if (candidates.empty()) return std::nullopt;
  const Demodulator demodulator(trace);
  for (const auto& [size, index] : candidates) {
    const double f = refined(demodulator, spectrum.frequency[index], 1.5 * spectrum.step);
    // Two looks at each independent frequency: the grid is as fine.
    const double p_value = 2 * among * coherence_at(trace.height, trace.step, spectrum.tapers, f).p_value;
    const auto density = density_about(spectrum, f);
    if (!(p_value < level) || !density) continue;
    const auto wave = demodulator.wave(f);
    const double amplitude = std::sqrt(std::norm(wave)), df = demodulator.frequency_error(*density, amplitude);
    DominantWave out{normal_estimate(1 / f, df / (f * f)),
                     normal_estimate(amplitude, demodulator.amplitude_error(*density)), p_value, true, 0};
    const double turns = f * demodulator.middle();
    out.phase = elementary::angle(wave.imag(), wave.real()) - 2 * pi * (turns - std::round(turns));
    out.phase -= 2 * pi * std::round(out.phase / (2 * pi));
    return out;
  }
  return std::nullopt;
}

HeightTrace without_wave(HeightTrace trace, const DominantWave& wave) {
  for (std::size_t i = 0; i < trace.height.size(); ++i) {
    const double turns = trace.position(i) / wave.wavelength.value;
    const double angle = 2 * pi * (turns - std::round(turns)) + wave.phase;
    trace.height[i] -= wave.amplitude.value * elementary::sine_and_cosine(angle).cosine;
  }
  return trace;
}

std::vector<Peak> peaks_in(const Spectrum& spectrum, const Continuum& continuum, double longest) {
  constexpr double level = 0.01;
  const double freedoms = 2 * static_cast<double>(spectrum.tapers), among = independent_frequencies(spectrum);
  const double band = spectrum.half_bandwidth;
  std::vector<Peak> peaks;
  const auto& density = spectrum.density;
  const double least = leaks * *std::max_element(density.begin(), density.end());
  for (std::size_t j = std::max<std::size_t>(spectrum.at(1 / longest), 1); j + 1 < density.size(); ++j) {
    if (!(density[j] > density[j - 1] && density[j] >= density[j + 1] && density[j] > least)) continue;
    const double f = spectrum.frequency[j];
    const auto about = density_about(spectrum, f);
    if (!about) continue;
    const double p_of_one = chi_squared_beyond(freedoms * density[j] / std::max(*about, continuum(f)), freedoms);
    const double p = std::min(among * p_of_one, 1.0);
    if (!(p < level)) continue;
    // From where to where it stands out by half of its height.
    const auto stands_out = [&](std::size_t i) { return density[i] > 0.5 * (density[j] + continuum(f)); };
    std::size_t from = j, to = j;
    while (from > 1 && stands_out(from - 1)) --from;
    while (to + 1 < density.size() && stands_out(to + 1)) ++to;
    const FrequencyRange range{spectrum.frequency[from] - 0.5 * band, spectrum.frequency[to] + 0.5 * band};
    double power = 0, moment = 0, second = 0, variance = 0;
    for (std::size_t i = spectrum.at(std::max(range.from, spectrum.step)); i <= spectrum.at(range.to); ++i) {
      const double more = std::max(density[i] - continuum(spectrum.frequency[i]), 0.0) * spectrum.step;
      power += more;
      moment += more * spectrum.frequency[i];
      second += more * spectrum.frequency[i] * spectrum.frequency[i];
      variance += density[i] * density[i] * spectrum.step / spectrum.width;
    }
    const double middle = moment / power, width = std::sqrt(std::max(second / power - middle * middle, 0.0));
    const double amplitude = std::sqrt(2 * power), error = std::sqrt(variance) / amplitude;
    peaks.push_back(
        {{normal_estimate(1 / middle, width / (middle * middle)), normal_estimate(amplitude, error), p, false, 0},
         range});
  }
  // Of peaks that overlap the highest.
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Peak& a, const Peak& b) { return a.wave.amplitude.value > b.wave.amplitude.value; });
  std::vector<Peak> apart;
  for (Peak& peak : peaks)
    if (std::none_of(apart.begin(), apart.end(), [&](const Peak& higher) {
          return peak.range.from < higher.range.to && higher.range.from < peak.range.to;
        }))
      apart.push_back(peak);
  return apart;
}

double min_amplitude(double density, double width, std::size_t frequencies) {
  constexpr double by_chance = 0.05;
  constexpr double of_20_missed = 1.6448536269514722 / 1.4142135623730951;  // of |1 + noise|, in one of its components
  if (!(density >= 0 && width > 0) || frequencies == 0)
    throw std::invalid_argument("the least amplitude in a field of " + std::to_string(width) + " and a density of " +
                                std::to_string(density));
  const double among = elementary::log(static_cast<double>(frequencies) / by_chance);
  return std::sqrt(2 * density / width) * (std::sqrt(among) + of_20_missed);
}

WaveResolution resolution_of(const TraceResolution& trace, double wavelength, double density, double amplitude) {
  if (!(trace.step > 0 && trace.width > 0 && trace.pixel >= 0 && wavelength > 0))
    throw std::invalid_argument("a trace of step " + std::to_string(trace.step) + " and width " +
                                std::to_string(trace.width) + " shows no waves of " + std::to_string(wavelength));
  const double heights = trace.width / trace.step;
  const auto frequencies = static_cast<std::size_t>(std::fmax(1, std::floor(0.5 * heights)));
  WaveResolution out{};
  out.wavelength = wavelength;
  out.heights_a_wave = wavelength / trace.step;
  out.waves_in_field = trace.width / wavelength;
  out.least_by_pixels = 0.5 * pixels_wanted * trace.pixel;
  out.least_by_spectrum = min_amplitude(density, trace.width, frequencies);
  out.pixel_wanted = wanted_image(wavelength, 2 * amplitude).pixel;
  out.is_sampled = out.heights_a_wave >= 2;
  out.has_field = out.waves_in_field >= periods_wanted;
  return out;
}

WantedImage wanted_image(double wavelength, double crest_to_trough) {
  return {periods_wanted * wavelength, crest_to_trough / pixels_wanted};
}

}  // namespace flexslip
