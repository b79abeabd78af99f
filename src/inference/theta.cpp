#include "inference/theta.h"

#include <algorithm>
#include <numbers>

#include "numerics/elementary.h"

namespace flexslip {

namespace {

std::size_t counting(Kernel kernel) { return kernel == Kernel::none ? Theta::log_roughness : Theta::first_wave; }

}  // namespace

Hyperparameters hyperparameters_of(const Theta& theta) {
  return {.noise = elementary::exp(theta.values[Theta::log_noise]),
          .correlation = max_correlation / (1 + elementary::exp(-theta.values[Theta::logit_correlation])),
          .roughness = elementary::exp(theta.values[Theta::log_roughness]),
          .length = elementary::exp(theta.values[Theta::log_length])};
}

ThetaPrior ThetaPrior::of(double range, double noise, const SearchOptions& options) {
  const double min_noise = std::max(options.min_noise, options.min_noise_seen * noise);
  const double log_noise = elementary::log(min_noise), log_range = elementary::log(range);
  return {.mean = {elementary::log(0.03), -1, elementary::log(0.03), elementary::log(range / 10)},
          .deviation = {1, 1.5, 1, 1.2},
          .min = {log_noise, -6, elementary::log(0.001), log_range - 6},
          .max = {std::max(elementary::log(0.5), log_noise + 1), 6, elementary::log(0.6), log_range + 1}};
}

Theta ThetaPrior::usual(std::span<const double> log_wavelengths) const {
  Theta theta{};
  std::copy(mean.begin(), mean.end(), theta.values.begin());
  for (const double value : log_wavelengths) theta.add_wave(value);
  return theta;
}

void ThetaPrior::bound(Theta& theta) const {
  for (std::size_t i = 0; i < Theta::first_wave; ++i) theta.values[i] = std::clamp(theta.values[i], min[i], max[i]);
}

double ThetaPrior::log_density(Kernel kernel, const Theta& theta) const {
  double sum = 0;
  for (std::size_t i = 0; i < counting(kernel); ++i) {
    const double z = (theta.values[i] - mean[i]) / deviation[i];
    sum -= 0.5 * z * z;
  }
  return sum;
}

double ThetaPrior::log_scale(Kernel kernel) const {
  double sum = 0;
  for (std::size_t i = 0; i < counting(kernel); ++i)
    sum -= elementary::log(deviation[i]) + 0.5 * elementary::log(2 * std::numbers::pi);
  return sum;
}

double ThetaPrior::slope(const Theta& theta, std::size_t i) const {
  return -(theta.values[i] - mean[i]) / (deviation[i] * deviation[i]);
}

}  // namespace flexslip
