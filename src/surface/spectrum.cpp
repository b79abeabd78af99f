#include "surface/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "numerics/dense.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using std::numbers::pi;

// v_k at all points: sin(kx) goes on from sin((k-1)x), sin((k-2)x) no better than by itself.
std::vector<double> taper(std::size_t k, std::size_t n) {
  effort_spent += n;
  std::vector<double> v(n);
  const auto period = static_cast<double>(n + 1);
  for (std::size_t t = 1; t <= n; ++t)
    v[t - 1] = std::sqrt(2 / period) *
               elementary::sine_and_cosine(pi * std::fmod(static_cast<double>(k) * static_cast<double>(t), 2 * period) /
                                           period)
                   .sine;
  return v;
}

// Of the transform of each tapered column.
template <class Transformed>
Coherence coherence_of(std::size_t tapers, std::size_t heights, const Transformed& transformed) {
  // Σ_t v_k(t): √(2/(n+1)) cot(πk/(2(n+1))) for odd k, 0 for even.
  const auto period = static_cast<double>(heights + 1);
  std::complex<double> along = 0;
  double square = 0, power = 0;
  for (std::size_t k = 1; k <= tapers; ++k) {
    power += std::norm(transformed(k));
    if (k % 2 == 0) continue;
    const auto [sine, cosine] = elementary::sine_and_cosine(0.5 * pi * static_cast<double>(k) / period);
    const double sum = std::sqrt(2 / period) * cosine / sine;
    along += sum * transformed(k);
    square += sum * sum;
  }
  const auto wave = along / square;
  const double explained = square * std::norm(wave);
  const double left = std::max(power - explained, 1e-300);
  const auto freedoms = static_cast<double>(tapers - 1);
  const double ratio = freedoms * explained / left;
  return {wave, ratio, elementary::exp(-freedoms * elementary::log(1 + ratio / freedoms))};
}

}  // namespace

std::size_t Spectrum::at(double f) const {
  const double index = std::round(f / step);
  return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(density.size() - 1)));
}

Spectrum spectrum_of(std::span<const double> height, double step, std::size_t tapers) {
  const std::size_t n = height.size();
  if (n < 8 || n < 2 * tapers || tapers < 2 || tapers > 50 || !(step > 0))
    throw std::invalid_argument("a spectrum of " + std::to_string(n) + " heights by " + std::to_string(tapers) +
                                " tapers");
  const std::size_t padded = power_of_two_from(2 * n);
  Spectrum out{};
  out.tapers = tapers;
  out.width = step * static_cast<double>(n);
  out.step = 1 / (step * static_cast<double>(padded));
  out.half_bandwidth = 0.5 * static_cast<double>(tapers + 1) / (step * static_cast<double>(n + 1));
  const std::size_t half = padded / 2 + 1;
  out.density.assign(half, 0);
  for (std::size_t j = 0; j < half; ++j) out.frequency.push_back(out.step * static_cast<double>(j));
  std::vector<double> weight(n, 0);
  for (std::size_t k = 1; k <= tapers; k += 2) {  // two real ones in a complex one
    const bool has_second = k + 1 <= tapers;
    const auto first = taper(k, n), second = has_second ? taper(k + 1, n) : std::vector<double>(n, 0);
    Complexes both(padded, 0);
    for (std::size_t t = 0; t < n; ++t) {
      both[t] = {first[t] * height[t], second[t] * height[t]};
      weight[t] += (first[t] * first[t] + second[t] * second[t]) / static_cast<double>(tapers);
    }
    both = fourier(std::move(both));
    Complexes one(half), other(half);
    for (std::size_t j = 0; j < half; ++j) {
      const auto direct = both[j], mirrored = std::conj(both[(padded - j) % padded]);
      one[j] = 0.5 * (direct + mirrored);
      other[j] = std::complex<double>(0, -0.5) * (direct - mirrored);
    }
    out.tapered.push_back(std::move(one));
    if (has_second) out.tapered.push_back(std::move(other));
  }
  for (std::size_t j = 0; j < half; ++j) {
    const double sides = j == 0 || j + 1 == half ? 1 : 2;
    for (const auto& each : out.tapered)
      out.density[j] += sides * step * std::norm(each[j]) / static_cast<double>(tapers);
  }
  for (const double w : weight) out.inflation += static_cast<double>(n) * w * w;
  return out;
}

