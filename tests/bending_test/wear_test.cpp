#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "contact/over_rollers.h"
#include "fibre/elastica.h"
#include "tests/generators.h"

namespace flexslip {
namespace {

BendingTest worn(const Friction& friction, double wear, const Rig& rig = {30}) {
  return {friction, rig, SnapRest::nearest_stable, wear};
}

// A programme of this many passes through 0.45 and 0.1.
std::vector<double> passes_of(int passes) {
  std::vector<double> stages;
  for (int i = 0; i < passes; ++i) stages.push_back(i % 2 ? 0.1 : 0.45);
  return stages;
}

bool slides(const PathPoint& point) { return point.motion == Motion::slip_in || point.motion == Motion::slip_out; }

void check_energy(const History& history) {
  double greatest = 0;
  for (const EnergyAccount& account : history.energy_at) greatest = std::max(greatest, std::abs(account.stage_work));
  for (const EnergyAccount& account : history.energy_at) CHECK(std::abs(account.imbalance) <= 1e-10 * greatest);
}

}  // namespace

TEST_CASE("wear, identity: of 1 it changes not a bit") {
  for (const double excess : {0.0, 0.1}) {
    const FrictionLaw law{Friction::sinusoid(0.5, 0.3, 0.02, 1), Friction::constant(excess)};
    const std::vector<double> programme{0.45, 0.1, 0.45, 0.45, 0.2, 0.5};
    const History none = follow_continuously({law, {30}}, programme, 7);
    const History one = follow_continuously({law, {30}, SnapRest::nearest_stable, 1}, programme, 7);
    REQUIRE(none.path.size() == one.path.size());
    for (std::size_t i = 0; i < none.path.size(); ++i) {
      CHECK(none.path[i].F == one.path[i].F);
      CHECK(none.path[i].S == one.path[i].S);
    }
    CHECK(none.energy.friction == one.energy.friction);
  }
}

TEST_CASE("wear, oracle: of constant friction each pass slides at its own") {
  constexpr double mu = 0.5, wear = 0.6;
  const std::vector<double> turns = passes_of(5);
  for (const bool in_steps : {true, false}) {
    std::vector<double> steps{0};
    for (const double turn : turns) {
      const double from = steps.back();
      for (int i = 1; i <= 20; ++i) steps.push_back(i < 20 ? from + (turn - from) * i / 20 : turn);
    }
    const BendingTest test = worn(Friction::constant(mu), wear);
    const History history = in_steps ? follow_in_steps(test, steps) : follow_continuously(test, turns, 20);
    REQUIRE(history.status == HistoryStatus::ok);
    CHECK(history.snaps.size() == 4);
    check_energy(history);
    std::size_t pass = 0, sliding = 0;
    for (std::size_t i = 1; i < history.path.size(); ++i) {
      const PathPoint &before = history.path[i - 1], &point = history.path[i];
      if (before.stage == turns[pass] && i > 1 && pass + 1 < turns.size()) ++pass;
      if (!slides(point)) continue;
      ++sliding;
      const double direction = pass % 2 ? -1 : 1;
      CHECK(point.q == doctest::Approx(direction * mu * std::pow(wear, pass)).epsilon(1e-14));
    }
    CHECK(sliding > 40);
  }
}

TEST_CASE("wear, oracle: at a turn the specimen slides at constant stage to where the lower friction holds it") {
  constexpr double mu = 0.5, wear = 0.6, k = 30, stage = 0.45;
  const History history = follow_continuously(worn(Friction::constant(mu), wear), passes_of(2), 3);
  REQUIRE(history.snaps.size() == 1);
  const Snap& snap = history.snaps.front();
  double low = 1, high = 1.3;
  for (int i = 0; i < 100; ++i) {
    const double S = 0.5 * (low + high);
    const FibreState state = fibre_state(S, wear * mu);
    (state.w + state.F / k < stage ? low : high) = S;
  }
  CHECK(snap.stage == stage);
  CHECK(snap.before.q == doctest::Approx(mu).epsilon(1e-14));
  CHECK(snap.after.q == doctest::Approx(wear * mu).epsilon(1e-14));
  CHECK(snap.after.S == doctest::Approx(low).epsilon(1e-13));
  CHECK(snap.friction > 0);
  CHECK(snap.released > 0);
}

TEST_CASE("wear, identity: where friction holds the specimen all the same, it stays where it is") {
  const History history = follow_continuously(worn(Friction::constant(0.4), 0.9), std::vector{0.45, 0.44, 0.45}, 3);
  CHECK(history.snaps.size() == 1);  // at the first turn alone: from 0.45 to 0.44 it sticks
  check_energy(history);
}

TEST_CASE("wear, limit: a specimen that no worn friction holds slips through, one that stood free springs off") {
  const auto end_of = [](double mu, double wear, const std::vector<double>& turns) {
    return follow_continuously(worn(Friction::constant(mu), wear), turns, 3).status;
  };
  CHECK(end_of(0.9, 0.3, {1.2, 0.9, 1.2}) == HistoryStatus::slipped_through);
  CHECK(end_of(0.4, 1, {1.15, 0.2, 1.15}) == HistoryStatus::ok);
  CHECK(end_of(0.4, 0.4, {0.75, 0.2, 0.75}) == HistoryStatus::contact_lost);
}

TEST_CASE("wear, identity: a halt is no turn") {
  const BendingTest test = worn(Friction::sinusoid(0.5, 0.3, 0.02, 1), 0.7);
  const History one = follow_continuously(test, std::vector{0.45, 0.1, 0.4}, 5);
  const History halted = follow_continuously(test, std::vector{0.2, 0.2, 0.45, 0.45, 0.1, 0.1, 0.4}, 5);
  CHECK(halted.path.back().F == doctest::Approx(one.path.back().F).epsilon(1e-12));
  CHECK(halted.path.back().S == doctest::Approx(one.path.back().S).epsilon(1e-12));
}

TEST_CASE("wear, limit: on a straight specimen there is nothing to slide") {
  for (const Fibre& fibre : {Fibre(), Fibre({0.02, 0.01})}) {
    const History history =
        follow_continuously(worn(Friction::constant(0.3), 0.5, {30, fibre}), std::vector{0.3, 0.0, 0.3, 0.0}, 5);
    CHECK(history.status == HistoryStatus::ok);
    CHECK(history.snaps.size() == 2);  // at 0.3
    check_energy(history);
  }
}

TEST_CASE("wear, identity: two supports wear as each would") {
  const Friction left = Friction::sinusoid(0.5, 0.3, 0.02, 1), right = Friction::sinusoid(0.45, 0.2, 0.03, 2);
  const auto follow = [&](const Friction& friction, double wear) {
    return follow_continuously(worn(friction, wear), passes_of(3), 5);
  };
  const History history = follow(Friction::on_two_supports(left, right, longest_at_stage(0.5)), 0.7);
  REQUIRE(history.status == HistoryStatus::ok);
  check_energy(history);
  for (std::size_t i = 0; i < history.path.size(); ++i) {
    const auto& [x, y] = history.contacts[i];
    const PathPoint& point = history.path[i];
    CHECK(1 + x + y == doctest::Approx(point.S).epsilon(1e-12));
    if (point.motion != Motion::slip_out) continue;
    const double least = std::min(left.at(1 + 2 * x).mu, right.at(1 + 2 * y).mu);
    CHECK(point.q == doctest::Approx(-0.7 * least).epsilon(1e-9));
  }
  // One support always sticks: the path of the other depends on its friction alone.
  const History one = follow(Friction::on_two_supports(left, Friction::constant(5), longest_at_stage(0.5)), 0.7);
  for (const ContactPoints& at : one.contacts) CHECK(at.right == 0);
}

TEST_CASE("wear, identity: pins do not wear") {
  const Friction capped_at = capped(Friction::constant(0.5), 0.3, 2);
  CHECK(capped_at.scaled(0.8).at(1.2).mu == 0.3);
  CHECK(capped_at.scaled(0.5).at(1.2).mu == 0.25);
}

TEST_CASE("wear, energy: the account closes with cracks, on rollers, with a thickness and at any friction (property)") {
  const std::vector<Supports> kinds{{0, 0}, {0, 0}, {0, 0.0157}, {0.004, 0.02}, {0.03, 0.008}};
  int ends = 0, snaps = 0, cracked = 0;
  CHECK(rc::check([&] {
    const std::size_t kind = *rc::gen::inRange<std::size_t>(0, kinds.size());
    const double mu0 = *between(0.1, 0.7), wavelength = *between(0.03, 0.2);
    const bool on_edges = kind < 2;
    FrictionLaw law = *rc::gen::arbitrary<bool>()
                          ? Friction::sinusoid(mu0, *between(0, 0.5), wavelength, *between(0, 6.3))
                          : Friction::rough(mu0, *between(0, 0.3), 0.5 * wavelength, 7, 2.5);
    if (kind == 1 && *whole(0, 4) == 0) law.static_excess = Friction::constant(*between(0.1, 0.2));
    const BendingTest test{law,
                           {std::pow(10, *between(1, 3)), Fibre(kinds[kind])},
                           on_edges && *between(0, 1) < 0.3 ? SnapRest::overshoot : SnapRest::nearest_stable,
                           *between(0.3, 1)};
    std::vector<Crack> cracks;
    for (int i = *whole(0, 2); i > 0; --i) cracks.push_back({*between(0.02, 0.4), *between(0.01, 0.4)});
    std::vector<double> programme{*between(0.2, 0.45)};
    for (int i = 0; i < 5; ++i) programme.push_back(*between(0.0, 0.45) * (*whole(0, 3) == 0 ? 0.05 : 1));
    programme.push_back(0);
    programme.push_back(0.3);
    const bool in_steps = *rc::gen::arbitrary<bool>();
    const History history =
        in_steps ? follow_in_steps(test, programme, cracks) : follow_continuously(test, programme, 4, cracks);
    ends += history.status != HistoryStatus::ok;
    snaps += static_cast<int>(history.snaps.size());
    cracked += static_cast<int>(history.cracks.size());
    double greatest = 0;
    for (const EnergyAccount& account : history.energy_at) greatest = std::max(greatest, std::abs(account.stage_work));
    for (const EnergyAccount& account : history.energy_at) RC_ASSERT(std::abs(account.imbalance) <= 1e-10 * greatest);
    // On edges friction is looked up at the length itself.
    std::size_t turns = 0;
    for (std::size_t i = 0; in_steps && on_edges && i < history.path.size(); ++i) {
      turns += i > 0 && (programme[i] > programme[i - 1]) != (i < 2 || programme[i - 1] > programme[i - 2]);
      const PathPoint& point = history.path[i];
      RC_ASSERT(std::abs(point.q) <= static_friction(law.scaled(std::pow(test.wear, turns)), point.S) + 1e-9);
    }
    for (const Snap& snap : history.snaps) {
      RC_ASSERT(snap.friction >= 0);
      RC_ASSERT(snap.released >= -1e-12 * greatest);
    }
  }));
  MESSAGE(ends, " ended early, ", snaps, " snaps, ", cracked, " cracks");
  CHECK(ends < 10);
}

TEST_CASE("wear beyond its range is refused") {
  for (const double wear : {0.0, -0.5, 1.1, std::nan("")})
    CHECK_THROWS_AS(CrackingFibre(worn(Friction::constant(0.5), wear), {}, 0.3), std::invalid_argument);
}

}  // namespace flexslip
