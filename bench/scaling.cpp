// How the time grows: with the points of a curve, with threads, with the snaps on a path.
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "bending_test/equilibrium.h"
#include "bending_test/history.h"

namespace flexslip {
namespace {

void points_of_a_curve(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.4, 0.0628318530717959, 0);
  const int n = static_cast<int>(run.range(0));
  for (auto _ : run) benchmark::DoNotOptimize(equilibrium_curve(friction, Sliding::in, 1.5, n));
  run.SetItemsProcessed(run.iterations() * n);
}
BENCHMARK(points_of_a_curve)->RangeMultiplier(10)->Range(100, 1'000'000);

// 512 curves of 2,000 points shared between threads. Wall time.
void curves_on_threads(benchmark::State& run) {
  constexpr std::int64_t curves = 512;
  const auto share = [count = curves / run.range(0)] {
    const Friction friction = Friction::sinusoid(0.6, 0.4, 0.0628318530717959, 0);
    for (std::int64_t i = 0; i < count; ++i)
      benchmark::DoNotOptimize(equilibrium_curve(friction, Sliding::in, 1.5, 2000));
  };
  for (auto _ : run) {
    std::vector<std::jthread> threads;
    for (std::int64_t i = 0; i < run.range(0); ++i) threads.emplace_back(share);
  }
  run.SetItemsProcessed(run.iterations() * curves * 2000);
}
BENCHMARK(curves_on_threads)->Arg(1)->Arg(2)->UseRealTime();

// A test in that many stage steps, over a roughness with that many periods on the way (none: constant friction).
void points_and_snaps(benchmark::State& run) {
  const auto points = static_cast<int>(run.range(0));
  const auto periods = static_cast<double>(run.range(1));
  const Friction friction = periods == 0 ? Friction::constant(0.6) : Friction::sinusoid(0.6, 0.4, 0.17 / periods, 0);
  std::vector<double> stages;
  stages.reserve(static_cast<std::size_t>(points));
  for (int i = 1; i <= points; ++i) stages.push_back(0.56 * i / points);
  std::size_t snaps = 0;
  for (auto _ : run) snaps = follow_in_steps({friction, {80}}, stages).snaps.size();
  run.counters["points"] = points;
  run.counters["snaps"] = static_cast<double>(snaps);
}
BENCHMARK(points_and_snaps)
    ->ArgsProduct({{1000, 10'000, 100'000}, {0, 10, 30, 100, 300}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flexslip
