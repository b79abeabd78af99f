#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "bending_test/trace.h"
#include "contact/over_rollers.h"

namespace flexslip {

TEST_CASE("pins, limit: if the specimen's friction is larger everywhere, a test has constant friction and no snap") {
  const Fibre fibre(Supports{0.05, 0.01});
  const double q = friction_of_pins(0.2, 0.02, 0.05);
  CHECK(q == doctest::Approx(0.08 / std::sqrt(1 - 0.0064)).epsilon(1e-14));
  const Friction pinned = capped(Friction::sinusoid(0.5, 0.4, 0.02, 1), q, 1.5);
  const std::vector<double> stages{0, 0.1, 0.3, 0.2, 0.4};
  const History found = follow_in_steps({pinned, {50, fibre}}, stages);
  const History expected = follow_in_steps({Friction::constant(q), {50, fibre}}, stages);
  CHECK(found.snaps.empty());
  REQUIRE(found.path.size() == expected.path.size());
  for (std::size_t i = 0; i < found.path.size(); ++i)
    CHECK(found.path[i].F == doctest::Approx(expected.path[i].F).epsilon(1e-11));
}

TEST_CASE("pins, oracle: friction is the lesser of both, and its corners are knots") {
  const Friction own = Friction::sinusoid(0.5, 0.4, 0.02, 1), both = capped(own, 0.45, 1.3);
  for (double S = 1; S < 1.3; S += 1e-3) CHECK(both.at(S).mu == std::min(own.at(S).mu, 0.45));
  int corners = 0;
  for (const double S : both.knots()) corners += std::abs(own.at(S).mu - 0.45) < 1e-12;
  CHECK(corners == 50);  // in 0.3 to 1.3, of a period of 0.04
  const History history = follow_continuously({both, {200, Fibre()}}, std::vector<double>{0, 0.4, 0.2, 0.5}, 30);
  const EnergyAccount& energy = history.energy;
  CHECK(std::abs(energy.imbalance) < 1e-10 * energy.stage_work);
}

TEST_CASE("over rollers, identity: friction at many lengths at once is that at each") {
  const Friction waves = Friction::sinusoid(0.5, 0.4, 0.02, 1);
  for (const Friction& own : {waves, capped(waves, 0.45, 1.5)})
    for (const double direction : {1.0, -1.0}) {
      const Friction over = met(own, Fibre(Supports{0.01, 0.01}), direction, 1.4);
      std::vector<double> lengths{1};
      for (double S = 1.0001; S < 1.4; S += 7e-4) lengths.push_back(S);
      const FrictionArrays at_once = over.at(lengths);
      for (std::size_t i = 0; i < lengths.size(); ++i) {
        CAPTURE(lengths[i]);
        const FrictionPoint alone = over.at(lengths[i]);
        CHECK(std::abs(at_once.mu[i] - alone.mu) < 1e-11);
        CHECK(std::abs(at_once.slope[i] - alone.slope) < 1e-6 * (1 + std::abs(alone.slope)));
      }
    }
}

TEST_CASE("pins, identity: the pieces of a trace lie end to end, with their ends at the corners") {
  for (const double wavelength : {0.001, 0.0013, 0.0015}) {
    const Friction both = capped(Friction::sinusoid(0.5, 0.4, wavelength, 1), 0.6, 1.5);
    const SlidingCurve curve = trace_loading_curve(both, {40}, 1.3);
    REQUIRE(curve.pieces.size() > 200);
    const Fibre fibre;
    CHECK(curve.pieces.front().from == 0);
    CHECK(curve.pieces.back().to == fibre.sliding_coordinate(1.3));
    for (std::size_t i = 1; i < curve.pieces.size(); ++i) CHECK(curve.pieces[i].from == curve.pieces[i - 1].to);
    for (const double knot : both.knots()) {
      if (!(knot > 1 && knot < 1.3)) continue;
      CHECK(std::any_of(curve.pieces.begin(), curve.pieces.end(),
                        [&](const CurvePiece& piece) { return piece.to == fibre.sliding_coordinate(knot); }));
    }
  }
}

TEST_CASE("pins, oracle: folds, at corners of friction among them, are the turns of the stage over a fine grid") {
  const Friction both = capped(Friction::sinusoid(0.5, 0.4, 0.02, 1), 0.6, 1.5);
  for (const Fibre& fibre : {Fibre(), Fibre(Supports{0.004, 0.002})}) {
    const Rig rig{40, fibre};
    const SlidingCurve curve = trace_loading_curve(both, rig, 1.3);
    std::vector<double> turns;
    constexpr double step = 1e-5;
    double before = NAN, rise = 1;
    for (double S = 1 + step; S < 1.3; S += step) {
      const FibreState state = fibre.state(S, curve.friction.at(S).mu);
      const double stage = state.w + state.F / rig.stiffness;
      if ((stage - before) * rise < 0) turns.push_back(S - step), rise = -rise;
      before = stage;
    }
    std::size_t corners = 0;
    REQUIRE(curve.folds.size() == turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
      CHECK(std::abs(curve.folds[i].point.S - turns[i]) < 2 * step);
      corners += std::abs(both.at(fibre.length_between_contacts(fibre.state(
                                      curve.folds[i].point.S, curve.friction.at(curve.folds[i].point.S).mu)))
                              .mu -
                          0.6) < 1e-9;
    }
    CHECK(corners > 3);
    CHECK(corners < turns.size());
  }
}

TEST_CASE(
    "pins, identity: the energy account closes where the cap cuts a wave in the beginning of a thick specimen's test") {
  const Fibre fibre(Supports{0.078, 0.075});
  const Friction both =
      capped(Friction::sinusoid(0.3, 0.9, 0.2, 1.3339113708779602), friction_of_pins(0.3, 0.039, 0.078), 1.5);
  const History history = follow_continuously({both, {14.94, fibre}}, std::vector<double>{0, 0.6814, 0.2, 0.05}, 20);
  double most = 0;
  for (const EnergyAccount& energy : history.energy_at) most = std::max(most, energy.stage_work);
  for (const EnergyAccount& energy : history.energy_at) CHECK(std::abs(energy.imbalance) < 1e-10 * most);
}

TEST_CASE(
    "pins, contract: only what the points of a specimen show can be capped, and pins that turn not at all are "
    "refused") {
  CHECK_THROWS_AS(capped(Friction::constant(0.5), -1, 1.3), std::invalid_argument);
  CHECK_THROWS_AS(friction_of_pins(3, 0.4, 1), std::invalid_argument);
}

}  // namespace flexslip
