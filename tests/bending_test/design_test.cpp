#include "bending_test/design.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "contact/over_rollers.h"
#include "fibre/elastica.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/fig_8.h"
#include "tests/generators.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

// The oracle: the slow follower of any history, with its own account of energy, and every reading computed.
History followed(const Design& design) {
  const BendingTest test{design.friction, design.rig};
  if (design.step == 0) return follow_continuously(test, std::vector{design.travel}, 2000);
  std::vector<double> stages;
  const int n = static_cast<int>(std::ceil(design.travel / design.step - 1e-9));
  for (int i = 1; i < n; ++i) stages.push_back(i * design.step);
  stages.push_back(design.travel);
  return follow_in_steps(test, stages);
}

struct CountedDrops {
  std::size_t count = 0;
  double largest = 0, sum = 0;
};

// Runs of decreasing readings.
CountedDrops drops_in(const std::vector<PathPoint>& path) {
  CountedDrops drops;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!(path[i].F < path[i - 1].F)) continue;
    const double top = path[i - 1].F;
    while (i < path.size() && path[i].F < path[i - 1].F) ++i;
    const double drop = top - path[i - 1].F;
    drops = {drops.count + 1, std::max(drops.largest, drop), drops.sum + drop};
  }
  return drops;
}

Design any_design() {
  const double wavelength = std::pow(10, *between(-2, -0.7));
  std::vector<Sinusoid> waves{{*between(0, 0.5), wavelength, *between(0, 6.28)}};
  if (*whole(0, 1) == 1) waves.push_back({*between(0, 0.5), wavelength * *between(0.3, 3), *between(0, 6.28)});
  return {Friction::waves({*between(0, 1.2), 0, waves}),
          {*whole(0, 9) == 0 ? infinity : std::pow(10, *between(0.7, 3))},
          *between(0.1, 0.9),
          std::pow(10, *between(-3.5, -1))};
}

}  // namespace

TEST_CASE("design, oracle: snaps, end and energies equal those of the simulated path") {
  CHECK(rc::check([] {
    Design design = any_design();
    design.step = 0;
    const auto outcome = outcome_of(design);
    const auto history = followed(design);
    RC_ASSERT((outcome.status == DesignStatus::ok) == (history.status == HistoryStatus::ok));
    RC_ASSERT(outcome.snaps == history.snaps.size());
    RC_ASSERT(snaps(design) == (outcome.snaps > 0));
    RC_ASSERT(outcome.stage_reached ==
              to(1e-12, history.path.back().stage));  // both solve G(S) = stage to its rounding
    RC_ASSERT(outcome.w_reached == to(1e-9, history.path.back().w));
    if (outcome.first_snap) {
      const auto& snap = history.snaps.front();
      RC_ASSERT(outcome.first_snap->stage == to(1e-12, snap.stage));
      RC_ASSERT(outcome.first_snap->w == to(1e-9, snap.before.w));  // at a fold S is known to the root of rounding
      RC_ASSERT(outcome.first_snap->F_before == to(1e-9, snap.before.F));
      RC_ASSERT(outcome.first_snap->F_after == to(1e-9, snap.after.F));
    }
    const double work = work_of_fracture(history.energy);
    // As the header promises, of the work measured.
    RC_ASSERT(std::abs(outcome.work - work) <= 1e-7 * work);
    RC_ASSERT(std::abs(outcome.friction_heat - history.energy.friction) <= 1e-5 * work);
    RC_ASSERT(std::abs(outcome.released - history.energy.snaps) <= 1e-5 * work);
    RC_ASSERT(outcome.work - outcome.friction_heat - outcome.released == to(1e-6, history.energy.bending));
    double most = 0;
    for (const auto& point : history.path) most = std::max(most, point.F);
    RC_ASSERT(outcome.greatest_force >= most * (1 - 1e-7));  // as promised
    RC_ASSERT(outcome.greatest_force <= most * 1.01);        // a peak between two of the follower's points
  }));
}

