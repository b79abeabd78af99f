#include "surface/waves_in_trace.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

#include "fibre/chi_squared.h"
#include "fibre/elementary.h"

namespace flexslip {
namespace {

constexpr double pi = std::numbers::pi;
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
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double low = guess - half_range, high = guess + half_range;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = std::norm(demodulator.wave(a)), at_b = std::norm(demodulator.wave(b));
  for (int i = 0; i < 40 && high - low > 1e-9 * guess; ++i) {
    if (at_a > at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = std::norm(demodulator.wave(a));
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = std::norm(demodulator.wave(b));
    }
  }
  return 0.5 * (low + high);
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
  constexpr std::size_t most_looks = 10;
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
  if (candidates.size() > most_looks) candidates.resize(most_looks);
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

}  // namespace flexslip
