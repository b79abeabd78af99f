#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "surface/height_trace.h"
#include "surface/spectrum.h"
#include "tests/surface/simulated_surface.h"

namespace flexslip {

TEST_CASE("continuum: a folded power law is the spectrum of an autoregression (limit: AR(1) in closed form)") {
  // S(f) = Σ_m 4σ²ℓ/(1 + (2π(f + m/Δ)ℓ)²), of exp(-s/ℓ).
  constexpr double length = 2, step = 0.1;
  const double rho = std::exp(-step / length);
  const Continuum continuum{
      4 * length, 1 / (2 * std::numbers::pi * length), 1, std::numeric_limits<double>::infinity(), 0, 1 / step};
  for (const double f : {0.01, 0.1, 1.0, 3.0, 5.0}) {
    const double there =
        2 * step * (1 - rho * rho) / (1 + rho * rho - 2 * rho * std::cos(2 * std::numbers::pi * f * step));
    CHECK(continuum(f) == doctest::Approx(there).epsilon(2e-3));  // folds beyond the fourth by their integral
  }
}

TEST_CASE(
    "continuum: level, knee and power of an exponential surface are found (oracle: their truth, one long trace)") {
  SimulatedSurface surface(3);
  const auto z = levelled({0, 0.1, surface.exponential(20000, 0.1, 1, 2)}, 1).height;
  const ContinuumFit fit = fit_continuum(spectrum_of(z, 0.1, 7), {}, std::nullopt);
  CHECK_FALSE(fit.noise_found);
  CHECK(fit.continuum.power == doctest::Approx(1).epsilon(0.05));
  for (const double f : {0.02, 0.1, 1.0, 4.0}) {
    const double there = 8 / (1 + std::pow(4 * std::numbers::pi * f, 2));
    if (f < 2) CHECK(fit.continuum(f) == doctest::Approx(there).epsilon(0.15));
  }
}

TEST_CASE("continuum: stated noise is kept, and left-out frequencies do not count (limit)") {
  SimulatedSurface surface(5);
  auto z = surface.exponential(4000, 0.1, 1, 2);
  const Spectrum plain = spectrum_of(z, 0.1, 7);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] += 5 * std::cos(2 * std::numbers::pi * 0.1 * static_cast<double>(i));
  const Spectrum waved = spectrum_of(z, 0.1, 7);
  const ContinuumFit without = fit_continuum(waved, {{0.95, 1.05}}, 1e-4), with = fit_continuum(plain, {}, 1e-4);
  CHECK(without.continuum.noise == 1e-4);
  CHECK(without.continuum(1) == doctest::Approx(with.continuum(1)).epsilon(0.1));
}

}  // namespace flexslip
