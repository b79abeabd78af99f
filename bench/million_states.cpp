// A million states in arrays, those that bench/python asks Python for.
#include <cmath>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "fibre/batch.h"

namespace flexslip {
namespace {

constexpr std::size_t count = 1'000'000;

// Evenly over [from, to), in an order without pattern: multiples of an irrational number.
std::vector<double> spread(double from, double to, double step) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double turns = static_cast<double>(i) * step;
    values.push_back(from + (to - from) * (turns - std::floor(turns)));
  }
  return values;
}

void million_states(benchmark::State& run) {
  const std::vector<double> S = spread(1, 1.6, 0.6180339887498949);
  const std::vector<double> q = spread(0, 0.8, 0.7548776662466927);
  for (auto _ : run) benchmark::DoNotOptimize(fibre_states(FibrePoints(S, q)));
}
BENCHMARK(million_states)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flexslip
