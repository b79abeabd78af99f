#include "inference/snap_rests.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "inference/first_passages.h"
#include "inference/fit.h"
#include "tests/inference/simulated_test.h"
#include "tests/uniform.h"

namespace flexslip {
namespace {

// Rises of a length that is constant for some readings and then advances, with noise.
struct Rises {
  std::vector<double> stage, force, S, advance, noise;

  InvertedReadings readings() const { return {stage, force, S, advance, noise}; }
};

constexpr double step = 0.001, deviation = 2e-4;

Rises some_rises(std::size_t stuck, double first_rate, Uniform& between) {
  Rises rises;
  double S = 1.02;
  for (int rise = 0; rise < 6; ++rise)
    for (std::size_t i = 0; i < 24; ++i) {
      const double rate = i < stuck ? 0 : i < 12 ? first_rate : 1;
      S += i == 0 ? 0.03 : rate * step;
      rises.stage.push_back(step * static_cast<double>(rises.stage.size()));
      rises.force.push_back(5 + 0.05 * static_cast<double>(i));
      const double sum = between(-1, 1) + between(-1, 1) + between(-1, 1);  // of variance 1
      rises.S.push_back(S + deviation * sum);
      rises.advance.push_back(step);
      rises.noise.push_back(deviation);
    }
  return rises;
}

constexpr double jump_advances = 2.5, jump_noise = 3, clear_evidence = 5;

TEST_CASE("oracle: rises that begin with a rest overshoot, others do not") {
  Uniform between;
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    CHECK(rests_of_snaps(some_rises(8, 1, between).readings(), jump_advances, jump_noise).log_evidence >
          clear_evidence);
    for (const double rate : {0.4, 0.7, 1.0, 1.5})
      CHECK(rests_of_snaps(some_rises(0, rate, between).readings(), jump_advances, jump_noise).log_evidence <
            clear_evidence);
  }
}

TEST_CASE("oracle: the readings that stick are found, to the noise of a length") {
  Uniform between;
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    const auto stuck = rests_of_snaps(some_rises(8, 1, between).readings(), jump_advances, jump_noise).stuck;
    REQUIRE(stuck.size() == 5);  // snaps; the first rise begins the record
    for (std::size_t k = 0; k < stuck.size(); ++k) {
      CHECK(stuck[k].first == 24 * (k + 1));
      CHECK(std::abs(static_cast<double>(stuck[k].beyond) - static_cast<double>(stuck[k].first + 8)) <= 2);
    }
  }
}

TEST_CASE("limit: rises that stick to their end leave their last reading before the next snap, and none at the end") {
  Uniform between;
  const auto stuck = rests_of_snaps(some_rises(24, 1, between).readings(), jump_advances, jump_noise).stuck;
  REQUIRE(stuck.size() == 5);
  for (std::size_t k = 0; k < stuck.size(); ++k)
    CHECK(stuck[k].beyond == 24 * (k + 2) - (k + 1 < stuck.size() ? 1 : 0));
}

TEST_CASE("limit: without a jump there is nothing to tell, and nothing of no reading") {
  Uniform between;
  Rises smooth = some_rises(0, 1, between);
  smooth.force.assign(smooth.force.size(), 5);
  const SnapRests rests = rests_of_snaps(smooth.readings(), jump_advances, jump_noise);
  CHECK(rests.log_evidence == 0);
  CHECK(rests.stuck.empty());
  CHECK(rests_of_snaps({}, jump_advances, jump_noise).stuck.empty());
}

FitProblem problem_of(SnapRest rest, double mu0, double amplitude, double lambda, double noise) {
  const SimulatedTruth truth{.friction = Friction::sinusoid(mu0, amplitude, lambda, 1), .noise = noise, .rest = rest};
  return {
      .record = simulated_record(truth), .rig = {truth.stiffness}, .errors = {noise, 0.03, 0}, .rig_errors = none_off};
}

TEST_CASE("oracle: what sticks after a snap that overshoots is no passage") {
  for (const double lambda : {0.010, 0.014, 0.019})
    for (const double noise : {0.0, 0.003, 0.01}) {
      CAPTURE(lambda);
      CAPTURE(noise);
      FitProblem over = problem_of(SnapRest::overshoot, 0.6, 0.35, lambda, noise);
      CHECK(passages_of(over).may_overshoot);
      CHECK(passages_of(over).stuck.empty());
      over.snaps = SnapRest::overshoot;
      const Passages passages = passages_of(over);
      CHECK(passages.overshoots);
      REQUIRE(!passages.stuck.empty());
      const Friction truth = Friction::sinusoid(0.6, 0.35, lambda, 1);
      for (std::size_t i = 0; i < passages.size();
           ++i)  // four errors of noise, and the row in which it begins to slide
        CHECK(passages.q[i] > truth.at(passages.S[i]).mu - 0.05 - 4 * noise);
      CHECK_FALSE(fit_friction(problem_of(SnapRest::nearest_stable, 0.6, 0.35, lambda, noise)).overshoots);
    }
}

TEST_CASE("identity: a problem that states where snaps rest decides") {
  FitProblem problem = problem_of(SnapRest::overshoot, 0.6, 0.35, 0.014, 0.003);
  CHECK(fit_friction(problem).overshoots);
  problem.snaps = SnapRest::nearest_stable;
  CHECK_FALSE(fit_friction(problem).overshoots);
  const FitProblem nearest = problem_of(SnapRest::nearest_stable, 0.6, 0.35, 0.014, 0.003);
  FitProblem stated = nearest;
  stated.snaps = SnapRest::overshoot;
  CHECK(fit_friction(stated).overshoots);
  CHECK_FALSE(fit_friction(nearest).overshoots);
}

TEST_CASE("table: under snaps that overshoot the mean friction is within its interval") {
  for (const double lambda : {0.010, 0.014, 0.019})
    for (const double mu0 : {0.4, 0.7}) {
      CAPTURE(lambda);
      CAPTURE(mu0);
      const FrictionFit fit = fit_friction(problem_of(SnapRest::overshoot, mu0, 0.35, lambda, 0.008));
      REQUIRE(fit.status == FrictionFitStatus::ok);
      CHECK(fit.overshoots);
      CHECK(fit.mu0.low < mu0);
      CHECK(fit.mu0.high > mu0);
      CHECK(std::abs(fit.mu0.value - mu0) < 0.1);  // three errors; taken as nearest they are .1 to .3 too low
    }
}

}  // namespace
}  // namespace flexslip
