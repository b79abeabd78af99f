#include "surface/spectrum.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/surface/simulated_surface.h"

namespace flexslip {

TEST_CASE("spectrum: tapers and sums as they are written (oracle)") {
  SimulatedSurface surface(1);
  constexpr std::size_t n = 100, tapers = 5;
  std::vector<double> z;
  for (std::size_t i = 0; i < n; ++i) z.push_back(surface.normal());
  const Spectrum spectrum = spectrum_of(z, 0.3, tapers);
  for (const std::size_t j : {1u, 7u, 50u, 127u}) {
    double density = 0;
    for (std::size_t k = 1; k <= tapers; ++k) {
      std::complex<double> sum = 0;
      for (std::size_t t = 1; t <= n; ++t)
        sum += std::sqrt(2.0 / (n + 1)) * std::sin(std::numbers::pi * static_cast<double>(k * t) / (n + 1)) * z[t - 1] *
               std::polar(1.0, -2 * std::numbers::pi * spectrum.frequency[j] * 0.3 * static_cast<double>(t));
      density += 2 * 0.3 * std::norm(sum) / tapers;
    }
    CHECK(spectrum.density[j] == doctest::Approx(density).epsilon(1e-12));
  }
  CHECK(spectrum.frequency.back() == doctest::Approx(0.5 / 0.3).epsilon(1e-15));
}

TEST_CASE("spectrum: its integral is the mean square, on average (identity: white noise, 400 traces)") {
  SimulatedSurface surface(2);
  double ratio = 0;
  for (int trace = 0; trace < 400; ++trace) {
    std::vector<double> z;
    for (int i = 0; i < 256; ++i) z.push_back(surface.normal());
    const Spectrum spectrum = spectrum_of(z, 0.1, 7);
    double sum = 0;
    for (const double density : spectrum.density) sum += density * spectrum.step;
    ratio += sum / 400;
  }
  CHECK(std::abs(ratio - 1) <
        3 * std::sqrt(2.0 / 256 / 400) * 1.2 + 1.0 / 512);  // three standard errors; the ends count whole
}

TEST_CASE("spectrum: the interval of a density (table: 14 freedoms)") {
  const DensityInterval interval = density_interval(7);
  CHECK(interval.low == doctest::Approx(14 / 26.118948045037).epsilon(1e-9));
  CHECK(interval.high == doctest::Approx(14 / 5.6287261030397).epsilon(1e-9));
}

TEST_CASE("spectrum: a wave alone is coherent, with its amplitude; noise is so as often as it should (limit, oracle)") {
  constexpr std::size_t n = 512;
  std::vector<double> z;
  SimulatedSurface surface(3);
  for (std::size_t i = 0; i < n; ++i)
    z.push_back(2 * std::cos(2 * std::numbers::pi * 32 * static_cast<double>(i) / n) + 1e-3 * surface.normal());
  const Spectrum spectrum = spectrum_of(z, 1, 7);
  const Coherence there = coherence_at(spectrum, spectrum.at(32.0 / n), n);
  CHECK(2 * std::abs(there.wave) ==
        doctest::Approx(2).epsilon(1e-3));  // its own noise, 1e-3 √(2/n) of each, and the mirror of it
  CHECK(there.p_value < 1e-12);
  const Coherence anywhere = coherence_at(z, 1, 7, spectrum.frequency[spectrum.at(32.0 / n)]);
  CHECK(std::abs(anywhere.wave) == doctest::Approx(std::abs(there.wave)).epsilon(1e-12));
  CHECK(anywhere.ratio == doctest::Approx(there.ratio).epsilon(1e-6));
  int often = 0;
  constexpr int traces = 2000;
  for (int trace = 0; trace < traces; ++trace) {
    for (double& each : z) each = surface.normal();
    if (coherence_at(spectrum_of(z, 1, 7), 300, n).p_value < 0.05) ++often;
  }
  CHECK(std::abs(often / double{traces} - 0.05) < 3 * std::sqrt(0.05 * 0.95 / traces));
}

TEST_CASE("spectrum: too few heights (limit)") {
  CHECK(has(message_of([] { spectrum_of(std::vector<double>(7, 0.0), 1, 2); }), "7 heights"));
}

}  // namespace flexslip
