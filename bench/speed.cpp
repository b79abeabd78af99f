// How long the things take that everything is made of. The same work by Boost.Math's elliptic functions stands beside ours;
// bench/compare adds SciPy doing the paper's Algorithm 1 and prints the ratios.
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "bending_test/equilibrium.h"
#include "bending_test/history.h"
#include "fibre/elastica.h"
#include "inference/analysis.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

// States as a test visits them: S up to 1.5, friction from 0.3 to 0.8.
struct Inputs {
  std::vector<double> S, q;
  Inputs() {
    for (int i = 0; i < 1000; ++i) {
      S.push_back(1.0001 + 0.5 * i / 1000);
      q.push_back(0.3 + 0.5 * (i % 7) / 7);
    }
  }
};
const Inputs inputs;

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

// The closed form of the model by Boost.Math (without promotion to long double), and the root u by Newton's iteration with the
// same start and a derivative by a difference, until it stands still: the same state to ten digits.
struct BoostState {
  double w, F, S;
};

BoostState boost_closed_form(double u, double q) {
  namespace bm = boost::math;
  using Policy = bm::policies::policy<bm::policies::promote_double<false>>;
  const double beta0 = std::atan2(1.0, -q);
  const double k = std::sin(beta0 / 2);
  const double k1 = std::cos(beta0 / 2);
  double cn = 0;
  double dn = 0;
  const double sn = bm::jacobi_elliptic(k, u, &cn, &dn, Policy());
  const double phi = std::atan2(sn, cn);
  const double E = bm::ellint_2(k, phi, Policy());
  const double cd = cn / dn;
  const double b = 2 * std::asin(k * cd);
  const double C = (2 * E - u - 2 * k * k * sn * cd) / (2 * u);
  const double D = 2 * k * k1 * sn / dn / (2 * u);
  const double Ic = std::cos(b) * C + std::sin(b) * D;
  const double Is = std::cos(b) * D - std::sin(b) * C;
  return {.w = Is / (2 * Ic), .F = 32 * u * u * Ic * Ic * std::sin(b), .S = 1 / (2 * Ic)};
}

BoostState boost_state(double S, double q) {
  double u = std::sqrt(std::sqrt(15 * (1 - 1 / S) * (1 + q * q)));
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double h = 1e-6 * u;
    const double value = boost_closed_form(u, q).S;
    const double step = (value - S) / ((boost_closed_form(u + h, q).S - value) / h);
    u -= step;
    if (std::abs(step) < 1e-12 * u) break;
  }
  return boost_closed_form(u, q);
}

void state_by_boost(benchmark::State& run) {
  for (std::size_t i = 0; i < inputs.S.size(); i += 10) {
    const auto ours = fibre_state(inputs.S[i], inputs.q[i]);
    const auto theirs = boost_state(inputs.S[i], inputs.q[i]);
    // the closed form loses digits as 1/(S - 1)
    if (std::abs(ours.F - theirs.F) > 1e-9 * ours.F / (ours.S - 1)) run.SkipWithError("the states differ");
  }
  std::size_t i = 0;
  for (auto _ : run) {
    benchmark::DoNotOptimize(boost_state(inputs.S[i], inputs.q[i]));
    i = (i + 1) % inputs.S.size();
  }
}
BENCHMARK(state_by_boost);

void closed_form_by_boost(benchmark::State& run) {
  std::size_t i = 0;
  for (auto _ : run) {
    benchmark::DoNotOptimize(boost_closed_form(0.1 + 1.5 * static_cast<double>(i) / 1000, inputs.q[i]));
    i = (i + 1) % inputs.q.size();
  }
}
BENCHMARK(closed_form_by_boost);

void equilibrium_curve_2000(benchmark::State& run) {
  const Friction friction = Friction::sinusoid(0.6, 0.4, 0.0628318530717959, 0);
  for (auto _ : run) benchmark::DoNotOptimize(equilibrium_curve(friction, Sliding::in, 1.5, 2000));
}
BENCHMARK(equilibrium_curve_2000)->Unit(benchmark::kMillisecond);

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
