#include "surface/texture.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/surface/simulated_surface.h"

namespace flexslip {
namespace {

constexpr double pi = std::numbers::pi;

Texture texture_of_wave(double amplitude, double wavelength, double phase, double rms) {
  SimulatedSurface surface(7);
  HeightTrace trace{3, 0.1, surface.gaussian(2000, 0.1, rms, 1)};
  for (std::size_t i = 0; i < trace.height.size(); ++i)
    trace.height[i] += amplitude * std::cos(2 * pi * trace.position(i) / wavelength + phase);
  return texture_of(levelled(trace, 1));
}

}  // namespace

TEST_CASE("texture: a Gaussian surface has the slope σ√2/ℓ (limit)") {
  SimulatedSurface surface(1);
  const Texture texture = texture_of(levelled({0, 0.1, surface.gaussian(4000, 0.1, 0.06, 1)}, 1));
  const double slope = 0.06 * std::numbers::sqrt2;
  CHECK(texture.rms_slope.low < slope);
  CHECK(slope < texture.rms_slope.high);
  CHECK(texture.rms_slope.standard_error < 0.05 * slope);
  CHECK(texture.rms_height.low < 0.06);
  CHECK(0.06 < texture.rms_height.high);
  REQUIRE(texture.correlation_length);
  CHECK(texture.correlation_length->low < 1);
  CHECK(1 < texture.correlation_length->high);
  CHECK(texture.waves.empty());
}

TEST_CASE("texture: a wave's slope is its amplitude 2π/λ√2, and it is found with amplitude, length and phase (limit)") {
  const Texture texture = texture_of_wave(0.11, 10.9, 0.7, 0.01);
  REQUIRE(texture.waves.size() == 1);
  const DominantWave& wave = texture.waves.front();
  CHECK(wave.coherent);
  CHECK(wave.p_value < 1e-6);
  // Four standard errors, once in 16,000 traces.
  CHECK(std::abs(wave.wavelength.value - 10.9) < 4 * wave.wavelength.standard_error);
  CHECK(std::abs(wave.amplitude.value - 0.11) < 4 * wave.amplitude.standard_error);
  // The phase at position 0 goes with the error of the wavelength, ten waves from the middle.
  const double reach = 4 * std::hypot(2 * pi * 103 * wave.wavelength.standard_error / (10.9 * 10.9),
                                      wave.amplitude.standard_error / 0.11);
  CHECK(std::abs(wave.phase - 0.7) < reach);
  const double slope = std::hypot(2 * pi / 10.9 * 0.11 / std::numbers::sqrt2, 0.01 * std::numbers::sqrt2);
  CHECK(std::abs(texture.rms_slope.value - slope) < 4 * texture.rms_slope.standard_error);
}

TEST_CASE("texture: a wave that is taken off is gone (identity)") {
  HeightTrace trace{3, 0.1, {}};
  for (int i = 0; i < 1000; ++i) trace.height.push_back(0.2 * std::cos(2 * pi * (3 + 0.1 * i) / 7 + 1.2));
  const HeightTrace rest = without_wave(trace, {{7, 0, 7, 7}, {0.2, 0, 0.2, 0.2}, 0, true, 1.2});
  CHECK(root_mean_square(rest.height) < 1e-14);
}

TEST_CASE("texture: white noise is found on a smooth surface, and told apart from an exponential one (limit)") {
  SimulatedSurface surface(4);
  auto noisy = surface.gaussian(4000, 0.1, 0.06, 1);
  for (double& each : noisy) each += 0.006 * surface.normal();
  const Texture texture = texture_of(levelled({0, 0.1, noisy}, 1));
  CHECK(texture.continuum.noise_found);
  CHECK(texture.shortest_is_noise);
  CHECK(texture.noise == doctest::Approx(0.006).epsilon(0.05));
  int found = 0;
  constexpr int traces = 20;
  for (int trace = 0; trace < traces; ++trace)
    found += texture_of(levelled({0, 0.1, surface.exponential(2000, 0.1, 0.03, 2)}, 1)).continuum.noise_found;
  CHECK(found <= 2);
}

TEST_CASE("texture: of noise alone nothing is said (limit)") {
  SimulatedSurface surface(9);
  std::vector<double> z;
  for (int i = 0; i < 1000; ++i) z.push_back(surface.normal());
  const Texture texture = texture_of({0, 0.1, z});
  CHECK(texture.drowned);
  CHECK(texture.noise == doctest::Approx(1).epsilon(0.1));
}

TEST_CASE("texture: waves are found by chance in no more traces than said (oracle: 100 traces)") {
  SimulatedSurface surface(11);
  int waves = 0;
  for (int trace = 0; trace < 100; ++trace) {
    const auto z = trace % 2 == 0 ? surface.gaussian(1000, 0.1, 0.06, 0.8) : surface.exponential(1000, 0.1, 0.03, 2);
    waves += !texture_of(levelled({0, 0.1, z}, 1)).waves.empty();
  }
  CHECK(waves <= 8);  // at 1 % twice, coherent and not, and three standard deviations
}

TEST_CASE("texture: what is asked for holds, and bad input is refused (limit)") {
  SimulatedSurface surface(12);
  const HeightTrace trace{0, 0.1, surface.gaussian(1000, 0.1, 0.06, 1)};
  const Texture texture = texture_of(trace, {.shortest = 2, .longest = 20, .noise = 0.001});
  CHECK(texture.shortest == 2);
  CHECK(texture.longest == 20);
  CHECK(texture.noise == doctest::Approx(0.001).epsilon(1e-12));
  CHECK(texture.rms_slope.value < texture_of(trace).rms_slope.value);
  CHECK(has(message_of([] { texture_of({0, 0.1, std::vector<double>(10, 1.0)}); }), "10 heights"));
  CHECK(has(message_of([] { texture_of({0, 0.1, std::vector<double>(100, 0.0)}); }), "all alike"));
  CHECK(has(message_of([&] { texture_of(trace, {.shortest = 0.1}); }), "wavelengths from 0.1"));
  CHECK(has(message_of([&] { texture_of(trace, {.longest = 101}); }), "to 101"));
  CHECK(has(message_of([&] { texture_of(trace, {.noise = -1.0}); }), "noise"));
}

}  // namespace flexslip
