// Tests made by the model, with known truth, for the benchmarks that judge answers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bending_test/history.h"
#include "bending_test/sliding_table.h"
#include "inference/chain.h"
#include "inference/fit.h"
#include "inference/prior_draws.h"

namespace flexslip {

inline constexpr double pi = std::numbers::pi;
inline constexpr double span = 1278;  // µm, the authors'

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; }
  double between(double a, double b) { return a + (b - a) * uniform(); }
  double normal() { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * pi * uniform()); }

 private:
  std::mt19937_64 generator_;
};

// The same tests for the same kind and number, on any machine.
inline Random random_of(const std::string& kind, int test) {
  std::uint64_t of_kind = 1469598103934665603u;
  for (const char c : kind) of_kind = (of_kind ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return Random(of_kind + static_cast<std::uint64_t>(test) * 7919);
}

struct Wave {
  double amplitude, wavelength, phase;  // [1] of μ, µm, rad at the straight fibre's support
};

struct Truth {
  double mu0 = 0, stiffening = 1, k = 0, noise = 0, correlation = 0, roughness = 0, length = 30;
  bool overshoots = false;                // its snaps do
  double static_excess = 0, depth = 0.4;  // [1] of static friction over the kinetic one, [L] of the deflection
  std::vector<Wave> waves;
  std::vector<double> bumps;  // of the fibre, so many µm apart
  double spacing = 1;
  double mu(double S) const {
    double mu = mu0;
    for (const auto& wave : waves) mu += wave.amplitude * std::cos(pi * S * span / wave.wavelength + wave.phase);
    if (!bumps.empty()) {
      const double x = std::min(0.5 * (S - 1) * span / spacing, static_cast<double>(bumps.size() - 2));
      const auto i = static_cast<std::size_t>(x);
      const double part = x - static_cast<double>(i);
      mu += (1 - part) * bumps[i] + part * bumps[i + 1];
    }
    return std::max(mu, 0.01);
  }
};

// Roughness with a Matérn kernel, each quarter of a µm.
inline std::vector<double> matern_bumps(double rms, double length, Random& random, Kernel kernel = Kernel::matern_3_2) {
  Observations observations;
  for (int i = 0; i < 1680; ++i) {
    observations.all.push_back(
        {.place = 0.25 * i / span, .rows = 0, .noise_gain = 0, .variance = std::numeric_limits<double>::infinity()});
    observations.values.push_back(0);
    observations.columns.emplace_back(Coefficients::Zero(0));
  }
  NormalSource normal(static_cast<std::uint64_t>(random.uniform() * 1e15));
  return PriorDraws(observations, kernel,
                    {.noise = 1, .correlation = 0, .roughness = rms, .length = length / span})(normal)
      .f;
}

// Gaussian roughness a µm apart: exponentially correlated, or smooth as exp(-(x/30)^2/2) by a moving average.
inline std::vector<double> bumps_of(bool smooth, double rms, Random& random) {
  constexpr int n = 420;
  constexpr double length = 30;
  std::vector<double> bumps(n);
  if (!smooth) {
    const double kept = std::exp(-1 / length);
    double x = random.normal();
    for (auto& value : bumps) {
      value = rms * x;
      x = kept * x + std::sqrt(1 - kept * kept) * random.normal();
    }
    return bumps;
  }
  constexpr int reach = 100;
  std::vector<double> white(n + 2 * reach), kernel;
  double power = 0;
  for (auto& value : white) value = random.normal();
  for (int j = -reach; j <= reach; ++j) {
    kernel.push_back(std::exp(-static_cast<double>(j) * j / (length * length)));
    power += kernel.back() * kernel.back();
  }
  for (int i = 0; i < n; ++i) {
    double sum = 0;
    for (int j = 0; j <= 2 * reach; ++j)
      sum += kernel[static_cast<std::size_t>(j)] * white[static_cast<std::size_t>(i) + static_cast<std::size_t>(j)];
    bumps[static_cast<std::size_t>(i)] = rms * sum / std::sqrt(power);
  }
  return bumps;
}

// So smooth that hardly anything of it is shorter than its length [µm], as exp(-(x/length)^2/2), each quarter of a µm.
inline std::vector<double> smooth_bumps(double rms, double length, Random& random) {
  constexpr double spacing = 0.25;
  const auto reach = static_cast<int>(std::ceil(2.2 * length / spacing));
  std::vector<double> kernel, white, bumps;
  double power = 0;
  for (int j = -reach; j <= reach; ++j) {
    const double x = j * spacing / length;
    kernel.push_back(std::exp(-x * x));
    power += kernel.back() * kernel.back();
  }
  constexpr int count = 1680;
  for (int i = 0; i < count + 2 * reach; ++i) white.push_back(random.normal());
  for (int i = 0; i < count; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < kernel.size(); ++j) sum += kernel[j] * white[static_cast<std::size_t>(i) + j];
    bumps.push_back(rms * sum / std::sqrt(power));
  }
  return bumps;
}

inline constexpr std::array kinds_of_tests{
    "independent", "correlated", "exponential", "squared_exponential", "roughness", "two_waves", "constant", "soft",
    "quiet",       "measured",   "smooth",      "overshoot",           "stick_slip"};

// The tests [first, first + count) of a kind.
struct TestsAsked {
  std::string kind;
  int first, tests;
};

// The command line PROGRAM KIND FIRST COUNT; empty, after a message, if it is wrong.
inline std::optional<TestsAsked> tests_asked(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: %s KIND FIRST COUNT\n", arguments[0]);
    return std::nullopt;
  }
  const std::string kind = arguments[1];
  if (std::find(kinds_of_tests.begin(), kinds_of_tests.end(), kind) == kinds_of_tests.end()) {
    std::fprintf(stderr, "%s is no kind of test\n", kind.c_str());
    return std::nullopt;
  }
  return TestsAsked{kind, std::atoi(arguments[2]), std::atoi(arguments[3])};
}

