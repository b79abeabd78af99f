// The hyperparameters of friction on unbounded scales, and their prior.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "inference/kernel.h"
#include "inference/search_options.h"

namespace flexslip {

inline constexpr std::size_t max_waves = 2;

struct Theta {
  // The values: ln σ, logit ρ/0.95, ln σ_g, ln ℓ, then ln λ of each wave.
  enum Place : std::size_t { log_noise, logit_correlation, log_roughness, log_length, first_wave };

  std::array<double, first_wave + max_waves> values;
  std::size_t waves = 0;

  std::size_t size() const { return first_wave + waves; }
  double log_wavelength(std::size_t wave) const { return values[first_wave + wave]; }
  void add_wave(double log_wavelength) { values[first_wave + waves++] = log_wavelength; }
};

Hyperparameters hyperparameters_of(const Theta& theta);

inline constexpr double max_correlation = 0.95;  // of ρ, the correlation between the noise of consecutive readings

// The prior of the first four values: normal, within bounds.
struct ThetaPrior {
  std::array<double, Theta::first_wave> mean, deviation, min, max;

  // The prior for readings over a range [L] of lengths and an approximate noise [EI/L^2] of the
  // force.
  static ThetaPrior of(double range, double noise, const SearchOptions& options = {});

  Theta usual(std::span<const double> log_wavelengths = {}) const;
  void bound(Theta& theta) const;
  // The density relative to its maximum, and the logarithm of this maximum. Roughness counts only
  // with a kernel.
  double log_density(Kernel kernel, const Theta& theta) const;
  double log_scale(Kernel kernel) const;
  double slope(const Theta& theta, std::size_t i) const;  // of log_density
};

}  // namespace flexslip
