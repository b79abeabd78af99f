#include "inference/checks.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

FitProblem problem_of(const SimulatedTruth& truth) {
  return {simulated_record(truth), {truth.stiffness}, {truth.noise, 0.03, 0}};
}

SimulatedTruth rough() {
  return {.friction = Friction::rough(0.5, 0.25, 5.0 / 1278, 3, 1.6), .stiffness = 90, .noise = 0.01};
}

TEST_CASE("identity: a fit of what the model says passes every check") {
  const auto problem = problem_of(rough());
  const auto fit = fit_friction(problem);
  REQUIRE(fit.status == FrictionFitStatus::ok);
  CHECK(check_residuals(problem, fit).outcome == CheckOutcome::passed);
  CHECK(check_friction(fit).outcome == CheckOutcome::passed);
  const Check drops = check_drops(problem, fit);
  CHECK(drops.outcome == CheckOutcome::passed);
  CHECK(number_of(drops, "record") > 3);
  CHECK(number_of(drops, "draws_low") <= number_of(drops, "draws_median"));
  CHECK(number_of(drops, "draws_median") <= number_of(drops, "draws_high"));
  CHECK(number_of(drops, "draws_fall") == doctest::Approx(number_of(drops, "record_fall")).scale(0).epsilon(0.5));
  CHECK(check_whiteness(fit).outcome == CheckOutcome::passed);
}

TEST_CASE("identity: a bending stiffness passes within two errors of what the record says of it, and fails beyond") {
  auto fit = fit_friction(problem_of(rough()));
  const auto of = [&](double away, double stated) {
    fit.bending_stiffness.value = std::exp(away);
    return check_bending_stiffness(fit, stated);
  };
  fit.bending_stiffness.standard_error = 0.018;  // stated to 0.03, the record itself lies off by 1/0.024 of it
  for (const double side : {-1.0, 1.0}) {
    CHECK(of(0.047 * side, 0.03).outcome == CheckOutcome::passed);
    CHECK(of(0.049 * side, 0.03).outcome == CheckOutcome::failed);
    CHECK(number_of(of(0.047 * side, 0.03), "errors") == doctest::Approx(0.047 / 0.024));
    CHECK(number_of(of(0.047 * side, 0.03), "fitted_over_nominal") == std::exp(0.047 * side));
  }
  fit.bending_stiffness.standard_error = 0.0299;  // what tells nothing contradicts nothing
  CHECK(number_of(of(0.02, 0.03), "errors") == doctest::Approx(0.02 / (0.35 * 0.03)));
  CHECK(of(0.1, 0).outcome == CheckOutcome::not_possible);  // exact
}

TEST_CASE("identity: a fit that does not belong to its record fails") {
  auto problem = problem_of(rough());
  problem.rig_errors.load_train = 0.01;
  const auto constant = fit_friction(problem_of({.friction = Friction::constant(0.5), .noise = 0.01}));
  REQUIRE(constant.status == FrictionFitStatus::ok);
  CHECK(check_drops(problem, constant).outcome == CheckOutcome::failed);  // a sawtooth, where its draws have none

  // One wave, where friction is rough: what is left is not noise.
  const auto sinusoid = fit_friction(problem, {.model = ProfileModel::sinusoid});
  CHECK(check_whiteness(sinusoid).outcome == CheckOutcome::failed);
  CHECK(number_of(check_whiteness(sinusoid), "p_value") < 1e-4);

  auto fit = fit_friction(problem);
  fit.residual_rms = 0.2 * *std::max_element(problem.record.force.begin(), problem.record.force.end());
  CHECK(check_residuals(problem, fit).outcome == CheckOutcome::failed);
  fit.mu0_is_bound = true;
  CHECK(check_friction(fit).outcome == CheckOutcome::failed);
}

TEST_CASE("limit: a constant has no draws whose drops could be counted") {
  const auto problem = problem_of({.friction = Friction::constant(0.5), .noise = 0.01});
  const auto fit = fit_friction(problem, {.model = ProfileModel::constant});
  CHECK(check_drops(problem, fit).outcome == CheckOutcome::not_possible);
  CHECK(check_whiteness(fit).outcome == CheckOutcome::not_possible);
  CHECK(message_of([&] { number_of(check_friction(fit), "spam"); }) == "the check 'friction' has no number 'spam'");
}

TEST_CASE("oracle: Ljung and Box's statistic of a made series, worked out by hand") {
  FrictionFit fit{};
  fit.innovations = {1.5, -0.5, 0.5, -1.5, 0.5, 0.5, 1.5, -0.5, 0.5, -1.5};  // mean 0.1; of 10, two lags
  const Check check = check_whiteness(fit);
  CHECK(number_of(check, "lags") == 2);
  double squares = 0, first = 0, second = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    squares += (fit.innovations[i] - 0.1) * (fit.innovations[i] - 0.1);
    if (i > 0) first += (fit.innovations[i] - 0.1) * (fit.innovations[i - 1] - 0.1);
    if (i > 1) second += (fit.innovations[i] - 0.1) * (fit.innovations[i - 2] - 0.1);
  }
  const double expected = 120 * (first * first / 9 + second * second / 8) / (squares * squares);
  CHECK(std::abs(number_of(check, "ljung_box") / expected - 1) < 1e-14);
  CHECK(check.outcome == CheckOutcome::passed);
}

TEST_CASE("identity: the same fit gives the same numbers") {
  const auto problem = problem_of(rough());
  const auto fit = fit_friction(problem);
  const Check a = check_drops(problem, fit);
  const Check b = check_drops(problem, fit);
  REQUIRE(a.numbers.size() == b.numbers.size());
  for (std::size_t i = 0; i < a.numbers.size(); ++i) CHECK(a.numbers[i].value == b.numbers[i].value);
}

}  // namespace
}  // namespace flexslip
