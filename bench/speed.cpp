// How long the things take that everything is made of. The same work by others stands beside it in the other files; bench/compare runs
// them all and prints the ratios.
#include <cmath>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include "bench/reference.h"
#include "bending_test/design.h"
#include "bending_test/equilibrium.h"
#include "bending_test/history.h"
#include "bending_test/rig.h"
#include "bending_test/trace.h"
#include "fibre/batch.h"
#include "fibre/batch_inverse.h"
#include "fibre/elastica.h"
#include "fibre/fibre.h"
#include "fibre/state_table.h"
#include "inference/analysis.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

const Points& inputs = visited_states();

void state(benchmark::State& run) {
  std::size_t i = 0;
  for (auto _ : run) {
    benchmark::DoNotOptimize(fibre_state(inputs.S[i], inputs.q[i]));
    i = (i + 1) % inputs.S.size();
  }
}
BENCHMARK(state);

void state_with_slopes(benchmark::State& run) {
  std::size_t i = 0;
  for (auto _ : run) {
    benchmark::DoNotOptimize(fibre_state_slopes(inputs.S[i], inputs.q[i]));
    i = (i + 1) % inputs.S.size();
  }
}
BENCHMARK(state_with_slopes);

void inverse(benchmark::State& run) {
  std::vector<FibreState> states;
  for (std::size_t i = 0; i < inputs.S.size(); ++i) states.push_back(fibre_state(inputs.S[i], inputs.q[i]));
  std::size_t i = 0;
  for (auto _ : run) {
    benchmark::DoNotOptimize(fibre_state_from_force(states[i].w, states[i].F));
    i = (i + 1) % states.size();
  }
}
BENCHMARK(inverse);

// The same in arrays, on the widest vectors that the processor has or on those of an instruction set named.
constexpr std::int64_t widest = 0;

template <class Function>
void in_arrays(benchmark::State& run, Function f, std::int64_t instruction_set) {
  if (instruction_set != widest && (hwy::SupportedTargets() & instruction_set) == 0)
    return run.SkipWithError("the processor does not have this instruction set");
  hwy::SetSupportedTargetsForTest(instruction_set);
  hwy::GetChosenTarget().DeInit();
  const Points& points = visited_states();
  report_errors(run, f(FibrePoints(reference_states().S, reference_states().q)));
  for (auto _ : run) benchmark::DoNotOptimize(f(FibrePoints(points.S, points.q)));
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(points.S.size()));
  hwy::SetSupportedTargetsForTest(widest);
  hwy::GetChosenTarget().DeInit();
}
void states_exact(benchmark::State& run) { in_arrays(run, fibre_states, widest); }
void states_tabulated(benchmark::State& run) { in_arrays(run, tabulated_states, widest); }
void states_exact_slopes(benchmark::State& run) { in_arrays(run, fibre_states_slopes, widest); }
void states_tabulated_slopes(benchmark::State& run) { in_arrays(run, tabulated_states_slopes, widest); }
BENCHMARK(states_exact);
BENCHMARK(states_tabulated);
BENCHMARK(states_exact_slopes);
BENCHMARK(states_tabulated_slopes);
void states_exact_avx2(benchmark::State& run) { in_arrays(run, fibre_states, HWY_AVX2); }
void states_tabulated_avx2(benchmark::State& run) { in_arrays(run, tabulated_states, HWY_AVX2); }
void states_exact_slopes_avx2(benchmark::State& run) { in_arrays(run, fibre_states_slopes, HWY_AVX2); }
void states_tabulated_slopes_avx2(benchmark::State& run) { in_arrays(run, tabulated_states_slopes, HWY_AVX2); }
BENCHMARK(states_exact_avx2);
BENCHMARK(states_tabulated_avx2);
BENCHMARK(states_exact_slopes_avx2);
BENCHMARK(states_tabulated_slopes_avx2);

// On rollers of 2 % of the span, of a specimen 3 % thick: one by one, and by the tables of one rig.
const Supports rollers{0.02, 0.015};

void state_on_rollers(benchmark::State& run) {
  const StateArrays states = fibre_states({inputs.S, inputs.q});
  std::size_t i = 0;
  for (auto _ : run) {
    benchmark::DoNotOptimize(state_on_supports(states.w[i], inputs.q[i], rollers));
    i = (i + 1) % states.w.size();
  }
}
BENCHMARK(state_on_rollers);

template <class Function>
void on_rollers(benchmark::State& run, Function f) {
  const Points& points = visited_states();
  const Fibre fibre(rollers);
  for (auto _ : run) benchmark::DoNotOptimize(f(fibre, FibrePoints(points.S, points.q)));
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(points.S.size()));
}
void states_on_rollers_tabulated(benchmark::State& run) {
  on_rollers(run, [](const Fibre& fibre, const FibrePoints& points) { return fibre.tabulated_states(points); });
}
void states_on_rollers_tabulated_slopes(benchmark::State& run) {
  on_rollers(run, [](const Fibre& fibre, const FibrePoints& points) { return fibre.tabulated_states_slopes(points); });
}
BENCHMARK(states_on_rollers_tabulated);
BENCHMARK(states_on_rollers_tabulated_slopes);

