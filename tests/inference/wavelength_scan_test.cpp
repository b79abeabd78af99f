#include "inference/wavelength_scan.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

// Points as a test yields them, on a wave, a slow drift and noise.
std::vector<ProfilePoint> points_on(double amplitude, double wavelength, double drift, double noise) {
  std::mt19937_64 generator(7);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  std::vector<ProfilePoint> points;
  for (std::size_t i = 0; i < 250; ++i) {
    const double S = 1.02 + 0.28 * static_cast<double>(i) / 250;
    const double mu = 0.6 + drift * std::sin(4 * (S - 1)) +
                      amplitude * std::cos(std::numbers::pi * S / wavelength + 1) +
                      noise * std::sqrt(12.0) * (uniform() - 0.5);
    points.push_back({.index = i,
                      .S = S,
                      .mu = mu,
                      .from_force = noise,
                      .from_bending_stiffness = 0,
                      .from_contact = 0,
                      .mu_log_stiffness = -1,
                      .mu_force = 0.2});
  }
  return points;
}

TEST_CASE("identity: the wavelength put in comes out, under a drift ten times as high") {
  for (const double wavelength : {0.006, 0.01, 0.02, 0.035}) {
    const auto scan = scan_wavelengths(points_on(0.03, wavelength, 0.3, 0.01), {.least_wavelength = 0.003});
    REQUIRE(!scan.candidates.empty());
    const double resolution = wavelength * wavelength / 0.14 / 8;  // the step of the scan
    CHECK(std::abs(scan.candidates.front().wavelength - wavelength) <= resolution);
    CHECK(scan.candidates.front().log_likelihood_gain > 10);
    CHECK(std::hypot(scan.candidates.front().cosine, scan.candidates.front().sine) ==
          doctest::Approx(0.03).scale(0).epsilon(0.15));
  }
}

TEST_CASE("limit: noise alone gains no more than the number of wavelengths tried explains") {
  const auto scan = scan_wavelengths(points_on(0, 0.01, 0.3, 0.01), {.least_wavelength = 0.003});
  // The greatest of n exponential gains exceeds ln n + 5 once in 150 times; the seed is fixed.
  CHECK(scan.candidates.front().log_likelihood_gain < std::log(static_cast<double>(scan.wavelengths.size())) + 5);
}

TEST_CASE("limit: too few points are refused") {
  const auto points = points_on(0.03, 0.01, 0, 0.01);
  CHECK_THROWS_AS(scan_wavelengths(std::span(points).first(19), {.least_wavelength = 0.003}), std::invalid_argument);
}

}  // namespace
}  // namespace flexslip
