#include "inference/fit.h"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

FitProblem problem_of(const SimulatedTruth& truth) {
  return {simulated_record(truth), {truth.stiffness}, {truth.noise, 0.03, 0}};
}

const ModelFit& fit_of(const FrictionFit& fit, ProfileModel model) {
  for (const auto& candidate : fit.models)
    if (candidate.model == model) return candidate;
  throw std::logic_error("no such model");
}

bool covers(const ParameterEstimate& estimate, double truth) { return estimate.low <= truth && truth <= estimate.high; }

TEST_CASE("oracle: simulated truth is found again, wavelength to 2 %, and the sinusoid is chosen over the constant") {
  struct Row {
    double mu0, amplitude, wavelength, stiffness, stiffening, noise;
  };
  int covered = 0;
  for (const Row& row :
       {Row{0.5, 0.15, 10.9, 90, 1.03, 0.02}, Row{0.8, 0.1, 25, 60, 0.97, 0.03}, Row{0.4, 0.3, 45, 150, 1.0, 0.05},
        Row{0.6, 0.2, 8.5, 200, 0.96, 0.01}, Row{0.35, 0.2, 15, 40, 1.04, 0.02}, Row{0.7, 0.08, 18, 100, 1.0, 0.02}}) {
    CAPTURE(row.wavelength);
    const SimulatedTruth truth{.friction = Friction::sinusoid(row.mu0, row.amplitude, row.wavelength / 1278, 1.0),
                               .stiffness = row.stiffness,
                               .stiffening = row.stiffening,
                               .noise = row.noise};
    const auto fit = fit_friction(problem_of(truth));
    REQUIRE(fit.status == FrictionFitStatus::ok);
    CHECK(fit.models[fit.chosen].waves.size() >= 1);
    const auto& sinusoid = fit_of(fit, ProfileModel::sinusoid);
    CHECK(sinusoid.waves.front().wavelength.value * 1278 == doctest::Approx(row.wavelength).scale(0).epsilon(0.02));
    CHECK(sinusoid.waves.front().amplitude.value == doctest::Approx(row.amplitude).scale(0).epsilon(0.2));
    CHECK(sinusoid.residual_rms < 1.3 * row.noise);
    covered += covers(sinusoid.mu0, row.mu0) + covers(sinusoid.waves.front().wavelength, row.wavelength / 1278) +
               covers(sinusoid.bending_stiffness, row.stiffening);
  }
  // 95 % intervals: of 18, fewer than 14 would be covered once in 2000 times
  CHECK(covered >= 14);
}

TEST_CASE("oracle: constant friction is not called a sinusoid, and its value is found to the force noise") {
  for (const double mu : {0.3, 0.6, 0.9}) {
    const SimulatedTruth truth{.friction = Friction::constant(mu), .noise = 0.02};
    const auto fit = fit_friction(problem_of(truth));
    CHECK(fit.models[fit.chosen].waves.empty());
    const auto& constant = fit_of(fit, ProfileModel::constant);
    CHECK(std::abs(constant.mu0.value - mu) < 4 * 0.02 * 0.3 / std::sqrt(150.0));  // 4 standard errors: noise dμ/dF/√n
    CHECK(covers(constant.mu0, mu));
  }
}

TEST_CASE("identity: a wrong bending stiffness shifts the constant by what its interval allows for") {
  const SimulatedTruth truth{.friction = Friction::constant(0.6), .stiffening = 1.04, .noise = 0.01};
  const auto fit = fit_friction(problem_of(truth), {.models = {ProfileModel::constant}});
  CHECK(std::abs(fit.models.front().mu0.value - 0.6) > 0.02);
  CHECK(covers(fit.models.front().mu0, 0.6));
}

TEST_CASE("identity: a drifting mean under the teeth is told apart from them") {
  const double lambda = 11.0 / 1278;
  const SimulatedTruth truth{
      .friction = Friction::waves({.mu0 = 0.45, .drift = 0.8, .terms = {{0.15, lambda, 0.5}}, .S_reference = 1}),
      .noise = 0.02};
  const auto fit = fit_friction(problem_of(truth));
  const auto& sinusoid = fit_of(fit, ProfileModel::sinusoid);
  CHECK(sinusoid.waves.front().wavelength.value == doctest::Approx(lambda).scale(0).epsilon(0.02));
  CHECK(sinusoid.drift.value == doctest::Approx(0.8).scale(0).epsilon(0.15));
}

TEST_CASE("identity: two waves are found as two") {
  const SimulatedTruth truth{
      .friction =
          Friction::waves({.mu0 = 0.6, .drift = 0, .terms = {{0.15, 0.03, 0.5}, {0.1, 0.009, 2.0}}, .S_reference = 1}),
      .noise = 0.02};
  const auto fit = fit_friction(problem_of(truth));
  const auto& chosen = fit.models[fit.chosen];
  CHECK(chosen.model == ProfileModel::sinusoids);
  REQUIRE(chosen.waves.size() >= 2);
  for (const double wavelength : {0.03, 0.009}) {
    double nearest = 1;
    for (const auto& wave : chosen.waves) nearest = std::min(nearest, std::abs(wave.wavelength.value / wavelength - 1));
    CHECK(nearest < 0.03);
  }
}

