#include "inference/process_mode.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "inference/chain.h"
#include "inference/prior_draws.h"
#include "numerics/elementary.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

constexpr double authors_train = 90;

Passages some_passages(double stiffness_error = 0.03) {
  const auto friction = Friction::sinusoid(0.6, 0.25, 20.0 / 1278, 0.4);
  return passages_of({.record = simulated_record({.friction = friction, .noise = 0.02, .step = 4.0 / 1278}),
                      .rig = {authors_train},
                      .errors = {.force = 0.02, .bending_stiffness = stiffness_error, .contact = 2e-4},
                      .rig_errors = {.preload = 0.001}});
}

Mode some_mode(const FrictionProcess& process, Kernel kernel, bool wave) {
  const std::vector<double> lambdas{std::log(21.0 / 1278)};
  Theta theta = process.prior_of_theta().usual(wave ? std::span<const double>(lambdas) : std::span<const double>());
  theta.values[Theta::log_noise] = std::log(0.02);
  Mode mode = process.start(kernel, theta, rises_of(process.passages()));
  process.burst(mode, 3, 0.3);
  return mode;
}

}  // namespace

TEST_CASE("oracle: the gradient of the merit is its differences") {
  const FrictionProcess process(some_passages());
  for (const Kernel kernel : all_kernels)
    for (const bool wave : {false, true}) {
      CAPTURE(name_of(kernel));
      const Mode mode = some_mode(process, kernel, wave);
      Observations observations = process.observations_of(mode);
      const auto exact = process.objective(mode, observations, mode.theta);
      for (std::size_t i = 0; i < mode.theta.size(); ++i) {
        if (kernel == Kernel::none && (i == 2 || i == 3)) continue;
        CAPTURE(i);
        constexpr double h = 1e-5, truncation = 1e-5;
        Theta up = mode.theta, down = mode.theta;
        up.values[i] += h;
        down.values[i] -= h;
        const double difference =
            (process.objective(mode, observations, up).value - process.objective(mode, observations, down).value) /
            (2 * h);
        CHECK(exact.gradient[i] == doctest::Approx(difference).epsilon(truncation).scale(10));
      }
    }
}

TEST_CASE("oracle: the evidence of the gaps is that of many draws") {
  Passages of_known_rig = some_passages(0);
  of_known_rig.rig_errors.clear();
  const FrictionProcess process(of_known_rig);
  for (const Kernel kernel : {Kernel::exponential, Kernel::matern_3_2, Kernel::matern_9_2}) {
    CAPTURE(name_of(kernel));
    Mode mode = some_mode(process, kernel, true);
    process.polish(mode, {2, 6, 0.3});
    process.settle(mode);
    REQUIRE(mode.sites.size() > 5);
    Mode without = mode;
    for (auto& site : without.sites) site.precision = site.precision_mean = 0;
    const Observations observations =
        process.observations_of(without);  // where no site says anything, a value is the bound
    const auto p = hyperparameters_of(mode.theta);
    const double readings_alone = Chain(observations, kernel, p).log_likelihood();
    NormalSource normal(3);
    double sum = 0;
    constexpr int draws = 4000;
    for (int draw = 0; draw < draws; ++draw) {
      const Drawn drawn = PriorDraws(observations, kernel, p)(normal);
      Observations rest = observations;
      for (std::size_t i = 0; i < rest.values.size(); ++i) rest.values[i] -= drawn.values[i];
      const auto moved = Chain(rest, kernel, p).smoothed();
      double log_below = 0;
      for (std::size_t i = 0; i < observations.all.size(); ++i)
        if (!observations.all[i].is_reading()) {
          constexpr double softness = 0.003;
          log_below +=
              elementary::gaussian_below((observations.values[i] - drawn.f[i] - moved[i].f) / softness).log_probability;
        }
      sum += std::exp(log_below);
    }
    const double by_draws = std::log(sum / draws);
    const double by_sites = process.evidence(mode) - readings_alone;
    CHECK(std::abs(by_sites - by_draws) <
          0.25);  // what MODEL promises of expectation propagation; the draws' own error is below 0.1
  }
}