TEST_CASE("design, oracle: a fibre breaks where the simulated path first reaches the breaking curvature") {
  int broken = 0, sound = 0;
  CHECK(rc::check([&] {
    Design design = any_design();
    design.step = 0;
    design.breaking_curvature = *between(0.5, 6);
    const auto outcome = outcome_of(design);
    const auto history = followed(design);
    const auto curvature = [](const PathPoint& point) { return curvature_at_midspan(fibre_state(point.S, point.q)); };
    const auto first = std::find_if(history.path.begin(), history.path.end(),
                                    [&](const auto& point) { return curvature(point) >= design.breaking_curvature; });
    RC_ASSERT(snaps(design) == (outcome.snaps > 0));
    if (outcome.status == DesignStatus::breaks) {
      ++broken;
      RC_ASSERT(outcome.greatest_curvature == to(1e-9, design.breaking_curvature));
      // The follower has 2,000 points on a stretch, the design four on half a period: what is exceeded between those for a moment, a twentieth of a
      // period, is not seen.
      if (first == history.path.end()) return;
      RC_ASSERT(outcome.stage_reached >= first->stage * (1 - 0.02));
      RC_ASSERT(outcome.w_reached <= first->w * (1 + 0.1));
    } else {
      ++sound;
      double most = 0;
      for (const PathPoint& point : history.path) most = std::max(most, curvature(point));
      RC_ASSERT(outcome.greatest_curvature >= 0.98 * most);  // as the header says
      RC_ASSERT(outcome.greatest_curvature <= most * 1.01);  // a peak between two of the follower's points
      RC_ASSERT(most < 1.02 * design.breaking_curvature);
    }
  }));
  CHECK(broken > 10);
  CHECK(sound > 10);
}

TEST_CASE("design, limit: of constant friction the fibre breaks at its curvature, found by bisection of the length") {
  const Design design{Friction::constant(0.4), {60}, 0.6, 0, 3.0};
  const auto outcome = outcome_of(design);
  REQUIRE(outcome.status == DesignStatus::breaks);
  double low = 1, high = 2;
  for (int i = 0; i < 100; ++i) {
    const double S = 0.5 * (low + high);
    (curvature_at_midspan(fibre_state(S, 0.4)) < 3 ? low : high) = S;
  }
  const FibreState state = fibre_state(low, 0.4);
  CHECK(outcome.stage_reached == to(1e-12, state.w + state.F / 60));
  CHECK(outcome.w_reached == to(1e-12, state.w));
}

TEST_CASE("design, oracle: the drops equal the drops of a record in which every reading is computed") {
  CHECK(rc::check([] {
    const Design design = any_design();
    const auto outcome = outcome_of(design);
    const auto drops = drops_in(followed(design).path);
    RC_ASSERT(outcome.drops == drops.count);
    RC_ASSERT(std::abs(outcome.largest_drop - drops.largest) <= 1e-6 * outcome.greatest_force);  // as promised
    if (drops.count == 0) return;
    RC_ASSERT(std::abs(outcome.mean_drop - drops.sum / static_cast<double>(drops.count)) <=
              1e-6 * outcome.greatest_force);
  }));
}

TEST_CASE("design, oracle: a branch that ends between two teeth, found by random trials, is one that slips through") {
  // Friction that falls to nothing in each trough, where a fibre of more than S = 2.188 is not held.
  for (int i = 0; i < 24; ++i) {
    CAPTURE(i);
    const double phase = -8442.871758357654 + 2 * std::numbers::pi * i / 24;
    const Design design{Friction::sinusoid(0.24736754864318486, 1, 0.003642734684939927, phase),
                        {12.812041987299866},
                        1.7020176478768336,
                        0};
    const auto outcome = outcome_of(design);
    const auto history = followed(design);
    CHECK(outcome.status == DesignStatus::slipped_through);
    CHECK(outcome.snaps == history.snaps.size());
    CHECK(outcome.stage_reached ==
          to(1e-6, history.path.back().stage));  // at a fold, S is known to the root of rounding
  }
}

TEST_CASE("design, oracle: a fibre that slips through within a smooth segment is followed to this point") {
  // The force is lost between two of the tracer's points, which are all on the branch.
  const Design design{Friction::sinusoid(0.5, 0.002, 0.0020704635518614778, 1), {infinity}, 3, 0};
  const auto outcome = outcome_of(design);
  const auto history = followed(design);
  REQUIRE(outcome.status == DesignStatus::slipped_through);
  CHECK(outcome.drops > 1000);
  // Both stop short of the loss, each by a piece of its own: a part of a period of 0.004, at S of about 2.
  CHECK(outcome.stage_reached == to(1e-3, history.path.back().stage));
  CHECK(outcome.work == to(1e-3, work_of_fracture(history.energy)));
  CHECK(outcome.friction_heat > 0);
}

