#include "inference/implied_surface.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "inference/fit.h"
#include "surface/slope_friction.h"

namespace flexslip {
namespace {

constexpr double pi = std::numbers::pi;

// A fit whose mean and draws are given.
FrictionFit fit_of(const std::vector<double>& S, const std::vector<std::vector<double>>& draws) {
  FrictionFit fit{};
  fit.status = FrictionFitStatus::ok;
  fit.model = ProfileModel::roughness;
  fit.mean = {S, draws.front()};
  for (const auto& draw : draws) fit.draws.push_back({S, draw});
  return fit;
}

std::vector<double> lengths(int n) {
  std::vector<double> S;
  for (int i = 0; i <= n; ++i) S.push_back(1.05 + 0.2 * i / n);
  return S;
}

// What a wave of height, λ along the specimen, shows to a support that climbs it.
std::vector<double> shown(const std::vector<double>& S, double base, double height, double wavelength) {
  std::vector<double> mu;
  for (const double each : S)
    mu.push_back(friction_on_slope(base, -2 * pi * height / wavelength * std::sin(pi * each / wavelength)));
  return mu;
}

}  // namespace

TEST_CASE("implied surface: the wave of height that made the friction comes back (identity)") {
  const auto S = lengths(2000);
  constexpr double base = 0.58, wavelength = 0.005, height = 0.0634 * wavelength / (2 * pi);
  const auto mu = shown(S, base, height, wavelength);  // 20 whole waves
  const auto implied = implied_surface(fit_of(S, std::vector(6, mu)));
  REQUIRE(implied);
  CHECK(implied->position.front() == doctest::Approx(0.525).epsilon(1e-12));
  // Trapezoids of 100 a wave lose (2π/100)²/12 of it.
  CHECK(implied->rms_slope.value == doctest::Approx(0.0634 / std::numbers::sqrt2).epsilon(5e-3));
  CHECK(implied->rms_height.value == doctest::Approx(height / std::numbers::sqrt2).epsilon(1e-2));
  CHECK(implied->longest == doctest::Approx(0.025).epsilon(1e-12));
  for (std::size_t i = 0; i < S.size(); ++i)
    CHECK(std::abs(implied->mean.height[i] - height * std::cos(pi * S[i] / wavelength)) < 0.01 * height);
}

TEST_CASE("implied surface: its interval is that of the draws (limit)") {
  const auto S = lengths(1000);
  std::vector<std::vector<double>> draws;
  for (int i = 0; i < 20; ++i) draws.push_back(shown(S, 0.5 + 0.01 * i, 1e-4 * (1 + 0.02 * i), 0.01));
  const auto implied = implied_surface(fit_of(S, draws));
  REQUIRE(implied);
  // ln (1 + 0.02 i): mean and standard deviation by themselves.
  double mean = 0, squares = 0;
  for (int i = 0; i < 20; ++i) mean += std::log(1 + 0.02 * i) / 20;
  for (int i = 0; i < 20; ++i) squares += std::pow(std::log(1 + 0.02 * i) - mean, 2) / 19;
  CHECK(implied->rms_slope.standard_error / implied->rms_slope.value ==
        doctest::Approx(std::sqrt(squares)).epsilon(1e-3));
  CHECK(implied->rms_height.low < implied->rms_height.value * std::exp(-1.96 * std::sqrt(squares)));
}

TEST_CASE("implied surface: a trend of friction is no roughness, a constant friction no surface (limit)") {
  const auto S = lengths(1000);
  std::vector<double> trend;
  for (const double each : S) trend.push_back(0.5 + 0.2 * (each - 1.15));
  const auto drifting = implied_surface(fit_of(S, std::vector(6, trend)));
  REQUIRE(drifting);
  CHECK(drifting->rms_slope.value < 0.1 * 0.2 * 0.2 / std::sqrt(12.0));  // of the deviation of the friction itself
  CHECK_FALSE(implied_surface(fit_of(S, std::vector(6, std::vector<double>(S.size(), 0.5)))));
  FrictionFit constant{};
  constant.status = FrictionFitStatus::ok;
  CHECK_FALSE(implied_surface(constant));
}

}  // namespace flexslip
