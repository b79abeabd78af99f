#include "inference/likelihood_profile.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

FitProblem problem_of(const SimulatedTruth& truth) {
  return {simulated_record(truth), {truth.stiffness}, {truth.noise, 0.03, 0}};
}

const SimulatedTruth truth{.friction = Friction::sinusoid(0.5, 0.2, 0.02, 1), .stiffening = 1.02, .noise = 0.02};

struct Along {
  FitParameter parameter;
  ParameterEstimate estimate;
};

std::vector<Along> all_of(const ModelFit& fit) {
  const auto& wave = fit.waves.front();
  return {{FitParameter::mu0, fit.mu0},
          {FitParameter::amplitude, wave.amplitude},
          {FitParameter::wavelength, wave.wavelength},
          {FitParameter::phase, wave.phase},
          {FitParameter::bending_stiffness, fit.bending_stiffness}};
}

TEST_CASE("identity: the likelihood is greatest at the estimates, and falls by 1.92 to the ends of their intervals") {
  const auto problem = problem_of(truth);
  const auto fit = fit_friction(problem, {.models = {ProfileModel::sinusoid}}).models.front();
  for (const auto& [parameter, estimate] : all_of(fit)) {
    CAPTURE(static_cast<int>(parameter));
    const auto values =
        likelihood_along(problem, fit, parameter, std::vector{estimate.low, estimate.value, estimate.high});
    // The widest of profile and Gauss-Newton is the interval, and jumps make it end early: from 1.5 to 4.5
    for (const std::size_t end : {0, 2}) {
      CHECK(values[1] - values[end] > 1.5);
      CHECK(values[1] - values[end] < 4.5);
    }
  }
}

TEST_CASE("identity: the order of the values and their company do not matter much") {
  const auto problem = problem_of(truth);
  const auto fit = fit_friction(problem, {.models = {ProfileModel::sinusoid}}).models.front();
  for (const auto& [parameter, estimate] : all_of(fit)) {
    const double away = estimate.value + 1.5 * estimate.standard_error;
    const auto many = likelihood_along(
        problem, fit, parameter, std::vector{away, estimate.value, estimate.value + 0.7 * estimate.standard_error});
    const auto one = likelihood_along(problem, fit, parameter, std::vector{away});
    CHECK(many[0] == doctest::Approx(one[0]).scale(1).epsilon(0.3));  // a jump missed; 1.1 is the fall
  }
}

TEST_CASE("limit: what is not permitted has no likelihood, what the model does not have is refused") {
  const auto problem = problem_of(truth);
  const auto fit = fit_friction(problem, {.models = {ProfileModel::sinusoid, ProfileModel::drift}});
  const auto far = likelihood_along(problem, fit.models[0], FitParameter::bending_stiffness, std::vector{2.0});
  CHECK(far.front() == -std::numeric_limits<double>::infinity());
  CHECK(likelihood_along(problem, fit.models[0], FitParameter::mu0, {}).empty());
  CHECK_THROWS_AS(likelihood_along(problem, fit.models[1], FitParameter::wavelength, std::vector{0.02}),
                  std::invalid_argument);
}

}  // namespace
}  // namespace flexslip
