// Readings of a Gaussian process of a Matérn 3/2 kernel, about a mean linear in columns, through white noise: the same for all whose likelihood of
// them is measured (bench/likelihood.cpp, bench/celerite.cpp, bench/cholesky.cpp). No Eigen: ours is compiled with another of its settings.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

namespace flexslip {

// Where the likelihood is asked for.
inline constexpr double noise = 0.02, roughness = 0.1, length = 0.02;  // σ, σ_g, ℓ
inline constexpr double own_variance = 1e-6;                           // of each reading, beside σ²
inline constexpr double prior = 1;                                     // variance of the coefficient of each column

struct Readings {
  std::vector<double> places, values;        // unevenly over a fifth of a span
  std::vector<std::vector<double>> columns;  // a row for each reading: Chebyshev's polynomials of its place
};

// As many columns and readings as the arguments of a benchmark say.
inline Readings made_readings(const benchmark::State& run) {
  const auto columns = static_cast<std::size_t>(run.range(0)), count = static_cast<std::size_t>(run.range(1));
  Readings made;
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal(0, 0.017);
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = static_cast<double>(i);
    const double part = (at + 0.4 * std::sin(2.4 * at) + 0.5) / static_cast<double>(count);
    const double turns = 2 * std::numbers::pi * part;
    made.places.push_back(0.2 * part);
    made.values.push_back(0.5 + 0.08 * std::sin(2.7 * turns) + 0.05 * std::sin(6.1 * turns + 1) + normal(generator));
    auto& row = made.columns.emplace_back();
    for (std::size_t j = 0; j < columns; ++j) row.push_back(std::cos(static_cast<double>(j) * std::acos(2 * part - 1)));
  }
  return made;
}

// ln p(y), and its derivatives to ln σ, ln σ_g and ln ℓ.
struct Likelihood {
  double value, by_noise, by_roughness, by_length;
};

inline void report(benchmark::State& run, const Likelihood& found) {
  run.counters["value"] = found.value;
  run.counters["by_noise"] = found.by_noise;
  run.counters["by_roughness"] = found.by_roughness;
  run.counters["by_length"] = found.by_length;
}

}  // namespace flexslip
