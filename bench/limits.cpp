// What a state costs at the least: its operations, counted by running the kernel on numbers that count, and how fast this processor does
// such operations, measured on nothing else. docs/numerics.md compares them with the times.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/limits.cpp"
#include <cstddef>
#include <cstdint>

#include <hwy/foreach_target.h>  // must come before highway.h

#include "fibre/elastica-inl.h"

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

// So many independent chains that the latency of an operation is hidden.
constexpr std::size_t chains = 12;

// Returns the number of products and sums done.
std::uint64_t multiply_and_add(std::uint64_t rounds, double* sink) {
  Lanes sums[chains];
  for (std::size_t i = 0; i < chains; ++i) sums[i] = Lanes(1.0 + static_cast<double>(i));
  const Lanes factor(0.999);
  const Lanes term(0.001);
  for (std::uint64_t round = 0; round < rounds; ++round)
    for (auto& sum : sums) sum = sum * factor + term;
  for (const auto& sum : sums) *sink += hn::GetLane(sum.v);
  return rounds * chains * 2 * hn::Lanes(DoubleTag());
}

std::uint64_t divide(std::uint64_t rounds, double* sink) {
  Lanes values[chains];
  for (std::size_t i = 0; i < chains; ++i) values[i] = Lanes(1.0 + static_cast<double>(i));
  for (std::uint64_t round = 0; round < rounds; ++round)
    for (auto& value : values) value = 3.7 / value;
  for (const auto& value : values) *sink += hn::GetLane(value.v);
  return rounds * chains * hn::Lanes(DoubleTag());
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

namespace flexslip {
namespace {

HWY_EXPORT(multiply_and_add);
HWY_EXPORT(divide);

// A number that counts what is done with it.
struct Operations {
  int sums, products, divisions, roots;
};
Operations operations;

struct Counted {
  double v;
  Counted(double value = 0) : v(value) {}  // NOLINT(google-explicit-constructor)
};
Counted operator+(Counted a, Counted b) { return ++operations.sums, a.v + b.v; }
Counted operator-(Counted a, Counted b) { return ++operations.sums, a.v - b.v; }
Counted operator-(Counted a) { return -a.v; }
Counted operator*(Counted a, Counted b) { return ++operations.products, a.v * b.v; }
Counted operator/(Counted a, Counted b) { return ++operations.divisions, a.v / b.v; }
Counted reciprocal(Counted a) { return 1.0 / a; }
Counted sqrt(Counted a) { return ++operations.roots, std::sqrt(a.v); }
Counted abs(Counted a) { return std::abs(a.v); }
bool operator<(Counted a, Counted b) { return a.v < b.v; }
Counted choose(bool mask, Counted yes, Counted no) { return mask ? yes : no; }

void report(benchmark::State& run) {
  run.counters["sums"] = operations.sums;
  run.counters["products"] = operations.products;
  run.counters["divisions"] = operations.divisions;
  run.counters["roots"] = operations.roots;
}

void operations_exact(benchmark::State& run) {
  using namespace HWY_NAMESPACE;
  for (auto _ : run) {
    operations = {};
    const Counted S = 1.3, q = 0.5;
    benchmark::DoNotOptimize(common_state<Counted>(S, q, force_line<Counted>(q)).F.v);
  }
  report(run);
}
BENCHMARK(operations_exact);

void operations_exact_slopes(benchmark::State& run) {
  using namespace HWY_NAMESPACE;
  for (auto _ : run) {
    operations = {};
    const Counted S = 1.3, q = 0.5;
    const auto line = force_line<Counted>(q);
    const auto state = common_state<Counted>(S, q, line);
    benchmark::DoNotOptimize(state_slopes<Counted>(S, state.u, line, common_doublings).F_q.v);
  }
  report(run);
}
BENCHMARK(operations_exact_slopes);

constexpr std::int64_t widest = 0;

template <class Function>
void peak(benchmark::State& run, std::int64_t instruction_set, const Function& work) {
  if (instruction_set != widest && (hwy::SupportedTargets() & instruction_set) == 0)
    return run.SkipWithError("the processor does not have this instruction set");
  hwy::SetSupportedTargetsForTest(instruction_set);
  hwy::GetChosenTarget().DeInit();
  double sink = 0;
  std::uint64_t done = 0;
  constexpr std::uint64_t rounds = 10000;
  for (auto _ : run) done += work(rounds, &sink);
  benchmark::DoNotOptimize(sink);
  run.SetItemsProcessed(static_cast<std::int64_t>(done));
  hwy::SetSupportedTargetsForTest(widest);
  hwy::GetChosenTarget().DeInit();
}
void peak_arithmetic_of(benchmark::State& run, std::int64_t instruction_set) {
  peak(run, instruction_set,
       [](std::uint64_t rounds, double* sink) { return HWY_DYNAMIC_DISPATCH(multiply_and_add)(rounds, sink); });
}
void peak_division_of(benchmark::State& run, std::int64_t instruction_set) {
  peak(run, instruction_set,
       [](std::uint64_t rounds, double* sink) { return HWY_DYNAMIC_DISPATCH(divide)(rounds, sink); });
}
void peak_arithmetic(benchmark::State& run) { peak_arithmetic_of(run, widest); }
void peak_division(benchmark::State& run) { peak_division_of(run, widest); }
void peak_arithmetic_avx2(benchmark::State& run) { peak_arithmetic_of(run, HWY_AVX2); }
void peak_division_avx2(benchmark::State& run) { peak_division_of(run, HWY_AVX2); }
BENCHMARK(peak_arithmetic);
BENCHMARK(peak_division);
BENCHMARK(peak_arithmetic_avx2);
BENCHMARK(peak_division_avx2);

}  // namespace
}  // namespace flexslip

#endif  // HWY_ONCE
