// A fibre on two supports that are not alike, moved through programmes.
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "bending_test/snap.h"
#include "fibre/elastica.h"

namespace flexslip {
namespace {

const Friction left_side = Friction::sinusoid(0.5, 0.25, 0.02, 1),
               right_side = Friction::sinusoid(0.53, 0.2, 0.0154, 2.5);

Friction unlike_sides() { return Friction::on_two_supports(left_side, right_side, 1.6); }

// The slow, obvious way: where friction does not hold the fibre at the stage position, the weaker side goes one small step.
struct SteppedFibre {
  double k, h;
  ContactPoints at{0, 0};
  double q = 0;

  double force_at(double stage) {
    for (;;) {
      const double S = 1 + at.left + at.right;
      const HeldState held = held_at(S, stage, {k}, q);
      q = held.state.q;
      const double a = left_side.at(1 + 2 * at.left).mu, b = right_side.at(1 + 2 * at.right).mu;
      if (held.holding == Holding::held && std::abs(q) <= std::min(a, b)) return held.state.F;
      const bool inwards = held.holding == Holding::beyond_friction || q > 0;
      (b < a ? at.right : at.left) += inwards ? h : -h;
    }
  }
};

}  // namespace

TEST_CASE("oracle: loops on two unlike supports, and where they touch, as both contact points walk step by step") {
  const double k = 40;
  std::vector<double> stages;
  const std::vector<double> turns{0.06, 0.32, 0.1, 0.36, 0.06, 0.3};
  for (std::size_t leg = 1; leg < turns.size(); ++leg)
    for (int i = 1; i <= 40; ++i) stages.push_back(turns[leg - 1] + (turns[leg] - turns[leg - 1]) * i / 40);
  const History history = follow_in_steps({unlike_sides(), {k}}, stages);
  REQUIRE(history.status == HistoryStatus::ok);
  REQUIRE(history.contacts.size() == stages.size());
  CHECK(history.snaps.size() > 3);
  SteppedFibre slow{k, 1e-6};
  int walked = 0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    CAPTURE(i);
    CHECK(history.path[i].F == doctest::Approx(slow.force_at(stages[i])).epsilon(2e-3));
    CHECK(std::abs(history.contacts[i].left - slow.at.left) < 2e-4);
    CHECK(1 + history.contacts[i].left + history.contacts[i].right ==
          doctest::Approx(history.path[i].S).epsilon(1e-14));
    walked += std::abs(history.contacts[i].left - history.contacts[i].right) > 0.01;
  }
  CHECK(walked > 10);  // sideways
}

TEST_CASE("identity: the energy account closes on two unlike supports, in steps and continuously, cracks and all") {
  const std::vector<double> turns{0, 0.32, 0.1, 0.36, 0.05, 0.3, 0};
  const std::vector<Crack> cracks{{0.1, 0.1}, {0.14, 0.05}};
  for (const auto& [cracked, half_depth] : {std::pair{false, 0.0}, {true, 0.0}, {false, 0.03}, {true, 0.03}}) {
    CAPTURE(half_depth);
    const BendingTest test{unlike_sides(), {40, Fibre(Supports{0, half_depth})}};
    for (const History& history :
         {follow_in_steps(test, std::span(turns).subspan(1), cracked ? cracks : std::vector<Crack>{}),
          follow_continuously(test, turns, 20, cracked ? cracks : std::vector<Crack>{})}) {
      REQUIRE(history.status == HistoryStatus::ok);
      CHECK(history.cracks.size() == (cracked ? 2 : 0));
      CHECK(std::abs(history.energy.imbalance) < 1e-10 * history.energy.stage_work);
    }
  }
}

