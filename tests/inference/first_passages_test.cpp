#include "inference/first_passages.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "numerics/root.h"
#include "numerics/statistics.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

constexpr double stiff_train = 90;

FitProblem some_problem(double noise) {
  const auto friction = Friction::sinusoid(0.6, 0.25, 20.0 / 1278, 0.4);
  return {.record = simulated_record({.friction = friction, .noise = noise}),
          .rig = {stiff_train},
          .errors = {.force = noise, .bending_stiffness = 0.03, .contact = 0}};
}

}  // namespace

TEST_CASE("oracle: the readings' slopes are differences of exact inversions") {
  const Passages passages = passages_of(some_problem(0));
  Linearisation at;
  at.eta = 0.02;
  at.mu = passages.q;
  at.S = non_falling(passages.S);
  for (double& S : at.S) S += 0.001;  // not where the readings are
  at.slope.assign(passages.size(), 3);
  complete(at, passages);
  constexpr double h = 1e-6, truncation = 1e-6;
  for (std::size_t i = 0; i < passages.size(); i += 7) {
    CAPTURE(i);
    // The state at the fitted length and the stage position, and y there as a function of the force.
    const auto state = fibre_state(at.S[i], at.mu[i]);
    const double force = std::exp(at.eta) * state.F;
    constexpr double of_the_table = 1e-9;
    REQUIRE(std::abs(state.w + force * passages.compliance - passages.stage[i]) < of_the_table);
    const auto y_at = [&](double F) {
      const auto seen = fibre_state_from_force(passages.stage[i] - F * passages.compliance, F * std::exp(-at.eta));
      return seen.q + at.slope[i] * (at.S[i] - seen.S);
    };
    const auto slope = [&](double up, double down) { return (up - down) / (2 * h); };
    CHECK(at.noise_gain[i] == doctest::Approx(slope(y_at(force + h), y_at(force - h))).epsilon(truncation));
    CHECK(at.y[i] == doctest::Approx(at.mu[i] + at.noise_gain[i] * (passages.force[i] - force)).epsilon(1e-9));
  }
}

TEST_CASE("oracle: what is off in a rig makes the friction read larger by as much as exact inversions say") {
  const double friction = 0.6, thickness = 0.02, radius = 0.01;
  const Rig rig{.stiffness = stiff_train, .fibre = Fibre({.radius = radius, .half_depth = thickness / 2})};
  FitProblem problem{
      .record = simulated_record({.friction = Friction::constant(friction), .noise = 0, .fibre = rig.fibre}),
      .rig = rig,
      .errors = {.force = 0, .bending_stiffness = 0.03, .contact = 0},
      .rig_errors = {}};
  constexpr double h = 1e-4;
  const auto inverted = [&](double stage, double force, double compliance, const Supports& supports) {
    return state_on_supports_from_force(stage - force * compliance, force, supports).q;
  };
  const Supports as_stated = rig.fibre.supports();
  // The true quantity is larger by h: what is read with the one stated, less what is true.
  const auto holds = [&](RigErrors errors, double contact, auto&& true_friction) {
    problem.rig_errors = errors;
    problem.errors.contact = contact;
    const Passages passages = passages_of(problem);
    REQUIRE(passages.rig_errors.size() == 1);
    const RigError& error = passages.rig_errors[0];
    const double sign =
        error.friction[0] * (passages.q[0] - true_friction(passages, 0)) < 0 ? -1 : 1;  // of an eigenvector
    for (std::size_t i = 0; i < passages.size(); i += 23) {
      CAPTURE(i);
      constexpr double of_straight_lines = 0.003, second_order = 2e-3;
      CHECK(
          sign * error.friction[i] ==
          doctest::Approx((passages.q[i] - true_friction(passages, i)) / h).epsilon(of_straight_lines + second_order));
    }
  };
  const double compliance = 1 / stiff_train;
  constexpr double one = 1;  // standard deviation: what is kept then is the error itself
  const RigErrors none{
      .load_train = 0, .span = 0, .force_gain = 0, .thickness = 0, .support_radius = 0, .preload = 0, .slow_force = 0};
  const auto only = [&](double RigErrors::*quantity) {
    RigErrors errors = none;
    errors.*quantity = one;
    return errors;
  };
  holds(none, one,
        [&](const Passages& p, std::size_t i) { return inverted(p.stage[i] - h, p.force[i], compliance, as_stated); });
  holds(only(&RigErrors::load_train), 0, [&](const Passages& p, std::size_t i) {
    return inverted(p.stage[i], p.force[i], compliance / (1 + h), as_stated);
  });
  holds(only(&RigErrors::span), 0, [&](const Passages& p, std::size_t i) {
    const double longer = 1 + h;
    return inverted(p.stage[i] / longer, p.force[i] * longer * longer, compliance / (longer * longer * longer),
                    as_stated);
  });
  holds(only(&RigErrors::force_gain), 0, [&](const Passages& p, std::size_t i) {
    return inverted(p.stage[i], p.force[i] * (1 + h), compliance, as_stated);
  });
  holds(only(&RigErrors::thickness), 0, [&](const Passages& p, std::size_t i) {
    return inverted(p.stage[i], p.force[i], compliance, {radius, thickness / 2 * (1 + h)});
  });
  holds(only(&RigErrors::support_radius), 0, [&](const Passages& p, std::size_t i) {
    return inverted(p.stage[i], p.force[i], compliance, {radius * (1 + h), thickness / 2});
  });
}

