#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "fibre/elastica.h"
#include "tests/approximately.h"
#include "tests/bending_test/some_programme.h"
#include "tests/generators.h"

namespace flexslip {
namespace {

const std::vector<Crack> three{{0.12, 0.05}, {0.2, 0.2}, {0.21, 0.02}};

// Sliding in with constant friction and without snaps, the force at a stage position is a root in S alone.
double force_by_bisection(double mu, double left, double k, double stage) {
  double low = 1, high = 2.5;
  for (int i = 0; i < 200; ++i) {
    const double S = 0.5 * (low + high);
    const FibreState state = fibre_state(S, mu);
    (state.w + left * state.F / k < stage ? low : high) = S;
  }
  return left * fibre_state(low, mu).F;
}

}  // namespace

TEST_CASE("oracle: of constant friction the force after any cracks is a root in the length alone") {
  const double mu = 0.4, k = 40;
  std::vector<double> stages;
  for (int i = 1; i < 300; ++i) stages.push_back(0.0015 * i);
  const History history = follow_in_steps({Friction::constant(mu), {k}}, stages, three);
  REQUIRE(history.status == HistoryStatus::ok);
  REQUIRE(history.cracks.size() == 3);
  for (const PathPoint& point : history.path)
    CHECK(point.F == doctest::Approx(force_by_bisection(mu, point.left, k, point.stage)).epsilon(1e-12));
}

TEST_CASE("identity: a crack happens at its deflection, along the load line, at the length of before") {
  const double k = 40;
  for (const bool in_steps : {true, false}) {
    const BendingTest test{Friction::sinusoid(0.5, 0.15, 0.02, 1), {k}};
    const std::vector<double> stages{0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.45};
    const History history =
        in_steps ? follow_in_steps(test, stages, three) : follow_continuously(test, std::vector{0.45}, 9, three);
    REQUIRE(history.cracks.size() == 3);
    double left = 1;
    for (std::size_t i = 0; i < three.size(); ++i) {
      const auto& [stage, before, after, released] = history.cracks[i];
      CHECK(before.w >= three[i].w * (1 - 1e-14));
      if (i < 2) CHECK(before.w == doctest::Approx(three[i].w).epsilon(1e-13));  // the third is passed by the second
      CHECK(before.stage == after.stage);
      CHECK(before.S == after.S);
      CHECK(after.F < before.F);
      CHECK(before.F - after.F == doctest::Approx(k * (after.w - before.w)).epsilon(1e-9));
      CHECK(after.q > before.q);
      CHECK(released > 0);
      CHECK(after.F == doctest::Approx(after.left * fibre_state(after.S, after.q).F).epsilon(1e-13));
      left *= 1 - three[i].loss;
      CHECK(after.left == doctest::Approx(left).epsilon(1e-14));
    }
  }
}

TEST_CASE("oracle: a crack at small deflection, which no friction can hold, ends on the curve of the softer fibre") {
  const double mu = 0.45, k = 59;
  for (const auto& [w, loss] :
       {std::pair{0.002, 0.08}, std::pair{0.0001, 0.01}, std::pair{0.05, 0.6}, std::pair{0.1, 0.9}}) {
    CAPTURE(w);
    std::vector<double> stages;
    for (int i = 1; i < 200; ++i) stages.push_back(0.002 * i);
    const History history = follow_in_steps({Friction::constant(mu), {k}}, stages, std::vector<Crack>{{w, loss}});
    REQUIRE(history.status == HistoryStatus::ok);
    REQUIRE(history.cracks.size() == 1);
    const auto& [stage, before, after, released] = history.cracks.front();
    CHECK(after.w + after.F / k == doctest::Approx(stage).epsilon(1e-12));
    CHECK(after.F < before.F);
    CHECK(released > 0);
    for (const PathPoint& point : history.path)
      CHECK(point.F == doctest::Approx(force_by_bisection(mu, point.left, k, point.stage)).epsilon(1e-10));
    CHECK(std::abs(history.energy.imbalance) <= 1e-10 * history.energy.stage_work);
  }
}

TEST_CASE("limit: a rig of infinite stiffness sees the force fall by the loss, at a fixed deflection") {
  const std::vector<Crack> crack{{0.2, 0.3}};
  const History history = follow_continuously({Friction::constant(0.5), {std::numeric_limits<double>::infinity()}},
                                              std::vector{0.3}, 5, crack);
  REQUIRE(history.cracks.size() == 1);
  const auto& [stage, before, after, released] = history.cracks.front();
  CHECK(after.w == doctest::Approx(before.w).epsilon(1e-14));
  CHECK(after.F == doctest::Approx(0.7 * before.F).epsilon(1e-12));
  CHECK(history.snaps.empty());  // friction holds it as before
}

TEST_CASE("identity: the initial slope of a reload follows from the remaining bending stiffness") {
  const double loss = 0.25;
  const History history = follow_continuously({Friction::constant(0.3), {60}}, std::vector{0.3, 0.01, 0.02}, 40,
                                              std::vector<Crack>{{0.15, loss}});
  REQUIRE(history.status == HistoryStatus::ok);
  const PathPoint& last = history.path.back();
  CHECK(last.left == doctest::Approx(1 - loss));
  CHECK(last.F == doctest::Approx((1 - loss) * fibre_state(last.S, last.q).F).epsilon(1e-13));
}

TEST_CASE("identity: a crack that is never reached changes not a bit") {
  const BendingTest test{Friction::sinusoid(0.5, 0.3, 0.02, 1), {30}};
  const std::vector<double> programme{0.4, 0.1, 0.5};
  const History one = follow_continuously(test, programme, 7);
  const History other = follow_continuously(test, programme, 7, std::vector<Crack>{{3, 0.5}});
  REQUIRE(one.path.size() == other.path.size());
  bool same = true;
  for (std::size_t i = 0; i < one.path.size(); ++i)
    same = same && one.path[i].F == other.path[i].F && one.path[i].S == other.path[i].S;
  CHECK(same);
  CHECK(one.energy.friction == other.energy.friction);
}

TEST_CASE("energy: the account closes in any programme with any cracks (property)") {
  CHECK(rc::check([] {
    const BendingTest test{
        Friction::sinusoid(*between(0.1, 0.8), *between(0, 0.6), *between(0.01, 0.1), *between(0, 6.3)),
        {*between(10, 200)},
        *between(0, 1) < 0.5 ? SnapRest::nearest_stable : SnapRest::overshoot};
    std::vector<Crack> cracks;
    for (int i = *rc::gen::inRange(1, 8); i > 0; --i) cracks.push_back({*between(0.02, 0.4), *between(0.01, 0.5)});
    const double far = *between(0.2, 0.6);
    const std::vector<double> programme{far, *between(0, far), 0.6};
    const bool in_steps = *between(0, 1) < 0.5;
    std::vector<double> steps;
    for (int i = 1; i < 60; ++i) steps.push_back(0.01 * i);
    const History history =
        in_steps ? follow_in_steps(test, steps, cracks) : follow_continuously(test, programme, 4, cracks);
    double greatest = 0;
    for (const EnergyAccount& each : history.energy_at) greatest = std::max(greatest, each.stage_work);
    RC_ASSERT(std::abs(history.energy.imbalance) <= 1e-10 * greatest);
    RC_ASSERT(history.energy.cracks >= 0);
    RC_ASSERT(history.energy.snaps >= -1e-12 * greatest);
    RC_ASSERT(history.energy.friction >= 0);
    double w = 0;
    for (const PathPoint& point : history.path) w = std::max(w, point.w);
    const auto passed =
        std::count_if(cracks.begin(), cracks.end(), [&](const Crack& crack) { return crack.w < w * (1 - 1e-12); });
    if (history.status == HistoryStatus::ok) RC_ASSERT(static_cast<long>(history.cracks.size()) >= passed);
  }));
}

TEST_CASE("cracks at no deflection, without a loss or with nothing left are refused") {
  for (const Crack crack : {Crack{0, 0.1}, Crack{0.1, 0}, Crack{0.1, 1}, Crack{0.1, std::nan("")}})
    CHECK_THROWS_AS(CrackingFibre({Friction::constant(0.5), {50}}, {crack}, 0.3), std::invalid_argument);
}

}  // namespace flexslip
