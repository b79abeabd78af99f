#include "inference/cyclic_answer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"

namespace flexslip {
namespace {

constexpr double span = 1e-3;
constexpr double EI = 2e-9;

// A cyclic record without noise of known friction, by the history of bending_test.
Record record_of(const Friction& friction, double stiffness, const std::vector<double>& turning_points) {
  std::vector<double> stages;
  double from = 0;
  for (const double point : turning_points) {
    for (int i = 1; i <= 150; ++i) stages.push_back(i == 150 ? point : from + (point - from) * i / 150);
    from = point;
  }
  const History history = follow_in_steps({friction, {stiffness}}, stages);
  ReducedRecord record;
  for (const PathPoint& point : history.path) {
    record.stage.push_back(point.stage);
    record.deflection.push_back(point.w);
    record.force.push_back(point.F);
  }
  return to_physical(record, Scales(span, EI));
}

}  // namespace

TEST_CASE("cyclic test: loops of known friction are run forward again, and their area is friction (identity)") {
  const Friction friction = Friction::sinusoid(0.4, 0.1, 0.04, 1);
  const Record record = record_of(friction, 60, {0.35, 0.02, 0.4, 0.02});
  const Scales scales(span, EI * 0.9);  // nominal: a tenth too soft
  const CyclicAnswer test = analyse_cycles(record, scales, {scales.reduced_stiffness(60 * EI / (span * span * span))});
  REQUIRE(test.friction.status == CyclesStatus::ok);
  CHECK(std::abs(test.friction.log_stiffness.value - std::log(1 / 0.9)) <= 2e-3);
  REQUIRE(test.energy.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(test.replay.residual_rms[i] <= 0.01);  // what the smoothed table leaves
    const LoopEnergy& energy = test.energy[i];
    CHECK(energy.lost == doctest::Approx(energy.loading - energy.unloading - energy.stored));
    CHECK(std::abs(energy.friction - energy.lost) <= 0.03 * energy.lost);  // trapezia; sticking loses nothing
  }
  REQUIRE(test.stiffness.size() == 2);
  CHECK(test.stiffness[0].status == LoadingStatus::ok);
}

TEST_CASE("cyclic test: what bending still stores is not lost (identity: the heat of friction of the path)") {
  const BendingTest bent{Friction::constant(0.4), {60}};
  const std::vector<double> turns{0, 0.35, 0.2, 0.4, 0.05};
  std::vector<double> stages;
  for (std::size_t leg = 1; leg < turns.size(); ++leg)
    for (int i = 1; i <= 120; ++i) stages.push_back(turns[leg - 1] + (turns[leg] - turns[leg - 1]) * i / 120);
  const History history = follow_in_steps(bent, stages);
  ReducedRecord record;
  for (const PathPoint& point : history.path) {
    record.stage.push_back(point.stage);
    record.deflection.push_back(point.w);
    record.force.push_back(point.F);
  }
  const Scales scales(span, EI);
  const CyclicAnswer test = analyse_cycles(to_physical(record, scales), scales, bent.rig);
  REQUIRE(test.energy.size() == 2);
  double lost = 0;
  for (const LoopEnergy& energy : test.energy) {
    CHECK(std::abs(energy.friction - energy.lost) <= 0.03 * energy.lost);
    lost += energy.lost;
  }
  CHECK(std::abs(test.energy.front().stored) > 0.2 * test.energy.front().loading);
  CHECK(std::abs(lost - history.energy.friction) <= 0.05 * history.energy.friction);
}

TEST_CASE("cyclic test: what comes after a loss of contact is not run forward, the next loop is (limit)") {
  // Friction so high that the wedge lifts off far above the end of the first unloading.
  const Friction friction = Friction::constant(0.9);
  Record record = record_of(friction, 100, {0.45, 0.3});
  const Record again = record_of(friction, 100, {0.2, 0.02, 0.3, 0.05});
  for (std::size_t i = 0; i < again.force.size(); ++i) {
    record.stage.push_back(again.stage[i]);
    record.deflection.push_back(again.deflection[i]);
    record.force.push_back(again.force[i]);
  }
  const Scales scales(span, EI);
  const CyclicAnswer test = analyse_cycles(record, scales, {100});
  REQUIRE((test.friction.status == CyclesStatus::ok || test.friction.status == CyclesStatus::no_mirror));
  REQUIRE(test.replay.force.size() == record.force.size());
  for (const FrictionLoop& loop : test.friction.loops) {  // each loop begins with a force, wherever the last one ended
    const Leg& leg = test.friction.legs[loop.loading.value()];
    CHECK(std::isfinite(test.replay.force[leg.first + 5]));
  }
  MESSAGE(std::count_if(test.replay.force.begin(), test.replay.force.end(), [](double F) { return std::isnan(F); }),
          " rows out of contact");
}

}  // namespace flexslip