TEST_CASE("design, limit: the smallest loadings arrive") {
  for (double travel = 1.1e-6; travel < 1e-5; travel *= 1.03) {
    CAPTURE(travel);
    CHECK(outcome_of({Friction::constant(0.5), {infinity}, travel, 0}).status == DesignStatus::ok);
  }
}

TEST_CASE("design, limit: two knots of a table a few roundings apart are a step of friction") {
  for (int n = 1; n <= 40; ++n) {
    const double S = 1.3;
    const auto friction = Friction::table({{1, S, S + n * 0x1p-52, 3}, {0.3, 0.3, 0.5, 0.5}});
    CHECK(outcome_of({friction, {30}, 0.6, 1e-3}).status == DesignStatus::ok);
  }
}

TEST_CASE("design, identity: the margin of the stiffness is negative just where the specimen snaps") {
  CHECK(rc::check([] {
    Design design = any_design();
    const auto outcome = outcome_of(design);
    RC_PRE(outcome.status == DesignStatus::ok);
    const double margin = stiffness_margin(design, outcome);
    if (outcome.snaps > 0)
      RC_ASSERT(margin < 1e-8);
    else
      RC_ASSERT(margin > -1e-8);
  }));
}

TEST_CASE("design, identity: on the critical stiffness the margin is nothing") {
  Design design{friction_of_fig_8(), {30}, 0.76, 0};
  design.rig.stiffness = critical_stiffness(design);
  CHECK(std::abs(stiffness_margin(design, outcome_of(design))) < 1e-6);
}

TEST_CASE("design, paper: Fig. 8C snaps three times, first at the fold of its first tooth") {
  const auto outcome = outcome_of({friction_of_fig_8(), {30}, 0.76, 0});
  CHECK(outcome.status == DesignStatus::ok);
  CHECK(outcome.snaps == 3);
  CHECK(outcome.first_snap->stage == to(1e-6, 0.588456));  // the digits printed
}

TEST_CASE("design, limit: readings further apart than the teeth do not show them") {
  const Friction fine = Friction::sinusoid(0.5, 0.15, 10.9 / 1278, 1);
  const auto seen = outcome_of({fine, {90}, 0.3, 1e-4});
  const auto unseen = outcome_of({fine, {90}, 0.3, 0.15});
  CHECK(seen.snaps == unseen.snaps);
  CHECK(seen.drops > 0);
  CHECK(unseen.drops == 0);
}

TEST_CASE("design, limit: a rig stiffer than the critical one does not snap, and a softer one does") {
  CHECK(rc::check([] {
    Design design = any_design();
    design.travel = *between(0.3, 0.9);
    const double w_max = 0.3;
    const double critical = critical_stiffness(design.friction, w_max);
    RC_PRE(critical > 10 && critical < infinity);
    design.rig.stiffness = critical * 1.001;
    const auto stiff = outcome_of(design);
    if (stiff.first_snap) RC_ASSERT(stiff.first_snap->w > w_max * (1 - 1e-9));
    design.rig.stiffness = critical * 0.999;
    design.travel = 3;
    const auto soft = outcome_of(design);
    if (soft.first_snap)
      RC_ASSERT(soft.first_snap->w < w_max * (1 + 1e-9));
    else
      RC_ASSERT((soft.status == DesignStatus::slipped_through));  // a snap that finds no rest
  }));
}

