// What the verdict on slips and cracks goes by, on simulated tests and on tests of others: tools/calibrate-verdict fits its probability to this.
//   verdicts KIND FIRST COUNT            a line of CSV for each simulated test of the kind
//   verdicts KIND FIRST COUNT rollers    likewise, each on rollers of 0.01 to 0.12 of the span
//   verdicts                    the kinds
//   verdicts -                  for each record on standard input: a line NAME CRACKS_ALONE LOAD_TRAIN THICKNESS ROWS, and as many of STAGE FORCE
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "bench/simulated_tests.h"
#include "data/drops.h"
#include "data/scales.h"
#include "inference/slip_or_crack.h"

namespace flexslip {
namespace {

double log_between(Random& random, double a, double b) { return std::exp(random.between(std::log(a), std::log(b))); }

// What friction along both sides comes to in loading: the weaker side slides.
std::vector<double> weaker_of(const std::vector<double>& left, const std::vector<double>& right) {
  std::vector<double> weaker;
  std::size_t l = 0, r = 0;
  while (l + 1 < left.size() && r + 1 < right.size()) {
    weaker.push_back(std::min(left[l], right[r]));
    ++(left[l] <= right[r] ? l : r);
  }
  return weaker;
}

// Falls with the length that has slid, as where the first contact is worn off: this part of the friction, within so many µm.
std::vector<double> running_in(double part, double length) {
  constexpr int count = 1680;
  constexpr double spacing = 0.25;
  std::vector<double> bumps;
  for (int i = 0; i < count; ++i) bumps.push_back(part * std::exp(-i * spacing / length));
  return bumps;
}

void add(std::vector<double>& bumps, const std::vector<double>& more) {
  for (std::size_t i = 0; i < bumps.size(); ++i) bumps[i] += more[i];
}

struct Loss {
  double w, share;  // at which deflection [L], of the bending stiffness left
};

struct SimulatedTest {
  Truth friction;
  std::vector<Loss> losses;  // in the order of their deflections
  double loss_of_slip = 0;   // [1] of the bending stiffness, at each slip that is seen
  double deepest = 0;        // [L]
  double radius = 0;         // [L] of the supports
};

struct TestKind {
  const char* name;
  SimulatedTest (*make)(Random& random);
};

SimulatedTest sliding(Random& random) {
  SimulatedTest test;
  test.friction.mu0 = random.between(0.05, 0.95);
  test.deepest = random.between(0.15, 0.45);
  return test;
}

void add_wave(SimulatedTest& test, Random& random) {
  Truth& t = test.friction;
  t.waves.push_back({t.mu0 * random.between(0.05, 0.35), log_between(random, 7, 55), random.between(0, 2 * pi)});
}

SimulatedTest wave(Random& random) {
  SimulatedTest test = sliding(random);
  add_wave(test, random);
  return test;
}

SimulatedTest two_waves(Random& random) {
  SimulatedTest test = wave(random);
  add_wave(test, random);
  return test;
}

SimulatedTest rough(Random& random, Kernel kernel) {
  SimulatedTest test = sliding(random);
  test.friction.bumps = matern_bumps(random.between(0.03, 0.18), log_between(random, 3, 20), random, kernel);
  test.friction.spacing = 0.25;
  return test;
}
SimulatedTest rough_1_2(Random& random) { return rough(random, Kernel::exponential); }
SimulatedTest rough_3_2(Random& random) { return rough(random, Kernel::matern_3_2); }
SimulatedTest rough_smooth(Random& random) {
  SimulatedTest test = sliding(random);
  test.friction.bumps = smooth_bumps(random.between(0.03, 0.18), log_between(random, 3, 20), random);
  test.friction.spacing = 0.25;
  return test;
}

SimulatedTest rough_wave(Random& random) {
  SimulatedTest test = rough_3_2(random);
  add_wave(test, random);
  return test;
}

SimulatedTest rough_slow(Random& random) {
  SimulatedTest test = rough_3_2(random);
  add(test.friction.bumps, smooth_bumps(random.between(0.05, 0.25), log_between(random, 20, 100), random));
  return test;
}

SimulatedTest rough_running_in(Random& random) {
  SimulatedTest test = rough_3_2(random);
  add(test.friction.bumps, running_in(random.between(0.1, 0.6), log_between(random, 10, 80)));
  return test;
}

// Few high peaks or few deep holes.
SimulatedTest rough_skewed(Random& random) {
  SimulatedTest test = sliding(random);
  const double side = random.uniform() < 0.5 ? -1 : 1, rms = random.between(0.03, 0.18);
  test.friction.bumps = matern_bumps(1, log_between(random, 3, 20), random);
  constexpr double skew = 0.7;
  for (double& bump : test.friction.bumps) bump = side * rms * std::expm1(skew * bump) / skew;
  test.friction.spacing = 0.25;
  return test;
}

SimulatedTest two_supports(Random& random) {
  SimulatedTest test = rough_3_2(random);
  test.friction.bumps =
      weaker_of(test.friction.bumps, matern_bumps(random.between(0.03, 0.18), log_between(random, 3, 20), random));
  test.friction.spacing *= 0.5;  // in (S - 1)/2, of which each side that slides alone takes but half
  return test;
}

std::vector<double> places(std::size_t count, double deepest, Random& random) {
  std::vector<double> at;
  for (std::size_t i = 0; i < count; ++i) at.push_back(random.between(0.07, 0.97 * deepest));
  std::sort(at.begin(), at.end());
  return at;
}

// Losses whose shares of the whole are as these weights.
std::vector<Loss> losses(const std::vector<double>& at, const std::vector<double>& weights, double left) {
  double total = 0;
  for (const double weight : weights) total += weight;
  std::vector<Loss> all;
  for (std::size_t i = 0; i < at.size(); ++i) all.push_back({at[i], -std::expm1(std::log(left) * weights[i] / total)});
  return all;
}

std::size_t count_between(Random& random, int least, int most) {
  return static_cast<std::size_t>(random.between(least, most + 1));
}

SimulatedTest slips_with_cracks(Random& random) {
  SimulatedTest test = random.uniform() < 0.5 ? rough_3_2(random) : wave(random);
  const auto at = places(count_between(random, 2, 10), test.deepest, random);
  for (const double w : at) test.losses.push_back({w, random.between(0.01, 0.07)});
  return test;
}

SimulatedTest slips_that_crack(Random& random) {
  SimulatedTest test = random.uniform() < 0.5 ? rough_3_2(random) : wave(random);
  test.loss_of_slip = random.between(0.005, 0.05);
  return test;
}

// Friction that is constant or varies slowly: too slowly for slips.
SimulatedTest cracking(Random& random) {
  SimulatedTest test = sliding(random);
  if (random.uniform() < 0.4) return test;
  const double length = log_between(random, 20, 80);
  test.friction.bumps = random.uniform() < 0.7 ? smooth_bumps(random.between(0.02, 0.08), length, random)
                                               : running_in(random.between(0.05, 0.3), length);
  test.friction.spacing = 0.25;
  return test;
}

SimulatedTest cracks_equal(Random& random) {
  SimulatedTest test = cracking(random);
  const auto at = places(count_between(random, 4, 20), test.deepest, random);
  test.losses = losses(at, std::vector<double>(at.size(), 1.0), random.between(0.5, 0.95));
  return test;
}

SimulatedTest cracks_growing(Random& random) {
  SimulatedTest test = cracking(random);
  const auto at = places(count_between(random, 5, 20), test.deepest, random);
  std::vector<double> weights;
  const double growth = random.between(2, 12);
  for (std::size_t i = 0; i < at.size(); ++i)
    weights.push_back(1 + growth * static_cast<double>(i) / static_cast<double>(at.size()));
  test.losses = losses(at, weights, random.between(0.5, 0.95));
  return test;
}

SimulatedTest cracks_scattered(Random& random) {
  SimulatedTest test = cracking(random);
  const auto at = places(count_between(random, 5, 25), test.deepest, random);
  std::vector<double> weights;
  for (std::size_t i = 0; i < at.size(); ++i) weights.push_back(-std::log(random.uniform()));
  test.losses = losses(at, weights, random.between(0.5, 0.95));
  return test;
}

SimulatedTest cracks_few(Random& random) {
  SimulatedTest test = cracking(random);
  for (const double w : places(count_between(random, 3, 5), test.deepest, random))
    test.losses.push_back({w, random.between(0.03, 0.25)});
  return test;
}

SimulatedTest cracks_many(Random& random) {
  SimulatedTest test = cracking(random);
  const auto at = places(count_between(random, 22, 50), test.deepest, random);
  test.losses = losses(at, std::vector<double>(at.size(), 1.0), random.between(0.6, 0.95));
  return test;
}

// Cracks that run on between the drops, so slowly that it makes none.
SimulatedTest cracks_running(Random& random) {
  SimulatedTest test = random.uniform() < 0.5 ? cracks_equal(random) : cracks_scattered(random);
  constexpr std::size_t steps = 200;
  const double lost = random.between(0.03, 0.2);
  for (std::size_t i = 0; i < steps; ++i)
    test.losses.push_back({std::lerp(0.05, test.deepest, static_cast<double>(i) / steps), lost / steps});
  std::sort(test.losses.begin(), test.losses.end(), [](const Loss& a, const Loss& b) { return a.w < b.w; });
  return test;
}

constexpr std::array kinds{TestKind{"wave", wave},
                           TestKind{"two_waves", two_waves},
                           TestKind{"rough_1_2", rough_1_2},
                           TestKind{"rough_3_2", rough_3_2},
                           TestKind{"rough_smooth", rough_smooth},
                           TestKind{"rough_wave", rough_wave},
                           TestKind{"rough_slow", rough_slow},
                           TestKind{"rough_running_in", rough_running_in},
                           TestKind{"rough_skewed", rough_skewed},
                           TestKind{"two_supports", two_supports},
                           TestKind{"constant", sliding},
                           TestKind{"slips_with_cracks", slips_with_cracks},
                           TestKind{"slips_that_crack", slips_that_crack},
                           TestKind{"cracks_equal", cracks_equal},
                           TestKind{"cracks_growing", cracks_growing},
                           TestKind{"cracks_scattered", cracks_scattered},
                           TestKind{"cracks_few", cracks_few},
                           TestKind{"cracks_many", cracks_many},
                           TestKind{"cracks_running", cracks_running}};

struct RecordedTest {
  FitProblem problem;
  double left = 1;                     // [1] of the bending stiffness
  double by_slips = 0, by_cracks = 0;  // [EI/L^2] how far the force fell in all
};

// The loading that a laboratory records, with what it does not know: bending stiffness to 5 %, load train to 1 %, contact to .0005 L or, like most
// published tests, to .004 L, what the force is off by slowly to 0.5 %, noise.
RecordedTest recorded(const SimulatedTest& test, Random& random) {
  static const SlidingLadder on_edges(1.58, 2e-4);
  const Fibre fibre(Supports{test.radius, 0});
  const SlidingLadder ladder = test.radius > 0 ? SlidingLadder(1.58, 2e-4, fibre) : on_edges;
  std::vector<double> mu;
  for (const double S : ladder.lengths()) mu.push_back(test.friction.mu(S));
  const auto curve = ladder.curve(mu);
  const double k = log_between(random, 12, 300), stiffening = std::exp(0.05 * random.normal());
  const double own_k = k * std::exp(0.01 * random.normal()) / stiffening;
  const double contact = (random.uniform() < 0.5 ? 0.0005 : 0.004) * random.normal();
  const double drift = 0.005 * std::sqrt(2) * random.normal(), drift_begins = random.between(0, 2 * pi);
  const double drift_turns = random.between(3, 12) / test.deepest;
  const double rows = log_between(random, 60, 2000), step = (test.deepest + 9 * stiffening / k) / rows;
  const double noise = log_between(random, 0.003, 0.03);
  const double correlation = random.uniform() < 0.5 ? 0 : random.between(0.3, 0.95);
  RecordedTest out{.problem = {.record = {}, .rig = {k, fibre}, .errors = {}}};
  ReducedRecord& record = out.problem.record;
  double& left = out.left;
  double e = random.normal();
  std::size_t next = 0, i = 1;
  for (double stage = step;; stage += step) {
    const auto G = [&](std::size_t j) { return curve.w[j] + left * curve.F[j] / own_k; };
    double part = 0, w = 0;
    for (bool settled = false; !settled;) {
      double highest = 0;  // where it snaps from
      for (; i < curve.w.size() && G(i) < stage; ++i)
        if (G(i) < G(i - 1)) highest = std::max(highest, curve.F[i - 1]);
      if (i == curve.w.size()) return out;
      const double fall = left * std::max(highest - curve.F[i], 0.0);
      out.by_slips += fall;
      constexpr double seen = 4;  // [1] of the noise
      if (fall > seen * noise) left *= 1 - test.loss_of_slip;
      part = std::clamp((stage - G(i - 1)) / (G(i) - G(i - 1)), 0.0, 1.0);
      w = std::lerp(curve.w[i - 1], curve.w[i], part);
      settled = next == test.losses.size() || w < test.losses[next].w;
      if (settled) continue;
      const double lost = left * test.losses[next++].share;
      out.by_cracks += lost * std::lerp(curve.F[i - 1], curve.F[i], part);
      left -= lost;
    }
    if (w > test.deepest) return out;
    const double force = left * std::lerp(curve.F[i - 1], curve.F[i], part) * stiffening *
                             (1 + drift * std::sin(drift_begins + drift_turns * stage)) +
                         noise * e;
    e = correlation * e + std::sqrt(1 - correlation * correlation) * random.normal();
    if (stage < contact) continue;
    record.stage.push_back(stage - contact);
    record.force.push_back(force);
    record.deflection.push_back(stage - contact - force / k);
  }
}

void print_title() {
  std::puts(
      "kind,cracks_alone,test,load_train,rows,deepest,drops,rises,given_back,friction_needed,margin,loss_margin,left,"
      "needed,"
      "probability");
}

// Of a test that is judged. left: of the bending stiffness, in truth.
void print(const std::string& kind, bool cracks_alone, int test, const FitProblem& problem, double left) {
  const ReducedRecord& record = problem.record;
  const Record physical = to_physical(record, Scales(1, 1));
  if (check_record(physical).fault != RecordFault::none) return;
  const Drops drops = find_drops(physical);
  if (drops.status != DropStatus::ok) return;
  const SlipOrCrack found = slip_or_crack(record, problem.rig, drops.drops);
  if (!found.judged || std::isnan(found.cracks_alone)) return;
  std::printf("%s,%d,%d,%.1f,%zu,%.3f,%zu,%zu,%.4f,%.4f,%.2f,%.2f,%.4f,%.4f,%.4f\n", kind.c_str(), cracks_alone ? 1 : 0,
              test, problem.rig.stiffness, record.force.size(), record.deflection.back(), drops.drops.size(),
              found.features.rises, found.features.given_back, found.features.friction_needed, found.features.margin,
              found.features.loss_margin, left,
              1 - std::max({found.cracks.left, found.cracks_constant.left, found.cracks_running.left}),
              found.cracks_alone);
}

// But for slips that hardly matter.
bool cracks_alone(const RecordedTest& test) {
  constexpr double hardly = 0.1;
  return test.by_slips < hardly * test.by_cracks;
}

int simulate(const std::string& kind, int first, int tests, bool on_rollers) {
  const auto of_kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const TestKind& each) { return each.name == kind; });
  if (of_kind == kinds.end()) {
    std::fprintf(stderr, "%s is no kind of test\n", kind.c_str());
    return 2;
  }
  print_title();
  for (int test = first; test < first + tests; ++test) {
    Random random = random_of(kind, test);
    SimulatedTest simulated = of_kind->make(random);
    if (on_rollers) simulated.radius = log_between(random, 0.01, 0.12);
    const RecordedTest recorded_test = recorded(simulated, random);
    print(kind, cracks_alone(recorded_test), test, recorded_test.problem, recorded_test.left);
  }
  return 0;
}

int read_records() {
  print_title();
  std::string name;
  int cause = 0;
  double k = 0, thickness = 0;
  std::size_t rows = 0;
  for (int test = 0; std::cin >> name >> cause >> k >> thickness >> rows; ++test) {
    FitProblem problem{.record = {}, .rig = {k, Fibre(Supports{0, 0.5 * thickness})}, .errors = {}};
    double stage = 0, force = 0;
    for (std::size_t i = 0; i < rows && std::cin >> stage >> force; ++i) {
      problem.record.stage.push_back(stage);
      problem.record.force.push_back(force);
      problem.record.deflection.push_back(stage - force / k);
    }
    print(name, cause == 1, test, problem, NAN);
  }
  return 0;
}

int run(int count, char** arguments) {
  const bool on_rollers = count == 5 && std::string(arguments[4]) == "rollers";
  if (count == 4 || on_rollers)
    return simulate(arguments[1], std::atoi(arguments[2]), std::atoi(arguments[3]), on_rollers);
  if (count == 2 && std::string(arguments[1]) == "-") return read_records();
  for (const TestKind& kind : kinds) std::puts(kind.name);
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