TEST_CASE("identity: in steps and continuously a fibre on two different supports reaches the same state") {
  const std::vector<double> turns{0, 0.32, 0.1, 0.36, 0.05};
  const BendingTest test{unlike_sides(), {40}};
  const History steps = follow_in_steps(test, std::span(turns).subspan(1)), path = follow_continuously(test, turns, 7);
  CHECK(steps.path.back().F == doctest::Approx(path.path.back().F).epsilon(1e-12));
  CHECK(steps.contacts.back().left == doctest::Approx(path.contacts.back().left).epsilon(1e-11));
}

TEST_CASE("limit: a symmetric pair on falling friction goes one-sided, twice as steep in S") {
  const Friction falling = Friction::waves({.mu0 = 0.6, .drift = -0.3, .terms = {}, .S_reference = 1});
  const Friction twice = Friction::waves({.mu0 = 0.6, .drift = -0.6, .terms = {}, .S_reference = 1});
  const std::vector<double> stages{0.1, 0.2, 0.3};
  const History pair = follow_in_steps({Friction::on_two_supports(falling, falling, 1.6), {40}}, stages);
  const History one = follow_in_steps({twice, {40}}, stages);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    CHECK(pair.path[i].F == doctest::Approx(one.path[i].F).epsilon(1e-12));
    CHECK(pair.contacts[i].right == 0);
  }
}

TEST_CASE("identity: which of two unlike supports is named first changes no force, after no turn") {
  const auto falling = [](double mu0, double drift) {
    return Friction::waves({.mu0 = mu0, .drift = drift, .terms = {}, .S_reference = 1});
  };
  const Friction plateaus =
      Friction::table({{1, 1.02, 1.03, 1.05, 1.06, 1.1, 1.2}, {0.5, 0.5, 0.3, 0.3, 0.6, 0.6, 0.4}});
  const std::vector<std::pair<Friction, Friction>> pairs{
      {Friction::constant(0.5), falling(0.5, -1.2)},
      {falling(0.5, -0.4), falling(0.5, -1.2)},
      {Friction::constant(0.39), Friction::sinusoid(0.332, 0.745, 0.03, 3.58)},
      {falling(0.3, 0.6), falling(0.3, 1.2)},
      {falling(0.2, 0.6), falling(0.3, 1.2)},
      {Friction::sinusoid(0.5, 0.3, 0.09, 3), Friction::sinusoid(0.45, 0.3, 0.15, 3)},
      {Friction::constant(0.5), falling(0.5, 1.2)},
      {plateaus, Friction::sinusoid(0.5, 0.3, 0.02, 1)},
      {left_side, right_side}};
  std::vector<double> stages;
  const std::vector<double> turns{0, 0.32, 0.1, 0.31, 0.06};
  for (std::size_t leg = 1; leg < turns.size(); ++leg)
    for (int i = 1; i <= 30; ++i) stages.push_back(turns[leg - 1] + (turns[leg] - turns[leg - 1]) * i / 30);
  for (const double half_depth : {0.0, 0.02})
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      CAPTURE(n);
      const auto& [one, other] = pairs[n];
      const auto loops = [&](const Friction& left, const Friction& right) {
        return follow_in_steps({Friction::on_two_supports(left, right, 1.5), {60, Fibre(Supports{0, half_depth})}},
                               stages);
      };
      const History here = loops(one, other), there = loops(other, one);
      REQUIRE(here.path.size() == there.path.size());
      for (std::size_t i = 0; i < here.path.size(); ++i) {
        CHECK(here.path[i].F == doctest::Approx(there.path[i].F).epsilon(1e-9));
        CHECK(std::abs(here.contacts[i].left - there.contacts[i].right) < 1e-9);
      }
    }
}

TEST_CASE("limit: neither static excess nor overshoot on two unlike supports") {
  const Friction pair = unlike_sides();
  CHECK_THROWS_AS(follow_in_steps({{pair, Friction::constant(0.1)}, {40}}, std::vector{0.1}), std::invalid_argument);
  CHECK_THROWS_AS(follow_in_steps({pair, {40}, SnapRest::overshoot}, std::vector{0.1}), std::invalid_argument);
}

}  // namespace flexslip
