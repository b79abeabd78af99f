// The path of Fig. 8B: all its folds, and the curve between them.
#include <string>

#include <benchmark/benchmark.h>

#include "bending_test/equilibrium.h"
#include "bending_test/rig.h"
#include "bending_test/trace.h"

namespace flexslip {
namespace {

const Friction friction = Friction::sinusoid(0.6, 0.4, 0.0628318530717959, 0);
const Rig rig{30};
constexpr double longest = 1.5;

void fig8_folds(benchmark::State& run) {
  int i = 0;
  for (const Fold& fold : trace_loading_curve(friction, rig, longest).folds) {
    const std::string name = "fold_" + std::to_string(++i);
    run.counters[name + "_S"] = fold.point.S;
    run.counters[name + "_stage"] = fold.point.stage;
  }
  for (auto _ : run) benchmark::DoNotOptimize(trace_loading_curve(friction, rig, longest));
}
BENCHMARK(fig8_folds);

void fig8_path(benchmark::State& run) {
  for (auto _ : run) {
    benchmark::DoNotOptimize(trace_loading_curve(friction, rig, longest));
    benchmark::DoNotOptimize(equilibrium_curve(friction, Sliding::in, longest, 2000));
  }
}
BENCHMARK(fig8_path);

}  // namespace
}  // namespace flexslip
