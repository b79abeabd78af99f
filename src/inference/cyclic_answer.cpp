#include "inference/cyclic_answer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bending_test/history.h"
#include "contact/build_up.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::size_t min_of_reversal = 6;
constexpr double grid = 1.04, shortest = 1.0 / 3000;  // of the longest way seen

struct Reversal {
  std::vector<double> way, q;  // [L], [1]
};

std::vector<Reversal> reversals_of(std::span<const Leg> legs, std::span<const CyclicPoint> points) {
  std::vector<Reversal> found;
  for (std::size_t leg = 1; leg < legs.size(); ++leg) {
    const double direction = legs[leg].direction == Direction::loading ? 1 : -1;
    const auto turned =
        std::find_if(points.begin(), points.end(), [&](const CyclicPoint& point) { return point.leg == leg; });
    if (turned == points.end() || turned->index != legs[leg].first) continue;
    Reversal reversal;
    double S = not_a_number;
    for (auto point = turned + 1; point != points.end() && point->leg == leg; ++point) {
      if (reversal.q.empty()) S = point->S;
      reversal.way.push_back(direction * (point->S - S));
      reversal.q.push_back(point->q);
    }
    if (reversal.q.size() >= min_of_reversal) found.push_back(std::move(reversal));
  }
  return found;
}

// The squares that a + b exp(-way/σ) leaves.
double misfit(const Reversal& reversal, double sigma, double up_to) {
  double n = 0, e = 0, ee = 0, y = 0, ey = 0, yy = 0;
  for (std::size_t i = 0; i < reversal.q.size() && (i < min_of_reversal || reversal.way[i] <= up_to); ++i) {
    const double decay = elementary::exp(-std::max(reversal.way[i], 0.0) / sigma), q = reversal.q[i];
    n += 1;
    e += decay;
    ee += decay * decay;
    y += q;
    ey += decay * q;
    yy += q * q;
  }
  const double spread = ee - e * e / n, together = ey - e * y / n;
  const double gained = spread > 0 ? together * together / spread : 0;
  return std::max(yy - y * y / n - gained, 0.0);
}

// What is slid from one row to the next, and five times its noise: nothing shorter can be told.
double resolution(std::span<const Reversal> reversals, double up_to) {
  std::vector<double> steps, bends;
  for (const Reversal& reversal : reversals)
    for (std::size_t i = 1; i < reversal.way.size() && (i < min_of_reversal || reversal.way[i] <= up_to); ++i)
      if (i < min_of_reversal || reversal.way[i] > 0.5 * up_to)
        steps.push_back(std::abs(reversal.way[i] - reversal.way[i - 1]));
  for (const Reversal& reversal : reversals) {
    std::size_t rows = std::min(min_of_reversal, reversal.way.size());
    while (rows < reversal.way.size() && reversal.way[rows] <= up_to) ++rows;
    const auto of_reversal = second_differences(std::span(reversal.way).first(rows));
    bends.insert(bends.end(), of_reversal.begin(), of_reversal.end());
  }
  return median_of(std::move(steps)) + 5 * noise_of_second_differences(std::move(bends));
}

struct Found {
  double length, window;
};

// The window grows until it is wide beside what is found in it.
Found best_length(std::span<const Reversal> reversals, double most) {
  constexpr double narrowest = 1.0 / 6, wide = 4;
  for (double window = narrowest * most;; window *= 2) {
    double found = 0, least = infinity;
    for (double sigma = shortest * most; sigma <= window; sigma *= grid) {
      double squares = 0;
      for (const Reversal& reversal : reversals) squares += misfit(reversal, sigma, window);
      if (squares < least) {
        least = squares;
        found = sigma;
      }
    }
    if (wide * found <= window || window >= most) return {found, window};
  }
}

}  // namespace

std::optional<BuildUpLength> measure_build_up(std::span<const Leg> legs, std::span<const CyclicPoint> points) {
  std::vector<Reversal> reversals = reversals_of(legs, points);
  if (reversals.empty()) return std::nullopt;
  double most = 0;
  for (const Reversal& reversal : reversals)
    most = std::max(most, *std::max_element(reversal.way.begin(), reversal.way.end()));
  if (!(most > 0)) return std::nullopt;
  const Found found = best_length(reversals, most);
  BuildUpLength result{normal_estimate(found.length, not_a_number), resolution(reversals, found.window)};
  if (reversals.size() < 2) return result;
  // Jackknife.
  double sum = 0, squares = 0;
  const auto n = static_cast<double>(reversals.size());
  for (std::size_t i = 0; i < reversals.size(); ++i) {
    std::swap(reversals[i], reversals.back());
    const double without = best_length(std::span(reversals).first(reversals.size() - 1), most).length;
    std::swap(reversals[i], reversals.back());
    sum += without;
    squares += without * without;
  }
  const double between = std::max((n - 1) * (squares / n - sum * sum / (n * n)), 0.0);
  result.length = normal_estimate(found.length, std::sqrt(between + std::pow(0.5 * (grid - 1) * found.length, 2)));
  return result;
}

double share_read(const BuildUpLength& build_up, double wavelength) {
  return share_after_build_up(build_up.length.value, wavelength);
}

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
  test.build_up = measure_build_up(friction.legs, friction.points);
  return test;
}

}  // namespace flexslip