DensityInterval density_interval(std::size_t tapers) {
  const double freedoms = 2 * static_cast<double>(tapers);
  return {freedoms / chi_squared_quantile(0.975, freedoms), freedoms / chi_squared_quantile(0.025, freedoms)};
}

Coherence coherence_at(const Spectrum& spectrum, std::size_t index, std::size_t heights) {
  return coherence_of(spectrum.tapers, heights, [&](std::size_t k) { return spectrum.tapered[k - 1][index]; });
}

Coherence coherence_at(std::span<const double> height, double step, std::size_t tapers, double frequency) {
  const std::size_t n = height.size();
  Complexes turned(n);
  for (std::size_t t = 0; t < n; ++t) {
    const double turns = std::fmod(frequency * step * static_cast<double>(t), 1);
    const auto [sine, cosine] = elementary::sine_and_cosine(2 * pi * turns);
    turned[t] = {height[t] * cosine, -height[t] * sine};
  }
  Complexes sums;
  for (std::size_t k = 1; k <= tapers; ++k) {
    const auto v = taper(k, n);
    std::complex<double> sum = 0;
    for (std::size_t t = 0; t < n; ++t) sum += v[t] * turned[t];
    sums.push_back(sum);
  }
  return coherence_of(tapers, n, [&](std::size_t k) { return sums[k - 1]; });
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Bin {
  double frequency, density, weight;  // weight: independent ordinates of a periodogram
};

std::vector<Bin> bins_of(const Spectrum& spectrum, const std::vector<FrequencyRange>& without) {
  constexpr double octave_twelfth = 1.0594630943592953;
  std::vector<Bin> bins;
  const double least = 1 / spectrum.width;
  double end = 0, frequency = 0, density = 0, count = 0;
  const auto close = [&] {
    if (count > 0)
      bins.push_back({frequency / count, density / count, count * spectrum.step * spectrum.width / spectrum.inflation});
    frequency = density = count = 0;
  };
  for (std::size_t j = 1; j + 1 < spectrum.density.size(); ++j) {
    const double f = spectrum.frequency[j];
    if (f < 0.75 * least) continue;
    if (std::any_of(without.begin(), without.end(),
                    [&](const auto& range) { return range.from <= f && f <= range.to; }))
      continue;
    if (f >= end) {
      close();
      end = std::max(f * octave_twelfth, f + least);
    }
    frequency += f;
    density += spectrum.density[j];
    count += 1;
  }
  close();
  return bins;
}

using Parameters = Eigen::Matrix<double, 5, 1>;  // ln level, ln knee, power, ln 1/cut², ln noise
enum Which { log_level, log_knee, power, log_decay, log_noise };

Continuum continuum_at(const Parameters& at, double folding, bool has_noise, double stated) {
  const double decay = elementary::exp(at[log_decay]);
  return {elementary::exp(at[log_level]),
          elementary::exp(at[log_knee]),
          at[power],
          decay > 0 ? 1 / std::sqrt(decay) : infinite,
          has_noise ? elementary::exp(at[log_noise]) : stated,
          folding};
}

struct Bounds {
  Parameters least, greatest;
};

class Fitting {
 public:
  Fitting(std::vector<Bin> bins, double folding, bool has_noise, double stated)
      : bins_(std::move(bins)), folding_(folding), has_noise_(has_noise), stated_(stated) {
    const double first = bins_.front().frequency, last = bins_.back().frequency;
    double most = 0, least = infinite;
    for (const Bin& bin : bins_) {
      most = std::max(most, bin.density);
      least = std::min(least, bin.density);
    }
    const auto log = [](double x) { return elementary::log(std::max(x, 1e-300)); };
    // No steeper than a power of 4 in heights, 8 in their density; no knee finer than what is seen.
    bounds_.least << log(most) - 30, log(0.3 * first), 0, log(1e-3 / (last * last)), log(least) - 10;
    bounds_.greatest << log(most) + 15, log(2 * last), 4, log(10 / (first * first)), log(most);
  }

  // Damped scoring from there; the likelihood reached.
  double climb(Parameters& at) {
    at = at.cwiseMax(bounds_.least).cwiseMin(bounds_.greatest);
    double reached = likelihood(at), damping = 1e-3;
    constexpr int max_rounds = 40;
    constexpr double enough = 1e-4;  // in ln L
    for (int round = 0; round < max_rounds; ++round) {
      Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Zero();
      Parameters gradient = Parameters::Zero();
      collect(at, information, gradient);
      bool improved = false;
      for (; damping < 1e8; damping *= 8) {
        Eigen::Matrix<double, 5, 5> damped = information;
        for (int i = 0; i < 5; ++i) damped(i, i) += damping * information(i, i) + 1e-9;
        const Parameters next =
            (at + Parameters(Symmetric(damped).solved(gradient))).cwiseMax(bounds_.least).cwiseMin(bounds_.greatest);
        const double there = likelihood(next);
        if (!(there > reached)) continue;
        improved = there - reached > enough;
        reached = there;
        at = next;
        damping = std::max(damping / 8, 1e-9);
        break;
      }
      if (!improved) break;
    }
    return reached;
  }

  double noise_error(const Parameters& at) const {
    Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Zero();
    Parameters gradient = Parameters::Zero();
    collect(at, information, gradient);
    for (int i = 0; i < 5; ++i) information(i, i) += 1e-9;
    return std::sqrt(std::max(Symmetric(information).inverse()(log_noise, log_noise), 0.0));
  }

  const std::vector<Bin>& bins() const { return bins_; }

 private:
  double likelihood(const Parameters& at) const {
    effort_spent += bins_.size();
    const Continuum model = continuum_at(at, folding_, has_noise_, stated_);
    double sum = 0;
    for (const Bin& bin : bins_) {
      const double expected = std::max(model(bin.frequency), 1e-300);
      sum -= bin.weight * (elementary::log(expected) + bin.density / expected);
    }
    return sum;
  }

  void collect(const Parameters& at, Eigen::Matrix<double, 5, 5>& information, Parameters& gradient) const {
    effort_spent += (2 * 5 + 1) * bins_.size();
    constexpr double small = 1e-4;
    std::array<std::pair<Continuum, Continuum>, 5> beside{};
    for (int i = 0; i < 5; ++i) {
      Parameters up = at, down = at;
      up[i] += small;
      down[i] -= small;
      beside[static_cast<std::size_t>(i)] = {continuum_at(up, folding_, has_noise_, stated_),
                                             continuum_at(down, folding_, has_noise_, stated_)};
    }
    const Continuum model = continuum_at(at, folding_, has_noise_, stated_);
    for (const Bin& bin : bins_) {
      const double expected = std::max(model(bin.frequency), 1e-300);
      Parameters slope;
      for (int i = 0; i < 5; ++i) {
        const auto& [up, down] = beside[static_cast<std::size_t>(i)];
        slope[i] = (up(bin.frequency) - down(bin.frequency)) / (2 * small * expected);
      }
      information += bin.weight * slope * slope.transpose();
      gradient += bin.weight * (bin.density / expected - 1) * slope;
    }
  }

  std::vector<Bin> bins_;
  double folding_;
  bool has_noise_;
  double stated_;
  Bounds bounds_{};
};

struct FittedContinuum {
  Parameters at;
  double likelihood, noise_error;
};

FittedContinuum best_of(const std::vector<Bin>& bins, double folding, bool has_noise, double stated) {
  Fitting fitting(bins, folding, has_noise, stated);
  const double first = bins.front().frequency, last = bins.back().frequency;
  double low = 0, high = 0, most = 0;
  const std::size_t few = std::max<std::size_t>(bins.size() / 8, 1);
  for (std::size_t i = 0; i < few; ++i) {
    low += bins[i].density / static_cast<double>(few);
    high += bins[bins.size() - 1 - i].density / static_cast<double>(few);
  }
  for (const Bin& bin : bins) most = std::max(most, bin.density);
  const auto log = [](double x) { return elementary::log(std::max(x, 1e-300)); };
  FittedContinuum best{Parameters::Zero(), -infinite, 0};
  for (const double share : {0.1, 0.35, 0.6})  // where the knee lies, on the logarithmic axis
    for (const bool gaussian : {false, true}) {
      const double knee = elementary::exp(log(first) + share * (log(last) - log(first)));
      Parameters at;
      at << log(std::max(low, 0.3 * most)), log(knee), gaussian ? 0.1 : 1.0,
          gaussian ? -2 * log(2 * knee) : -2 * log(10 * last), log(0.7 * high);
      const double reached = fitting.climb(at);
      if (reached > best.likelihood) best = {at, reached, 0};
    }
  best.noise_error = has_noise ? fitting.noise_error(best.at) : 0;
  return best;
}

// White noise alone.
FittedContinuum level_of(const std::vector<Bin>& bins) {
  double sum = 0, weight = 0;
  for (const Bin& bin : bins) {
    sum += bin.weight * bin.density;
    weight += bin.weight;
  }
  FittedContinuum flat{Parameters::Zero(), 0, 1 / std::sqrt(weight)};
  flat.at[log_noise] = elementary::log(std::max(sum / weight, 1e-300));
  for (const Bin& bin : bins) flat.likelihood -= bin.weight * (flat.at[log_noise] + bin.density * weight / sum);
  return flat;
}

}  // namespace

