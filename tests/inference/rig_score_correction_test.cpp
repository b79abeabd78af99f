#include "inference/rig_score_correction.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "inference/chain.h"
#include "inference/fit.h"
#include "inference/prior_draws.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

// A path without a slope anywhere: of exponential correlation, drawn every 0.3 µm.
FrictionTable path_without_slope(double mean, double deviation, double length, NormalSource& normal) {
  FrictionTable table;
  constexpr double step = 2 * 0.3 / 1278;  // [L] of S
  const double kept = std::exp(-0.5 * step / length);
  double g = deviation * normal();
  for (double S = 1; S < 1.6; S += step) {
    table.S.push_back(S);
    table.mu.push_back(mean + g);
    g = kept * g + std::sqrt(1 - kept * kept) * deviation * normal();
  }
  return table;
}

FitProblem rough_problem(const FrictionTable& friction, std::uint64_t seed) {
  FitProblem problem;
  constexpr double stiffness = 40, noise = 0.01;
  problem.record = simulated_record({.friction = Friction::table(friction),
                                     .stiffness = stiffness,
                                     .noise = noise,
                                     .step = 4.0 / 1278,
                                     .seed = seed});
  problem.rig = {stiffness};
  problem.errors = {.force = noise, .bending_stiffness = 0.03, .contact = 1e-5};
  problem.rig_errors = none_off;
  return problem;
}

}  // namespace

TEST_CASE(
    "rig: of friction that a soft rig jumps over, neither its mean nor the bending stiffness is read off to one side") {
  NormalSource normal(36);
  double stiffness_off = 0, friction_off = 0;  // means, the latter over its error
  int covered = 0;
  constexpr int tests = 6;
  for (std::uint64_t seed = 1; seed <= tests; ++seed) {
    const auto friction = path_without_slope(0.6, 0.08, 10.0 / 1278, normal);
    const FrictionFit fit = fit_friction(rough_problem(friction, seed));
    REQUIRE(fit.status == FrictionFitStatus::ok);
    double true_mean = 0, count = 0;
    for (std::size_t i = 0; i < friction.S.size(); ++i) {
      if (!(friction.S[i] > fit.S_begin && friction.S[i] < fit.S_end)) continue;
      true_mean += friction.mu[i];
      ++count;
    }
    true_mean /= count;
    covered += fit.mu0.low < true_mean && true_mean < fit.mu0.high ? 1 : 0;
    stiffness_off += std::log(fit.bending_stiffness.value) / tests;
    friction_off += (fit.mu0.value - true_mean) / fit.mu0.standard_error / tests;
  }
  CHECK(covered >= tests - 1);
  CHECK(std::abs(stiffness_off) < 0.012);  // by the columns alone -0.016
  CHECK(std::abs(friction_off) < 0.6);     // likewise 1.0
}

}  // namespace flexslip