TEST_CASE("identity: at the friction of a level, the stage position is the one asked for") {
  const std::vector<double> S{1.02, 1.1, 1.25, 1.4}, mu{0.3, 0.9, 0.05, 0.6}, near{0.5, 0.5, 0.5, 0.5};
  constexpr double eta = 0.05, compliance = 1 / stiff_train;
  const auto at_length = [](double length, double q, double with_eta) {
    const auto state = fibre_state(length, q);
    return state.w + std::exp(with_eta) * state.F * compliance;
  };
  const auto G = [&](std::size_t i, double q, double with_eta) { return at_length(S[i], q, with_eta); };
  std::vector<double> stage;
  for (std::size_t i = 0; i < S.size(); ++i) stage.push_back(G(i, mu[i], eta));
  const auto levels = friction_at_stage(S, stage, near, {}, compliance, eta);
  for (std::size_t i = 0; i < S.size(); ++i) {
    constexpr double of_the_table = 1e-9;  // its 1e-12 of the stage, over its slope in μ
    CHECK(std::abs(levels[i] - mu[i]) < of_the_table);
  }
}

TEST_CASE("oracle: a stage that no force is needed for is passed at the least friction that leaves a force") {
  constexpr double compliance = 2;
  for (const double length : {1.2, 1.6, 2.0}) {
    CAPTURE(length);
    const Bracket end = halved_until([](const Bracket& bracket) { return bracket.width() < 1e-9; }, {-2, 0.8},
                                     [&](double q) { return fibre_branch_end(q).S > length; });
    const double too_near = 0.5 * fibre_branch_end(end.high).w;
    for (const double near : {-1.0, 0.0, 1.0}) {
      CAPTURE(near);
      const double level = friction_at_stage({{length}}, {{too_near}}, {{near}}, {}, compliance, 0).front();
      constexpr double halved = 0.05;
      CHECK(level > end.low);  // a state exists
      CHECK(level < end.high + halved);
    }
  }
}

TEST_CASE("oracle: the rises of a noisy record are where the fibre was") {
  const auto friction = Friction::sinusoid(0.6, 0.25, 20.0 / 1278, 0.4);
  const SimulatedTruth quiet{.friction = friction}, noisy{.friction = friction, .noise = 0.03};
  const auto exact = passages_of({simulated_record(quiet), {stiff_train}, {0, 0.03, 0}});
  const auto seen = passages_of({simulated_record(noisy), {stiff_train}, {0.03, 0.03, 0}});
  const auto at = rises_of(seen);
  CHECK(std::is_sorted(at.S.begin(), at.S.end()));
  double raw = 0, risen = 0;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto same = std::find(exact.stage.begin(), exact.stage.end(), seen.stage[i]);
    if (same == exact.stage.end()) continue;
    const double S = exact.S[static_cast<std::size_t>(same - exact.stage.begin())];
    raw += (seen.S[i] - S) * (seen.S[i] - S);
    risen += (at.S[i] - S) * (at.S[i] - S);
    ++compared;
  }
  REQUIRE(compared > 100);
  CHECK(risen < 0.8 * raw);  // a piece of a rise averages over its readings; the error at its ends remains
}

TEST_CASE("limit: standing stages, inner readings of a drop and small deflections tell of no passage") {
  FitProblem problem = some_problem(0);
  const std::size_t before = passages_of(problem).size();
  auto& record = problem.record;
  record.stage.push_back(record.stage.back());
  record.deflection.push_back(record.deflection.back());
  record.force.push_back(record.force.back());
  CHECK(passages_of(problem).size() == before);
  for (const auto row : passages_of(problem).row) CHECK(record.deflection[row] > 0.05);
}

}  // namespace flexslip