double Continuum::surface(double f) const {
  const auto one = [&](double at) {
    const double x = at / knee, y = at / cut;
    return level * elementary::exp(-power * elementary::log(1 + x * x) - y * y);
  };
  double sum = one(f);
  constexpr int folds = 4;
  for (int m = 1; m <= folds; ++m) {
    const double more = one(m * folding - f) + one(m * folding + f);
    sum += more;
    if (more < 1e-6 * sum) return sum;
  }
  // What is left of a power law beyond, on both sides.
  const double beyond = (folds + 0.5) * folding;
  if (power > 0.55) sum += 2 * one(beyond) * beyond / ((2 * power - 1) * folding);
  return sum;
}

ContinuumFit fit_continuum(const Spectrum& spectrum, const std::vector<FrequencyRange>& without,
                           std::optional<double> noise) {
  constexpr double gain_of_noise = 3, share_of_noise = 0.5;
  constexpr double gain_of_surface = 5;  // of three numbers more than a level
  const std::vector<Bin> bins = bins_of(spectrum, without);
  if (bins.size() < 6) throw std::invalid_argument("a spectrum of too few frequencies");
  const double folding = 2 * spectrum.frequency.back();
  const FittedContinuum plain = best_of(bins, folding, false, noise.value_or(0));
  ContinuumFit found{continuum_at(plain.at, folding, false, noise.value_or(0)), false, 0, plain.likelihood};
  if (noise) return found;
  const FittedContinuum flat = level_of(bins);
  if (plain.likelihood - flat.likelihood < gain_of_surface) {
    found.continuum = {0, folding, 0, infinite, elementary::exp(flat.at[log_noise]), folding};
    return {found.continuum, true, flat.noise_error, flat.likelihood};
  }
  const FittedContinuum noisy = best_of(bins, folding, true, 0);
  const Continuum with = continuum_at(noisy.at, folding, true, 0);
  if (noisy.likelihood - plain.likelihood > gain_of_noise && with.noise > share_of_noise * with(bins.back().frequency))
    found = {with, true, noisy.noise_error, noisy.likelihood};
  return found;
}

}  // namespace flexslip
