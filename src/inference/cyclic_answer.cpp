#include "inference/cyclic_answer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bending_test/history.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

LoadingRange rows_of(const FrictionLoop& loop, const CyclicFriction& friction) {
  const Leg& from = friction.legs[loop.loading ? *loop.loading : *loop.unloading];
  const Leg& to = friction.legs[loop.unloading ? *loop.unloading : *loop.loading];
  return {from.first, to.last};
}

// Runs a programme forward. Where contact is lost, the next loop begins with a straight fibre; NaN until then.
std::vector<double> forces_of(const BendingTest& test, const std::vector<double>& stages,
                              const std::vector<LoadingRange>& loops) {
  std::vector<double> forces;
  forces.reserve(stages.size());
  for (const LoadingRange& loop : loops) {
    if (forces.size() > loop.first) continue;
    forces.resize(loop.first, not_a_number);
    const std::vector<double> rest(stages.begin() + static_cast<std::ptrdiff_t>(loop.first), stages.end());
    constexpr double least = 1e-4;  // [L] a stage that hardly moves bends nothing
    if (!(*std::max_element(rest.begin(), rest.end()) > least)) break;
    const TestPath loaded = path_in_steps(test, rest);
    for (const PathPoint& point : loaded.path) forces.push_back(point.F);
    if (loaded.status == HistoryStatus::slipped_through) break;
  }
  forces.resize(stages.size(), not_a_number);
  return forces;
}

LoopReplay replay_of(const ReducedRecord& record, const Rig& rig, const CyclicFriction& friction) {
  LoopReplay replay;
  replay.force.assign(record.force.size(), not_a_number);
  if (friction.table.S.size() < 2) return replay;
  const double stiffening = elementary::exp(friction.log_stiffness.value);
  std::vector<double> stages(record.stage);
  std::vector<LoadingRange> loops;
  loops.reserve(friction.loops.size());
  for (const FrictionLoop& loop : friction.loops) {
    const LoadingRange rows = loops.emplace_back(rows_of(loop, friction));
    for (std::size_t i = rows.first; i < rows.last; ++i)
      stages[i] = std::max(record.stage[i] - loop.contact.value, 0.0);
  }
  replay.force = forces_of({Friction::as_met(friction.table), rig.in_units_of(stiffening)}, stages, loops);
  for (double& force : replay.force) force *= stiffening;
  const double greatest = *std::max_element(record.force.begin(), record.force.end());
  for (const LoadingRange& rows : loops) {
    double sum = 0;
    double count = 0;
    for (std::size_t i = rows.first; i < rows.last; ++i) {
      if (!std::isfinite(replay.force[i])) continue;
      const double residual = replay.force[i] - record.force[i];
      sum += residual * residual;
      ++count;
    }
    replay.residual_rms.push_back(count > 0 ? std::sqrt(sum / count) / greatest : not_a_number);
  }
  return replay;
}

// ∫ F dw0 over the rows [first, last) past a deflection.
double work_over(const ReducedRecord& record, std::size_t first, std::size_t last, double min_deflection) {
  double work = 0;
  for (std::size_t i = first + 1; i < last; ++i)
    if (std::min(record.deflection[i - 1], record.deflection[i]) > min_deflection)
      work += 0.5 * (record.force[i] + record.force[i - 1]) * (record.deflection[i] - record.deflection[i - 1]);
  return work;
}

std::vector<LoopEnergy> energies_of(const ReducedRecord& record, const Fibre& fibre, const CyclicFriction& friction,
                                    const CyclesOptions& options) {
  const double stiffening = elementary::exp(friction.log_stiffness.value);
  std::vector<LoopEnergy> energies;
  energies.reserve(friction.loops.size());
  for (const FrictionLoop& loop : friction.loops) {
    LoopEnergy energy{};
    const auto work = [&](std::optional<std::size_t> leg) {
      if (!leg) return not_a_number;
      const Leg& rows = friction.legs[*leg];
      // The turning point belongs to both.
      const std::size_t first = rows.first > 0 ? rows.first - 1 : 0;
      return work_over(record, first, rows.last, options.min_deflection + loop.contact.value);
    };
    energy.loading = work(loop.loading);
    energy.unloading = -work(loop.unloading);
    const auto stored_in = [&](const CyclicPoint& point) { return stiffening * fibre.state(point.S, point.q).U; };
    const CyclicPoint *first = nullptr, *last = nullptr;
    for (const CyclicPoint& point : friction.points) {
      if (point.leg != loop.loading && point.leg != loop.unloading) continue;
      if (last && last->motion == point.motion && point.motion != LegMotion::stuck) {
        const double at_last = last->q * fibre.state(last->S, last->q).Pn;
        const double here = point.q * fibre.state(point.S, point.q).Pn;
        energy.friction += stiffening * 0.5 * (at_last + here) * (point.S - last->S);
      }
      if (!first) first = &point;
      last = &point;
    }
    energy.stored = first ? stored_in(*last) - stored_in(*first) : 0;
    energy.lost = energy.loading - energy.unloading - energy.stored;
    energies.push_back(energy);
  }
  return energies;
}

}  // namespace

CyclicAnswer analyse_cycles(const Record& record, const Scales& scales, const Rig& rig, const CyclesOptions& options) {
  const ReducedRecord reduced = to_reduced(record, scales);
  CyclicAnswer test{.friction = measure_cycles(reduced, rig, options), .energy = {}, .stiffness = {}, .replay = {}};
  const CyclicFriction& friction = test.friction;
  std::vector<LoadingRange> loadings;
  for (const Leg& leg : friction.legs)
    if (leg.direction == Direction::loading) loadings.push_back({leg.first, leg.last});
  if (!loadings.empty()) test.stiffness = compare_loadings(record, loadings);
  if (friction.status != CyclesStatus::ok && friction.status != CyclesStatus::no_mirror) return test;
  test.energy = energies_of(reduced, rig.fibre, friction, options);
  test.replay = replay_of(reduced, rig, friction);
  return test;
}

}  // namespace flexslip
