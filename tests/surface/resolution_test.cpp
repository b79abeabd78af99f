#include <cmath>

#include <doctest/doctest.h>

#include "surface/texture.h"
#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/surface/simulated_surface.h"

namespace flexslip {

TEST_CASE(
    "resolution: the paper's own estimate (paper: section 5, a field of 450 µm, pixels of 0.04 µm for a layer of 0.4 "
    "µm)") {
  const WantedImage wanted = wanted_image(45, 0.4);
  CHECK(wanted.field == 450);
  CHECK(wanted.pixel == doctest::Approx(0.04).epsilon(1e-15));
  // Its images of that field have pixels of 0.29 µm: by its rule no wave of less than 1.45 µm.
  const WaveResolution seen = resolution_of({0.29, 450, 0.29}, 45, 0, 0.1095);
  CHECK(seen.least_by_pixels == doctest::Approx(1.45).epsilon(1e-15));
  CHECK(seen.pixel_wanted == doctest::Approx(0.0219).epsilon(1e-12));
  CHECK(seen.has_field);
  CHECK(seen.is_sampled);
  CHECK(seen.waves_in_field == 10);
}

TEST_CASE("resolution: short waves and narrow fields (limit)") {
  CHECK_FALSE(resolution_of({0.29, 450, 0.29}, 0.5, 0, 0.1).is_sampled);
  CHECK_FALSE(resolution_of({0.29, 400, 0.29}, 45, 0, 0.1).has_field);
  CHECK(min_amplitude(0, 100, 10) == 0);
  CHECK(has(message_of([] { min_amplitude(-1, 100, 10); }), "density"));
  CHECK(has(message_of([] { resolution_of({0, 1, 1}, 1, 1, 1); }), "no waves"));
}

TEST_CASE(
    "resolution: a wave of the least amplitude stands out in 95 of 100 traces of white noise (oracle: 2,000 "
    "periodograms)") {
  // Of a frequency of the grid: |Σ z exp|² 2 step/n over the density of the noise, against ln(m/α).
  constexpr int n = 256, traces = 2000, wave = 31;
  constexpr double deviation = 0.7;
  const double amplitude = min_amplitude(2 * deviation * deviation, n, n / 2);
  const double threshold = std::log(n / 2 / 0.05);
  SimulatedSurface noise(5);
  int seen = 0, falsely = 0;
  for (int trace = 0; trace < traces; ++trace) {
    bool any = false;
    std::vector<double> z(n);
    for (double& each : z) each = deviation * noise.normal();
    const auto power_at = [&](int j, double h) {
      double re = 0, im = 0;
      for (int t = 0; t < n; ++t) {
        const double angle = 2 * std::numbers::pi * j * t / n;
        const double there = z[static_cast<std::size_t>(t)] + h * std::cos(2 * std::numbers::pi * wave * t / n);
        re += there * std::cos(angle);
        im += there * std::sin(angle);
      }
      return (re * re + im * im) * 2 / n / (2 * deviation * deviation);
    };
    if (power_at(wave, amplitude) > threshold) ++seen;
    if (trace < 400)
      for (int j = 1; j < n / 2; ++j) any = any || power_at(j, 0) > threshold;
    falsely += any;
  }
  CHECK(seen > 0.93 * traces);  // 95 %, less three standard deviations of 2,000 and what the Rician's bend costs
  CHECK(seen < 0.985 * traces);
  CHECK(falsely < 0.09 * 400);  // 5 %, and three standard deviations
}

}  // namespace flexslip
