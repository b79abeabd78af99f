#include "surface/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "fibre/chi_squared.h"
#include "fibre/elementary.h"

namespace flexslip {
namespace {

constexpr double pi = std::numbers::pi;

// v_k at all points: sin(kx) goes on from sin((k-1)x), sin((k-2)x) no better than by itself.
std::vector<double> taper(std::size_t k, std::size_t n) {
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

}  // namespace flexslip
