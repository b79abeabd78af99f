// The likelihood of readings with its gradient, ours.
#include "bench/likelihood.h"

#include "inference/chain.h"

namespace flexslip {
namespace {

void likelihood(benchmark::State& run) {
  const Readings readings = made_readings(run);
  Observations observations{.all = {}, .values = readings.values, .columns = {}, .prior = {}};
  observations.prior.assign(readings.columns[0].size(), prior);
  for (std::size_t i = 0; i < readings.places.size(); ++i) {
    observations.all.push_back(
        {.place = readings.places[i], .rows = i == 0 ? 0.0 : 1.0, .noise_gain = 1, .variance = own_variance});
    const auto& row = readings.columns[i];
    observations.columns.push_back(
        Eigen::Map<const Eigen::VectorXd>(row.data(), static_cast<Eigen::Index>(row.size())));
  }
  constexpr Hyperparameters at{.noise = noise, .correlation = 0, .roughness = roughness, .length = length};
  LikelihoodGradient found{};
  for (auto _ : run) {
    found = Chain(observations, Kernel::matern_3_2, at).gradient({});
    benchmark::DoNotOptimize(found);
  }
  report(run, {found.value, found.hyperparameters[0], found.hyperparameters[2], found.hyperparameters[3]});
}
BENCHMARK(likelihood)->ArgsProduct({{1, 7}, {100, 300, 1000, 3000}});

}  // namespace
}  // namespace flexslip
