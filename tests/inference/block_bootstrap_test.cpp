#include "inference/block_bootstrap.h"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

FitProblem problem_of(const SimulatedTruth& truth) {
  return {simulated_record(truth), {truth.stiffness}, {truth.noise, 0.03, 0}};
}

TEST_CASE("oracle: with white noise the scatter is that of Gauss and Newton") {
  const auto problem = problem_of({.friction = Friction::sinusoid(0.5, 0.15, 0.03, 1), .noise = 0.02});
  const auto fit = fit_friction(problem, {.models = {ProfileModel::sinusoid}}).models.front();
  REQUIRE(fit.correlation < 0.1);
  const auto bootstrap = block_bootstrap(problem, fit, {.count = 400, .seed = 7});
  // The scatter of 400 is known to 1/√800 = 3.5 %; three of these, and 7 % for what jumps add to the one or the other.
  const auto agree = [](const BootstrapEstimate& simulated, const ParameterEstimate& calculated) {
    return std::abs(simulated.standard_error / calculated.standard_error - 1) < 0.18;
  };
  CHECK(agree(bootstrap.mu0, fit.mu0));
  CHECK(agree(bootstrap.waves.front().amplitude, fit.waves.front().amplitude));
  CHECK(agree(bootstrap.waves.front().wavelength, fit.waves.front().wavelength));
  CHECK(agree(bootstrap.waves.front().phase, fit.waves.front().phase));
  CHECK(agree(bootstrap.bending_stiffness, fit.bending_stiffness));
  CHECK(bootstrap.mu0.low < fit.mu0.value);
  CHECK(fit.mu0.value < bootstrap.mu0.high);
}

TEST_CASE("identity: a seed gives the same bits, another seed others; nothing asked for is nothing done") {
  const auto problem = problem_of({.friction = Friction::sinusoid(0.5, 0.15, 0.03, 1), .noise = 0.02});
  const auto fit = fit_friction(problem, {.models = {ProfileModel::sinusoid}}).models.front();
  const auto a = block_bootstrap(problem, fit, {.count = 20, .seed = 3});
  const auto b = block_bootstrap(problem, fit, {.count = 20, .seed = 3});
  const auto c = block_bootstrap(problem, fit, {.count = 20, .seed = 4});
  CHECK(a.mu0.standard_error == b.mu0.standard_error);
  CHECK(a.mu0.standard_error != c.mu0.standard_error);
  CHECK(block_bootstrap(problem, fit, {}).count == 0);
}

TEST_CASE("limit: a constant, which is not fitted to the curve, has no bootstrap") {
  const auto problem = problem_of({.friction = Friction::constant(0.5), .noise = 0.02});
  const auto fit = fit_friction(problem, {.models = {ProfileModel::constant}}).models.front();
  CHECK_THROWS_AS(block_bootstrap(problem, fit, {.count = 10}), std::invalid_argument);
}

}  // namespace
}  // namespace flexslip