TEST_CASE("oracle: EI and its error agree with a grid of fixed EI, of a wave and of roughness") {
  const auto wave = Friction::sinusoid(0.6, 0.25, 20.0 / 1278, 0.4);
  FrictionTable bumps;
  for (int i = 0; i <= 600; ++i) {
    const double S = 1 + 0.001 * i, x = 0.5 * (S - 1) * 1278;
    bumps.S.push_back(S);
    bumps.mu.push_back(0.6 + 0.03 * std::cos(x / 9.1) + 0.025 * std::cos(x / 14.3 + 1) + 0.03 * std::cos(x / 25.7 + 2));
  }
  const auto rough = Friction::table(bumps);
  for (const Kernel kernel : {Kernel::exponential, Kernel::matern_3_2, Kernel::matern_9_2})
    for (const bool with_wave : {true, false}) {
      CAPTURE(name_of(kernel));
      CAPTURE(with_wave);
      const auto problem_at = [&](double eta, double stiffness_error) {
        FitProblem problem;
        problem.record = simulated_record({.friction = with_wave ? wave : rough, .noise = 0.02, .step = 4.0 / 1278});
        for (double& F : problem.record.force) F *= std::exp(-eta);
        problem.rig = {authors_train * std::exp(-eta)};
        problem.errors = {.force = 0.02, .bending_stiffness = stiffness_error, .contact = 2e-4};
        return problem;
      };
      const FrictionProcess process(passages_of(problem_at(0, 0.03)));
      Mode mode = some_mode(process, kernel, with_wave);
      process.polish(mode, {6, 12, 0.3});
      process.polish(mode, {6, 12, 0.3});
      const Observations observations = process.observations_of(mode);
      const Chain chain(observations, mode.kernel, hyperparameters_of(mode.theta));
      const auto column = process.columns().stiffness;
      const double eta = chain.mean()[column];
      const double error = std::sqrt(chain.covariance()(column, column));
      // At each EI of a grid the readings in its units, EI exact; the prior of EI and the change of units are added by hand.
      double weight = 0, sum = 0, squares = 0;
      for (int i = -6; i <= 6; ++i) {
        const double at = eta + 0.6 * i * error;
        const FrictionProcess here(passages_of(problem_at(at, 0)));
        REQUIRE(here.passages().size() == process.passages().size());
        Mode other = here.start(mode.kernel, mode.theta, mode.at);
        other.theta.values[Theta::log_noise] -= at;
        other.theta.values[Theta::log_roughness] -=
            at;  // how rough it is, is not known beforehand: neither tells of EI
        other.at.eta = 0;
        for (std::size_t j = 0; j < other.at.S.size(); ++j) other.at.S[j] += mode.at.S_eta[j] * (at - eta);
        complete(other.at, here.passages());
        here.burst(other, 24, 0.3);
        const double n = static_cast<double>(here.passages().size());
        const ThetaPrior& prior = process.prior_of_theta();
        const auto of_noise = [&](double value) {
          return -0.5 * (value - prior.mean[Theta::log_noise]) * (value - prior.mean[Theta::log_noise]) /
                 (prior.deviation[Theta::log_noise] * prior.deviation[Theta::log_noise]);
        };
        const double log_weight = other.log_posterior - of_noise(other.theta.values[Theta::log_noise]) - n * at -
                                  0.5 * at * at / (0.03 * 0.03) -
                                  (mode.log_posterior - of_noise(mode.theta.values[Theta::log_noise]));
        const double w = std::exp(log_weight);
        weight += w;
        sum += w * at;
        squares += w * at * at;
      }
      const double mean = sum / weight, deviation = std::sqrt(squares / weight - mean * mean);
      constexpr double of_error =
          0.15;  // what the gaps say is left out of the volume, and an exponential kernel has no slope
      CHECK(std::abs(mean - eta) < of_error * error);
      CHECK(deviation == doctest::Approx(error).epsilon(0.05));
    }
}

TEST_CASE("limit: fewer than 20 readings are no record of friction") {
  CHECK_THROWS_AS(FrictionProcess(Passages{}), std::invalid_argument);
}

}  // namespace flexslip