TEST_CASE("design, limit: no rig stiffer than the critical one of a loading snaps in it, and one a hair softer does") {
  // The last is so thick that its force may fall as soon as it slides in.
  static const std::vector<Fibre> fibres{Fibre(), Fibre(), Fibre(Supports{0, 0.03}), Fibre(Supports{0.06, 0.03}),
                                         Fibre(Supports{0, 0.1})};
  CHECK(rc::check([] {
    Design design = any_design();
    design.rig.fibre = fibres[static_cast<std::size_t>(*whole(0, 4))];
    if (!(design.friction.steepest() < steepest_followed(design.rig.fibre, 1, 2))) design.rig.fibre = {};
    const double critical = critical_stiffness(design);
    RC_ASSERT(critical <=
              critical_stiffness(design.friction, design.travel, design.rig.fibre) * (1 + 2e-7));  // rounded up by 1e-7
    RC_PRE(critical > 1 && critical < infinity);
    for (const double times : {1.0, 1 + 1e-4, 1.1, 2.0, 10.0}) {
      design.rig.stiffness = times * critical;
      RC_ASSERT(outcome_of(design).snaps == 0U);
    }
    design.rig.stiffness = critical * (1 - 1e-5);
    const auto soft = outcome_of(design);
    RC_ASSERT((soft.snaps > 0 || soft.status == DesignStatus::slipped_through));
  }));
}

TEST_CASE(
    "design, oracle: the maximum force is computed from a state if the polynomial of its tooth errs by more than "
    "1e-7") {
  const Friction friction = Friction::sinusoid(1.15744, 0.378589, 0.0350599, 3.0662);
  const auto outcome = outcome_of({friction, {185.1}, 0.5, 0});
  double most = 0;
  for (int i = 0; i <= 100'000; ++i) {
    const double S = 1.2 + 0.05 * i / 100'000;
    most = std::max(most, fibre_state(S, friction.at(S).mu).F);
  }
  CHECK(outcome.greatest_force == to(1e-9, most));
}

TEST_CASE("design, limit: the maximum force may occur at a corner of the friction") {
  const Friction ramp = Friction::table({{1.1, 1.3}, {0.2, 1.0}});
  const auto outcome = outcome_of({ramp, {1000}, 0.9, 0});
  CHECK(outcome.greatest_force == to(1e-9, fibre_state(1.3, 1).F));  // 1e-9: the polynomial at its end
  CHECK(outcome.greatest_force >= outcome.largest_drop);
}

TEST_CASE("design, limit: a fibre on a soft rig slips through") {
  const auto outcome = outcome_of({Friction::constant(0.5), {5}, 3.66, 0.01});
  CHECK(outcome.status == DesignStatus::slipped_through);
  CHECK(outcome.stage_reached < 3.66);
}

TEST_CASE("design, contract: what is out of its domain is refused with its value") {
  CHECK(message_of([] { outcome_of({friction_of_fig_8(), {30}, 0, 0}); }).find("0.000000") != std::string::npos);
  CHECK(message_of([] { outcome_of({friction_of_fig_8(), {0}, 0.5, 0}); }).find("0.000000") != std::string::npos);
  CHECK(message_of([] { outcome_of({friction_of_fig_8(), {30}, 0.5, -1}); }).find("-1") != std::string::npos);
  CHECK(message_of([] { outcome_of({friction_of_fig_8(), {30}, 0.5, infinity}); }).find("inf") != std::string::npos);
  CHECK(message_of([] { outcome_of({friction_of_fig_8(), {30}, 0.5, 1e-30}); }).find("readings") != std::string::npos);
}

TEST_CASE("design, limit: a friction table that ends just beyond the span equals its last value, at no extra cost") {
  const Fibre thick(Supports{0, 0.0136});
  const Design constant{Friction::constant(0.5), {90, thick}, 0.4, 2e-3};
  const auto effort_of = [](const Design& design, DesignOutcome& outcome) {
    effort_spent.clear();
    outcome = outcome_of(design);
    return effort_spent.spent();
  };
  DesignOutcome expected{}, found{};
  outcome_of(constant);  // builds the tables
  const auto work = effort_of(constant, expected);
  for (const double beyond : {1e-14, 1e-9, 1e-6, 1e-3}) {
    CAPTURE(beyond);
    const Design design{Friction::table({{1.0, 1 + beyond}, {0.5, 0.5}}), {90, thick}, 0.4, 2e-3};
    CHECK(effort_of(design, found) < 4 * work + 20'000);  // of each halving of the way to its knots
    CHECK(found.work == to(1e-9, expected.work));
    CHECK(found.friction_heat == to(1e-9, expected.friction_heat));
  }
}

}  // namespace flexslip
