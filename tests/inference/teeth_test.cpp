#include "inference/teeth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "data/scales.h"
#include "fibre/elastica.h"

using namespace flexslip;

namespace {

// Everything is simulated by its own code here: only the map Ψ is shared with what is tested.
constexpr double k = 90;               // [EI/L^3] of the authors' tests
constexpr double step = 2.0 / 1278;    // [L] likewise
constexpr double usual_noise = 0.004;  // [EI/L^2] likewise: 5 µN for EI/L^3 = 1 N/m
const Scales teeth_scales(1278e-6, 1278e-6 * 1278e-6 * 1278e-6);
constexpr MeasurementErrors known{.force = usual_noise, .bending_stiffness = 0.03, .contact = 1e-3};

struct Simulated {
  ReducedRecord record;
  std::vector<double> S;  // [L] true, of each row
};

struct Noise {
  double deviation = usual_noise;
  double rho = 0;
  unsigned seed = 1;
};

void add_row(Simulated& test, double stage, const FibreState& state) {
  test.record.stage.push_back(stage);
  test.record.force.push_back(state.F);
  test.record.deflection.push_back(stage - state.F / k);
  test.S.push_back(state.S);
}

Simulated with_noise(Simulated test, const Noise& noise) {
  std::mt19937_64 generator(noise.seed);
  std::normal_distribution<double> normal;
  double error = 0;
  for (std::size_t i = 0; i < test.S.size(); ++i) {
    error = noise.rho * error + noise.deviation * std::sqrt(1 - noise.rho * noise.rho) * normal(generator);
    test.record.force[i] += error;
    test.record.deflection[i] -= error / k;
  }
  return test;
}

double stage_of(const FibreState& state) { return state.w + state.F / k; }

template <class Function>
double bisected(double low, double high, double target, Function rising) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (rising(middle) < target ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The paper's mechanism: slides along q = μ(S), the measured state being the first S whose stage position is reached.
Simulated rough_ground(double amplitude, double wavelength) {
  Simulated test;
  const auto state_at = [=](double S) {
    return fibre_state(S, 0.6 * (1 + amplitude * std::cos(std::numbers::pi * S / wavelength)));
  };
  double S = 1.02;
  double stage = stage_of(state_at(S));
  for (int row = 0; row < 230; ++row, stage += step) {
    const double coarse = wavelength / 500;
    while (stage_of(state_at(S)) < stage) S += coarse;
    if (row > 0) S = bisected(S - coarse, S, stage, [&](double at) { return stage_of(state_at(at)); });
    add_row(test, stage, state_at(S));
  }
  return test;
}

// Static-kinetic stick-slip: stuck, on supports of compliance C, until q = μ_s; then at constant stage along q = μ_k to where that holds it.
Simulated stick_slip(double C) {
  constexpr double mu_s = 0.75, mu_k = 0.45;
  Simulated test;
  double S0 = 1.03;  // where it came to rest, with q = μ_k
  double stage = stage_of(fibre_state(S0, mu_k));
  const auto stuck = [&](double q) {
    const FibreState rest = fibre_state(S0, mu_k);
    FibreState state = fibre_state(S0, q);
    for (int i = 0; i < 40 && C > 0; ++i) state = fibre_state(S0 + C * (q * state.Pn - mu_k * rest.Pn), q);
    return state;
  };
  for (int row = 0; row < 230; ++row, stage += step) {
    if (stage_of(stuck(mu_s)) < stage)
      S0 = bisected(S0, 2.0, stage, [](double S) { return stage_of(fibre_state(S, mu_k)); });
    add_row(test, stage, stuck(bisected(mu_k - 0.01, mu_s, stage, [&](double q) { return stage_of(stuck(q)); })));
  }
  return test;
}

Teeth judged(const Simulated& test, const ToothOptions& options = {.min_share = 0.1}) {
  const auto drops = find_drops(to_physical(test.record, teeth_scales));
  return judge_teeth(test.record, {k}, known, drops.drops, options);
}

std::size_t count(const Teeth& teeth, ToothVerdict verdict) {
  return static_cast<std::size_t>(std::count_if(teeth.teeth.begin(), teeth.teeth.end(),
                                                [=](const Tooth& tooth) { return tooth.verdict == verdict; }));
}

TEST_CASE("oracle: stick-slip simulated without noise has position 1, whatever EI within its error") {
  const auto teeth = judged(with_noise(stick_slip(0), {.deviation = 1e-7}));
  REQUIRE(teeth.teeth.size() >= 4);
  for (const Tooth& tooth : teeth.teeth) {
    CHECK(std::abs(tooth.position.value - 1) < 2e-3);  // second order in the rise, a few hundredths of a span
    CHECK(tooth.position_systematic < 0.02);           // the stick limit is hardly anything but k
    CHECK(tooth.verdict == ToothVerdict::as_if_stuck);
  }
}

TEST_CASE("oracle: the advance of the fibre over rough ground is that of the simulation") {
  for (const double amplitude : {0.1, 0.2}) {
    const auto test = with_noise(rough_ground(amplitude, 0.015), {.deviation = 1e-7});
    const auto teeth = judged(test);
    REQUIRE(teeth.teeth.size() >= 3);
    for (const Tooth& tooth : teeth.teeth) {
      const double truth = test.S[tooth.last - 1] - test.S[tooth.first];
      CHECK(std::abs(tooth.S_end - tooth.S_begin - truth) < 1e-6);  // noise of 1e-7 in F
    }
  }
}

TEST_CASE(
    "simulation: 200 noisy stick-slip tests and 200 over rough ground are judged wrongly no more often than stated") {
  const Simulated held = stick_slip(0);
  const std::vector<Simulated> rough{rough_ground(0.1, 0.015), rough_ground(0.2, 0.015)};
  for (const double rho : {0.0, 0.5}) {
    std::size_t stuck = 0, stuck_right = 0, stuck_wrong = 0, slid = 0, slid_right = 0, slid_wrong = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
      const auto still = judged(with_noise(held, {.rho = rho, .seed = seed}));
      stuck += still.teeth.size();
      stuck_right += count(still, ToothVerdict::as_if_stuck);
      stuck_wrong += count(still, ToothVerdict::sliding);
      const auto moving = judged(with_noise(rough[seed % 2], {.rho = rho, .seed = seed}));
      slid += moving.teeth.size();
      slid_right += count(moving, ToothVerdict::sliding);
      slid_wrong += count(moving, ToothVerdict::as_if_stuck);
    }
    MESSAGE("rho " << rho << ": of " << stuck << " stuck teeth " << stuck_right << " sticking, " << stuck_wrong
                   << " sliding; of " << slid << " sliding teeth " << slid_right << " sliding, " << slid_wrong
                   << " sticking");
    REQUIRE(stuck > 500);
    REQUIRE(slid > 500);
    CHECK(static_cast<double>(stuck_wrong) <= 0.05 * static_cast<double>(stuck));  // the stated confidence
    CHECK(static_cast<double>(slid_wrong) <= 0.05 * static_cast<double>(slid));
    CHECK(static_cast<double>(stuck_right) >= 0.8 * static_cast<double>(stuck));  // and not by never deciding
    CHECK(static_cast<double>(slid_right) >= 0.8 * static_cast<double>(slid));
  }
}

TEST_CASE(
    "simulation: a stuck fibre on compliant supports gives their compliance back within its interval, 200 seeds") {
  const double C = 0.0026;  // [L^3/EI] 2.6 um/mN at EI/L^3 = 1 N/m
  const Simulated compliant = stick_slip(C);
  int covered = 0, rejected = 0, sticking = 0;
  std::size_t teeth_all = 0;
  const int tests = 200;
  for (unsigned seed = 0; seed < tests; ++seed) {
    const auto teeth = judged(with_noise(compliant, {.seed = seed}));
    REQUIRE(teeth.compliance.is_found());
    covered += std::abs(teeth.compliance.estimate.value - C) <= 1.96 * teeth.compliance.estimate.standard_error;
    rejected += teeth.compliance.p_value < 0.05;
    teeth_all += teeth.teeth.size();
    sticking += static_cast<int>(count(teeth, ToothVerdict::as_if_stuck));
  }
  MESSAGE("C covered in " << covered << " of " << tests << " tests, one compliance rejected at 5 % in " << rejected
                          << ", of " << teeth_all << " teeth " << sticking << " judged rigidly stuck");
  CHECK(covered >= 0.9 * tests);
  CHECK(rejected <= (0.05 + 3 * std::sqrt(0.05 * 0.95 / tests)) * tests);  // three deviations of a count
}

TEST_CASE("limit: rises too short are counted, not judged, and options out of range are refused") {
  const auto test = with_noise(stick_slip(0), {});
  const auto drops = find_drops(to_physical(test.record, teeth_scales)).drops;
  REQUIRE(drops.size() >= 2);
  std::vector<Drop> close = drops;  // of which each begins three rows after the end of the one before
  for (std::size_t i = 1; i < close.size(); ++i) {
    close[i].before = close[i - 1].after + 2;
    close[i].after = close[i].before + 1;
  }
  const auto none = judge_teeth(test.record, {k}, known, close);
  CHECK(none.teeth.empty());
  CHECK(none.too_short == drops.size() - 1);
  CHECK(!none.compliance.is_found());
  CHECK(judge_teeth(test.record, {k}, known, {}).teeth.empty());
  CHECK_THROWS_AS(judge_teeth(test.record, {INFINITY}, known, drops), std::invalid_argument);
  CHECK_THROWS_AS(judge_teeth(test.record, {k}, known, drops, {.min_share = 1}), std::invalid_argument);
  auto reversed = drops;
  std::reverse(reversed.begin(), reversed.end());
  CHECK_THROWS_AS(judge_teeth(test.record, {k}, known, reversed), std::invalid_argument);
}

}  // namespace