// Domain:     a kind among kinds_of_tests.
inline Truth truth_of(const std::string& kind, Random& random) {
  Truth t;
  t.mu0 = random.between(0.3, 0.9);
  const double A = random.between(0.03, 0.33), lambda = random.between(8, 58), phase = random.between(0, 2 * pi);
  t.noise = random.between(0.01, 0.05);
  t.stiffening = std::exp(0.03 * random.normal());
  t.k = 90 / std::exp(random.between(std::log(0.36), std::log(3.2)));
  if (kind == "overshoot") t.noise = random.between(0.004, 0.025);
  if (kind == "quiet") t.noise = random.between(0.001, 0.004);
  if (kind == "soft") t.k = std::exp(random.between(std::log(6), std::log(44)));
  t.overshoots = kind == "overshoot";
  t.correlation = kind == "independent" || t.overshoots || kind == "constant" || kind == "quiet" ? 0 : 0.7;
  if (kind == "stick_slip") {  // the same everywhere, but more where the specimen rested
    t.correlation = 0;
    t.mu0 = random.between(0.2, 0.7);
    t.k = std::exp(random.between(std::log(20), std::log(300)));
    t.noise = std::exp(random.between(std::log(0.0005), std::log(0.01)));
    t.static_excess = random.between(0.04, 0.3);
    t.depth = random.between(0.15, 0.4);
    return t;
  }
  if (kind == "soft") {
    t.correlation = 0;
    t.waves = {{t.mu0 * std::min(A, 0.24 / t.mu0), random.between(8, 16), phase}};
  } else if (kind == "measured" || kind == "smooth") {  // as rough and as quiet as the authors' specimens
    t.noise = random.between(0.005, 0.015);
    t.k = random.between(18, 35);
    t.correlation = 0.3;
    t.roughness = random.between(0.04, 0.2);
    t.length = random.between(4, 15);
    t.bumps =
        kind == "smooth" ? smooth_bumps(t.roughness, t.length, random) : matern_bumps(t.roughness, t.length, random);
    t.spacing = 0.25;
  } else if (kind != "roughness" && kind != "constant") {
    t.waves = {{t.mu0 * A, lambda, phase}};
  }
  if (kind == "two_waves")
    t.waves.push_back(
        {t.mu0 * random.between(0.03, 0.2), lambda * (random.uniform() < 0.5 ? 0.4 : 1.9), random.between(0, 2 * pi)});
  if (kind == "exponential" || kind == "squared_exponential") t.roughness = 0.03;
  if (kind == "roughness") t.roughness = random.between(0.03, 0.06);
  const bool smooth = kind == "squared_exponential" || (kind == "roughness" && random.uniform() < 0.5);
  if (t.roughness > 0 && t.bumps.empty()) t.bumps = bumps_of(smooth, t.roughness, random);
  return t;
}

// A record up to the depth of the test, of forces [EI/L^2] in units of the nominal bending stiffness.
inline FitProblem measured(std::span<const double> stages, std::span<const double> forces, const Truth& t,
                           Random& random) {
  FitProblem problem{.record = {}, .rig = {t.k}, .errors = {.force = t.noise, .bending_stiffness = 0.03, .contact = 0}};
  double e = random.normal();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (stages[i] - forces[i] / t.k > t.depth) break;
    const double force = forces[i] + t.noise * e;
    e = t.correlation * e + std::sqrt(1 - t.correlation * t.correlation) * random.normal();
    problem.record.stage.push_back(stages[i]);
    problem.record.force.push_back(force);
    problem.record.deflection.push_back(stages[i] - force / t.k);
  }
  return problem;
}

// [EI/L^2] of the nominal bending stiffness.
inline FitProblem stick_slip(const Truth& t, std::span<const double> stages, Random& random) {
  std::vector<double> within, forces;
  for (const double stage : stages)
    if (stage < t.depth + 12 / t.k) within.push_back(stage);  // [L] a force of 12 EI/L^2 is beyond every such test
  const BendingTest test{{Friction::constant(t.mu0), Friction::constant(t.static_excess)}, {t.k / t.stiffening}};
  for (const PathPoint& point : path_in_steps(test, within).path) forces.push_back(t.stiffening * point.F);
  return measured(within, forces, t, random);
}

inline FitProblem simulated(const Truth& t, Random& random) {
  const SlidingLadder ladder(1.58, 2e-4);
  std::vector<double> mu, stages;
  for (int i = 1; i < 2000; ++i) stages.push_back(i * 2 / span);
  if (t.static_excess > 0) return stick_slip(t, stages, random);
  for (const double S : ladder.lengths()) mu.push_back(t.mu(S));
  if (t.overshoots) {
    const FrictionTable friction{{ladder.lengths().begin(), ladder.lengths().end()}, mu};
    std::vector<double> forces;
    stages.resize(static_cast<std::size_t>((0.4 + 12 / t.k) * span / 2));  // to a deflection of 0.4 or more
    const BendingTest test{Friction::table(friction), {t.k / t.stiffening}, SnapRest::overshoot};
    for (const PathPoint& point : follow_in_steps(test, stages).path) forces.push_back(t.stiffening * point.F);
    return measured(stages, forces, t, random);
  }
  const auto curve = ladder.curve(mu);
  auto F = measured_curve(curve.w, curve.F, t.stiffening / t.k, stages);
  for (double& force : F) force *= t.stiffening;
  return measured(stages, F, t, random);
}

}  // namespace flexslip