TEST_CASE("identity: the same problem gives the same bits") {
  const auto problem = problem_of({.friction = Friction::sinusoid(0.5, 0.2, 0.01, 1), .noise = 0.02});
  const auto a = fit_friction(problem);
  const auto b = fit_friction(problem);
  CHECK(a.chosen == b.chosen);
  for (std::size_t i = 0; i < a.models.size(); ++i) {
    CHECK(a.models[i].bic == b.models[i].bic);
    CHECK(a.models[i].mu0.value == b.models[i].mu0.value);
  }
}

TEST_CASE("oracle: the force of a fitted model is the exact forward calculation with its parameters") {
  const auto problem = problem_of({.friction = Friction::sinusoid(0.5, 0.2, 0.01, 1), .noise = 0.02});
  const auto fit = fit_friction(problem, {.models = {ProfileModel::sinusoid}});
  const auto& model = fit.models.front();
  const double stiffening = model.bending_stiffness.value;
  const auto exact =
      follow_in_steps({Friction::waves(model.friction), {problem.rig.stiffness / stiffening}}, problem.record.stage);
  int apart = 0;  // at a fold a stage position may fall on either side of the snap
  for (std::size_t i = 0; i < model.force.size(); ++i)
    apart += std::abs(model.force[i] - stiffening * exact.path[i].F) > 2e-3;
  CHECK(apart <= 2);
}

TEST_CASE("limit: a record twice as stiff as stated is fitted with a friction that the mechanics covers, or none") {
  auto problem = problem_of({.friction = Friction::constant(0.3), .noise = 0.02});
  for (double& force : problem.record.force) force *= 2;
  for (std::size_t i = 0; i < problem.record.stage.size(); ++i)
    problem.record.stage[i] = problem.record.deflection[i] + problem.record.force[i] / problem.rig.stiffness;
  for (const auto& model : fit_friction(problem).models) {
    if (model.status == FitStatus::not_found) continue;
    CHECK(std::isfinite(model.mu0.value));
    CHECK(!follow_in_steps({Friction::waves(model.friction), problem.rig}, problem.record.stage).path.empty());
  }
}

TEST_CASE("identity: amplitude and wavelength stay where they are held, and the fit is the worse for it") {
  const auto problem = problem_of({.friction = Friction::sinusoid(0.5, 0.2, 0.02, 1), .noise = 0.02});
  const auto free = fit_friction(problem, {.models = {ProfileModel::sinusoid}}).models.front();
  const auto& wave = free.waves.front();
  const double amplitude = wave.amplitude.value + 2 * wave.amplitude.standard_error;
  const double wavelength = wave.wavelength.value + 2 * wave.wavelength.standard_error;
  const auto held = fit_friction(problem, {.models = {ProfileModel::sinusoid, ProfileModel::sinusoids},
                                           .held = {.amplitude = amplitude, .wavelength = wavelength}});
  for (const auto& model : held.models) {
    if (model.status == FitStatus::not_found) continue;
    CHECK(model.waves.front().amplitude.value == doctest::Approx(amplitude).scale(0).epsilon(1e-12));
    CHECK(model.waves.front().wavelength.value == doctest::Approx(wavelength).scale(0).epsilon(1e-12));
  }
  CHECK(held.models.front().log_likelihood < free.log_likelihood);
  CHECK(held.models.front().log_likelihood > free.log_likelihood - 12);  // two of two standard errors cost 2 each
}

TEST_CASE("identity: in a short and noisy record the neighbouring wavelengths are listed, and not excluded") {
  const double wavelength = 0.008;
  const SimulatedTruth truth{
      .friction = Friction::sinusoid(0.5, 0.12, wavelength, 1), .noise = 0.04, .deflection = 0.2};
  const auto fit = fit_friction(problem_of(truth), {.models = {ProfileModel::sinusoid}}).models.front();
  REQUIRE(!fit.runners_up.empty());
  double before = 0;
  for (const auto& other : fit.runners_up) {
    CHECK(other.delta_log_likelihood <= before);
    CHECK(other.wavelength != doctest::Approx(fit.waves.front().wavelength.value).scale(0).epsilon(0.01));
    before = other.delta_log_likelihood;
  }
  CHECK(fit.runners_up.size() <= 5);
}

TEST_CASE("limit: too few points are a status, nonsense is refused") {
  FitProblem problem = problem_of({.friction = Friction::constant(0.5), .noise = 0.02, .deflection = 0.06});
  problem.record.stage.resize(50);
  problem.record.deflection.resize(50);
  problem.record.force.resize(50);
  CHECK(fit_friction(problem).status == FrictionFitStatus::too_few_points);
  problem.rig.stiffness = -1;
  CHECK_THROWS_AS(fit_friction(problem), std::invalid_argument);
}

}  // namespace
}  // namespace flexslip