template <class Function>
void inverses_in_arrays(benchmark::State& run, Function f) {
  const auto points = visited_states();
  const StateArrays states = fibre_states({points.S, points.q});
  for (auto _ : run) benchmark::DoNotOptimize(f(states.w, states.F));
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(points.S.size()));
}
void inverse_exact(benchmark::State& run) { inverses_in_arrays(run, fibre_states_from_forces); }
void inverse_tabulated(benchmark::State& run) { inverses_in_arrays(run, tabulated_states_from_forces); }
BENCHMARK(inverse_exact);
BENCHMARK(inverse_tabulated);

void equilibrium_curve_2000(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.4, 0.0628318530717959, 0);
  for (auto _ : run) benchmark::DoNotOptimize(equilibrium_curve(friction, Sliding::in, 1.5, 2000));
}
BENCHMARK(equilibrium_curve_2000)->Unit(benchmark::kMicrosecond);

void tabulated_curve_2000(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.4, 0.0628318530717959, 0);
  for (auto _ : run) benchmark::DoNotOptimize(tabulated_equilibrium_curve(friction, Sliding::in, 1.5, 2000));
}
BENCHMARK(tabulated_curve_2000)->Unit(benchmark::kMicrosecond);

// All folds of a curve with 29 periods of the roughness, and where its snaps land.
void curve_with_25_snaps(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.2, 0.0085, 0);
  std::size_t parts = 0;
  for (auto _ : run) parts = stable_parts(trace_loading_curve(friction, {80}, 1.5)).size();
  run.counters["snaps"] = static_cast<double>(parts - 1);
}
BENCHMARK(curve_with_25_snaps)->Unit(benchmark::kMicrosecond);

// What `flexslip sweep` computes for each row, and `flexslip design` besides.
const Friction design_friction = Friction::sinusoid(0.5, 0.15, 10.9 / 1278, 1);

void design_with_33_snaps(benchmark::State& run) {
  std::size_t snaps = 0;
  for (auto _ : run) snaps = outcome_of({design_friction, {90}, 0.66, 2.0 / 1278}).snaps;
  run.counters["snaps"] = static_cast<double>(snaps);
}
BENCHMARK(design_with_33_snaps)->Unit(benchmark::kMicrosecond);

void critical_stiffness_of_33_snaps(benchmark::State& run) {
  for (auto _ : run) benchmark::DoNotOptimize(critical_stiffness(design_friction, 0.55));
}
BENCHMARK(critical_stiffness_of_33_snaps)->Unit(benchmark::kMicrosecond);

void test_with_25_snaps(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.2, 0.008, 0);
  std::vector<double> stages;
  for (int i = 1; i <= 300; ++i) stages.push_back(0.0018 * i);
  for (auto _ : run) benchmark::DoNotOptimize(follow_in_steps({friction, {80}}, stages));
}
BENCHMARK(test_with_25_snaps)->Unit(benchmark::kMillisecond);

// Ten cycles in 3,000 stage steps over a roughness like the spicules', with energies at each: 60 snaps, both ways.
void ten_cycles_3000_steps(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.15, 0.0085, 1);
  std::vector<double> stages;
  for (int cycle = 0; cycle < 10; ++cycle)
    for (const int direction : {1, -1})
      for (int i = 1; i <= 150; ++i) stages.push_back(0.25 + direction * (0.3 * i / 150 - 0.15));
  std::size_t snaps = 0;
  for (auto _ : run) {
    const History history = follow_in_steps({friction, {50}}, stages);
    snaps = history.snaps.size();
    benchmark::DoNotOptimize(snaps);
  }
  run.counters["snaps"] = static_cast<double>(snaps);
}
BENCHMARK(ten_cycles_3000_steps)->Unit(benchmark::kMillisecond);

// A test of 300 points, all models, intervals and the report's numbers included.
void analyse_300_points(benchmark::State& run) {
  const Scales scales(1278e-6, 2.1e-9);
  const SimulatedTruth truth{
      .friction = Friction::sinusoid(0.55, 0.2, 11.0 / 1278, 1), .stiffness = 110, .noise = 0.02};
  auto record = to_physical(simulated_record(truth), scales);
  record = first_points(record, 300);
  const TestDescription description{.span = scales.span(),
                                    .load_train_stiffness = scales.physical_stiffness(110),
                                    .bending_stiffness = scales.bending_stiffness()};
  for (auto _ : run) benchmark::DoNotOptimize(analyse(record, description));
  run.counters["points"] = static_cast<double>(record.force.size());
}
BENCHMARK(analyse_300_points)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flexslip
