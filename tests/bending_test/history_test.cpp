#include "bending_test/history.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/bending_test/some_programme.h"
#include "tests/fig_8.h"
#include "tests/generators.h"
#include "tests/refusal.h"
#include "tests/unit.h"

namespace flexslip {
namespace {

// Loaded from the straight fibre, the whole curve.
History load_continuously(const Friction& friction, const Rig& rig, double stage, int n) {
  return follow_continuously({friction, rig}, std::vector{stage}, n);
}

// The paper's Algorithm 2 taken literally: at each stage position all roots of R(S) = k (w_s - w) - F on the equilibrium curve,
// with R' < 0, the nearest to the last S. Roots are found on a fixed dense grid, then by bisection.
class LiteralAlgorithm2 {
 public:
  LiteralAlgorithm2(Friction friction, double k, double S_max, double step) : friction_(std::move(friction)), k_(k) {
    for (double S = 1; S < S_max; S += step) {
      const auto state = state_at(S);
      if (state.status != FibreStatus::ok) break;
      grid_.push_back({S, state.w, state.F});
    }
  }

  // The next measured S, or NaN if there is none.
  double advance(double stage) {
    double nearest = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i + 1 < grid_.size(); ++i) {
      const bool falls = R(grid_[i], stage) >= 0 && R(grid_[i + 1], stage) < 0;  // R' < 0: stable (4.31)
      if (!falls) continue;
      const double root = bisect(grid_[i].S, grid_[i + 1].S, stage);
      if (!(std::abs(root - last_) >= std::abs(nearest - last_))) nearest = root;
    }
    last_ = nearest;
    return nearest;
  }

 private:
  struct Point {
    double S, w, F;
  };
  FibreState state_at(double S) const { return fibre_state(S, friction_.at(S).mu); }
  double R(const Point& point, double stage) const { return k_ * (stage - point.w) - point.F; }  // (4.29)
  double bisect(double low, double high, double stage) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const auto state = state_at(middle);
      (R({middle, state.w, state.F}, stage) >= 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  Friction friction_;
  double k_;
  double last_ = 1;
  std::vector<Point> grid_;
};

// Some loading test with a sinusoidal friction.
struct SomeTest {
  Friction friction;
  Rig rig;
  double stage;
};
SomeTest some_test() {
  return {Friction::sinusoid(*between(0.1, 1.0), *between(0, 0.6), *between(0.01, 0.1), *between(0, 6.3)),
          {*between(10, 500)},
          *between(0.05, 0.8)};
}

double sum_of(const EnergyAccount& energy) {
  return energy.bending + energy.load_train + energy.friction + energy.snaps;
}

}  // namespace

TEST_CASE("history: the measured curve equals a literal Algorithm 2, in 240 random tests (oracle)") {
  std::mt19937_64 random(20210829);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  int cases = 0, points = 0, snaps = 0;
  for (int i = 0; i < 240; ++i) {
    const double mu0 = draw(0.1, 1), A = draw(0, 0.6), wavelength = draw(0.004, 0.1), k = draw(10, 500);
    const auto friction = Friction::sinusoid(mu0, A, wavelength, draw(0, 2 * std::numbers::pi));
    std::vector<double> stages;
    const double last = draw(0.1, 0.7);
    for (double stage = draw(0.001, 0.05); stage < last; stage += draw(0.0005, 0.04)) stages.push_back(stage);
    if (stages.empty()) stages.push_back(last);
    const auto history = follow_in_steps({friction, {k}}, stages);
    REQUIRE(history.status == HistoryStatus::ok);
    REQUIRE(history.path.size() == stages.size());
    LiteralAlgorithm2 literal(friction, k, longest_at_stage(stages.back()) + 0.01, 2 * wavelength / 80);
    CAPTURE(mu0);
    CAPTURE(A);
    CAPTURE(wavelength);
    CAPTURE(k);
    bool agrees = true;
    for (std::size_t j = 0; j < stages.size(); ++j) {
      const double S = literal.advance(stages[j]);
      // Both are roots of one function; where it is flat, near a fold, to the square root of its rounding.
      agrees = agrees && std::abs(history.path[j].S - S) <= 1e-7;
      if (std::abs(history.path[j].S - S) > 1e-7)
        FAIL_CHECK("stage ", stages[j], ": S ", history.path[j].S, " for ", S);
      ++points;
    }
    cases += agrees;
    snaps += static_cast<int>(history.snaps.size());
  }
  MESSAGE("agreed on ", cases, " tests, ", points, " points, ", snaps, " snaps");
  CHECK(cases == 240);
  CHECK(snaps > 100);  // there was something to agree on
}

TEST_CASE("history: the snaps of Fig. 8C happen at the folds (paper, table)") {
  const auto history = load_continuously(friction_of_fig_8(), rig_of_fig_8, 0.76, 100);
  REQUIRE(history.status == HistoryStatus::ok);
  REQUIRE(history.snaps.size() == 3);
  const std::vector<double> stages{0.588456485703231438, 0.698273165117728631, 0.754599304604295718};  // folds.csv
  const std::vector<double> lengths{1.14851742339589358915, 1.26251965972998261868, 1.38547268418569057835};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(history.snaps[i].stage == to(1e-14, stages[i]));
    CHECK(history.snaps[i].before.S == to(1e-12, lengths[i]));
  }
}

TEST_CASE("history: a snap is a line of slope -k in (w, F), and lands at the same G (identity)") {
  CHECK(rc::check("random tests", [] {
    const auto [friction, rig, stage] = some_test();
    const auto history = load_continuously(friction, rig, stage, 10);
    const double k = rig.stiffness;
    for (const auto& [at, before, after, friction_heat, released] : history.snaps) {
      RC_ASSERT(before.stage == at);
      RC_ASSERT(after.S > before.S && after.w > before.w && after.F < before.F);
      const double slope = (after.F - before.F) / (after.w - before.w);
      RC_ASSERT(std::abs(slope + k) <= 1e-9 * k + 64 * unit * (k + before.F) / (after.w - before.w));
      RC_ASSERT(std::abs(after.w + after.F / k - at) <= 64 * unit);
      RC_ASSERT(before.q == friction.at(before.S).mu);
      RC_ASSERT(after.q == friction.at(after.S).mu);
    }
  }));
}

TEST_CASE("history: the continuous curve and the stepped one are the same (identity)") {
  CHECK(rc::check("random tests", [] {
    const auto [friction, rig, stage] = some_test();
    const auto continuous = load_continuously(friction, rig, stage, 12);
    RC_ASSERT(continuous.status == HistoryStatus::ok);
    RC_ASSERT(continuous.path.front().S == 1 && continuous.path.front().F == 0);
    RC_ASSERT(std::abs(continuous.path.back().stage - stage) <= 64 * unit);
    // At the positions of the points inside the stable parts: at a snap the last bit decides on which side a step falls.
    std::vector<PathPoint> inside;
    for (std::size_t i = 1; i + 1 < continuous.path.size(); ++i)
      if (continuous.path[i].stage > continuous.path[i - 1].stage * (1 + 1e-9) &&
          continuous.path[i].stage < continuous.path[i + 1].stage * (1 - 1e-9))
        inside.push_back(continuous.path[i]);
    std::vector<double> stages;
    for (const auto& point : inside) stages.push_back(point.stage);
    stages.push_back(stage);
    const auto stepped = follow_in_steps({friction, rig}, stages);
    RC_ASSERT(stepped.path.size() == stages.size());
    for (std::size_t i = 0; i < inside.size(); ++i) {
      RC_ASSERT(stepped.path[i].stage == to(1e-14, inside[i].stage));
      RC_ASSERT(std::abs(stepped.path[i].S - inside[i].S) <=
                1e-7);  // where G is flat, to the square root of its rounding
    }
    RC_ASSERT(stepped.snaps.size() == continuous.snaps.size());
    RC_ASSERT(stepped.energy.stage_work == to(1e-10, continuous.energy.stage_work));
    RC_ASSERT(stepped.energy.friction == to(1e-10, continuous.energy.friction));
  }));
}

TEST_CASE("history: along the path the stage advances, the fibre slides in, and the wedge is in balance (identity)") {
  CHECK(rc::check("random tests", [] {
    const auto [friction, rig, stage] = some_test();
    const auto history = load_continuously(friction, rig, stage, 20);
    for (std::size_t i = 0; i < history.path.size(); ++i) {
      const auto& point = history.path[i];
      RC_ASSERT(std::abs(point.w + point.F / rig.stiffness - point.stage) <= 64 * unit);
      RC_ASSERT(point.q == friction.at(point.S).mu);
      if (i == 0) continue;
      RC_ASSERT(point.motion == Motion::slip_in || point.motion == Motion::snap);
      RC_ASSERT(point.stage >= history.path[i - 1].stage - 16 * unit);
      RC_ASSERT(point.S >= history.path[i - 1].S);
    }
    const auto snapped = std::count_if(history.path.begin(), history.path.end(),
                                       [](const PathPoint& point) { return point.motion == Motion::snap; });
    RC_ASSERT(static_cast<std::size_t>(snapped) == history.snaps.size());
  }));
}

TEST_CASE("history: the energy account closes (identity)") {
  CHECK(rc::check("random tests, continuous and stepped", [] {
    const auto [friction, rig, stage] = some_test();
    for (const auto& history : {load_continuously(friction, rig, stage, 5),
                                follow_in_steps({friction, rig}, std::vector{0.3 * stage, 0.31 * stage, stage})}) {
      const auto& energy = history.energy;
      RC_ASSERT(std::abs(energy.imbalance) <= 1e-10 * energy.stage_work);
      RC_ASSERT(std::abs(energy.stage_work - sum_of(energy) - energy.imbalance) <= 8 * unit * energy.stage_work);
      RC_ASSERT(energy.friction >= 0);
      RC_ASSERT(energy.snaps >= 0);  // what a snap sets free, it sets free
      RC_ASSERT((energy.snaps == 0) == history.snaps.empty());
      RC_ASSERT(history.energy_at.size() == history.path.size());
      if (history.status != HistoryStatus::ok) continue;  // the account continues to the point of loss
      const auto& last = history.path.back();
      RC_ASSERT(energy.bending == to(4 * unit, fibre_state(last.S, last.q).U));
      RC_ASSERT(energy.load_train == to(1e-14, 0.5 * last.F * last.F / rig.stiffness));
    }
  }));
}

TEST_CASE("history: rough and tabulated friction close their account too (identity)") {
  CHECK(rc::check("random seeds", [] {
    const double stage = *between(0.1, 0.6), length = *between(0.005, 0.05);
    const auto friction = Friction::rough(*between(0.2, 0.8), *between(0, 0.4), length,
                                          static_cast<std::uint64_t>(*whole(0, 1 << 30)), longest_at_stage(stage));
    const auto energy = load_continuously(friction, {*between(10, 500)}, stage, 5).energy;
    RC_ASSERT(std::abs(energy.imbalance) <= 1e-10 * energy.stage_work);
  }));
}

TEST_CASE("history: the work of the stage is the area under the measured curve (oracle: trapezium rule)") {
  const auto history = load_continuously(friction_of_fig_8(), rig_of_fig_8, 0.76, 4000);
  double work = 0, friction = 0;
  for (std::size_t i = 1; i < history.path.size(); ++i) {
    const auto &a = history.path[i - 1], &b = history.path[i];
    work += 0.5 * (a.F + b.F) * (b.stage - a.stage);
    if (b.motion == Motion::snap) continue;
    friction += 0.5 * (a.q * fibre_state(a.S, a.q).Pn + b.q * fibre_state(b.S, b.q).Pn) * (b.S - a.S);
  }
  CHECK(history.energy.stage_work == to(1e-6, work));  // steps of 1e-4, squared, times the curvature
  CHECK(history.energy.friction > friction);           // the snaps rub as well
}

TEST_CASE("history: friction takes nothing where there is none, snaps nothing where there are none (limit)") {
  const auto smooth = load_continuously(Friction::constant(0), rig_of_fig_8, 0.4, 10);
  CHECK(smooth.energy.friction == 0);
  CHECK(smooth.energy.snaps == 0);
  CHECK(smooth.snaps.empty());
  CHECK(smooth.energy.stage_work == to(1e-12, smooth.energy.bending + smooth.energy.load_train));
  CHECK(load_continuously(Friction::constant(0.6), {100}, 0.4, 10).energy.snaps == 0);
}

TEST_CASE("history: a stiff rig measures the equilibrium curve itself, without snaps (limit)") {
  const std::vector<double> stages{0.05, 0.2, 0.2, 0.45};
  const auto history = follow_in_steps({friction_of_fig_8(), {infinity}}, stages);
  REQUIRE(history.status == HistoryStatus::ok);
  CHECK(history.snaps.empty());
  for (
      std::size_t i = 0; i < stages.size();
      ++i)  // S is rounded, and with S - 1 = 2.4 w^2 so is w, by 2^-52/(4.8 w^2) of itself; twice that for the two ends of a root.
    CHECK(history.path[i].w == to(1e-14 + 0x1p-52 / (2.4 * stages[i] * stages[i]), stages[i]));
  CHECK(history.path[1].S == history.path[2].S);  // a step of nothing
  CHECK(history.energy.load_train == 0);
  CHECK(std::abs(history.energy.imbalance) <= 1e-10 * history.energy.stage_work);
  const auto nearly = follow_in_steps({friction_of_fig_8(), {1e12}}, stages);
  CHECK(nearly.path.back().F == to(1e-9, history.path.back().F));
}

TEST_CASE("history: at first the force is 48 w, behind the cantilever (limit)") {
  const auto history = follow_in_steps({Friction::constant(0.3), {30}}, std::vector{1e-6, 1e-4});
  for (const auto& point : history.path)  // S is also rounded: to half an ulp of 1 + 2.4 w^2
    CHECK(point.F == to(2 * point.stage + 0x1p-53 / (2.4 * point.w * point.w), point.stage / (1.0 / 48 + 1.0 / 30)));
}

TEST_CASE("history: pushed beyond every equilibrium the fibre slips through (limit)") {
  // Without friction and with k = 30, G is largest, some 0.83, near the end of the branch.
  const std::vector<double> stages{0.2, 0.4, 2.0, 3.0};
  const auto history = follow_in_steps({Friction::constant(0), rig_of_fig_8}, stages);
  CHECK(history.status == HistoryStatus::slipped_through);
  CHECK(history.path.size() == 2);
  CHECK(history.path.back().stage == to(1e-14, 0.4));
  const auto continuous = load_continuously(Friction::constant(0), rig_of_fig_8, 2.0, 10);
  CHECK(continuous.status == HistoryStatus::slipped_through);
  CHECK(continuous.path.back().stage < 2);
  CHECK(std::abs(continuous.energy.imbalance) <= 1e-10 * continuous.energy.stage_work);
  for (const auto& point : continuous.path) CHECK(point.F >= 0);
}

TEST_CASE("history: without friction load and unload coincide (limit)") {
  const std::vector<double> stages{0.1, 0.2, 0.3, 0.4, 0.3, 0.2, 0.1, 0.2, 0.1, 0};
  const auto history = follow_in_steps({Friction::constant(0), {50}}, stages);
  REQUIRE(history.status == HistoryStatus::ok);
  for (const auto& [there, back] : {std::pair{0, 6}, {1, 5}, {2, 4}, {1, 7}, {0, 8}}) {
    const auto &a = history.path[static_cast<std::size_t>(there)], &b = history.path[static_cast<std::size_t>(back)];
    CHECK(b.F == to(1e-14, a.F));
    CHECK(b.S - 1 == to(1e-13, a.S - 1));
  }
  CHECK(history.path.back().F == 0);
  CHECK(history.path.back().S == 1);
  CHECK(history.energy.friction == 0);
  CHECK(std::abs(history.energy.stage_work) <= 1e-12 * history.energy_at[3].stage_work);  // all of it comes back
}

TEST_CASE("history: with constant friction a closed cycle returns to its start (identity)") {
  CHECK(rc::check("random cycles", [] {
    const double high = *between(0.1, 0.35), low = *between(0.1, 0.9) * high;
    const std::vector<double> points{high, low, high, low, high};
    const auto history = follow_in_steps({Friction::constant(*between(0.02, 0.6)), {*between(20, 500)}}, points);
    if (history.status == HistoryStatus::contact_lost) return;
    for (const std::size_t i : {2u, 4u}) {
      RC_ASSERT(history.path[i].S - 1 == to(1e-12, history.path[0].S - 1));
      RC_ASSERT(history.path[i].F == to(1e-12, history.path[0].F));
      RC_ASSERT(std::abs(history.path[i].q - history.path[0].q) <= 1e-12);
    }
    RC_ASSERT(history.path[3].F == to(1e-12, history.path[1].F));
  }));
}

TEST_CASE("history: the area of a loop is friction heat and snaps (oracle: trapezium rule on the path)") {
  // Fig. 8's rough fibre: once it has slid in, the loop between two stage positions closes.
  const std::vector<double> cycle{0.62, 0.2, 0.62};
  const auto history = follow_continuously({friction_of_fig_8(), rig_of_fig_8}, cycle, 3000);
  REQUIRE(history.status == HistoryStatus::ok);
  std::size_t turn = 0;
  while (history.path[turn].stage < 0.62) ++turn;
  double area = 0;
  for (std::size_t i = turn + 1; i < history.path.size(); ++i)
    area += 0.5 * (history.path[i].F + history.path[i - 1].F) * (history.path[i].stage - history.path[i - 1].stage);
  CHECK(history.path.back().S == to(1e-9, history.path[turn].S));
  const auto &start = history.energy_at[turn], &end = history.energy;
  CHECK(area == to(1e-5, end.friction + end.snaps - start.friction - start.snaps));  // of the trapezia
  CHECK(end.snaps > start.snaps);
}

TEST_CASE(
    "history: an infinitely stiff rig snaps only where the deflection itself folds (oracle: w sampled along the "
    "curve)") {
  int folding = 0;
  CHECK(rc::check("random roughness", [&] {
    const auto friction = Friction::sinusoid(0.9, *between(0.4, 0.9), *between(0.002, 0.006), *between(0, 6.3));
    const auto history = follow_continuously({friction, {infinity}}, std::vector{0.3, 0.1, 0.3}, 3);
    const auto deflection = [&](double S, double sign) { return fibre_state(S, sign * friction.at(S).mu).w; };
    for (const Snap& snap : history.snaps) {
      const double S = snap.before.S;
      const double sign = snap.after.S > S ? 1 : -1;
      const double farther =
          S + 0.3 * (snap.after.S - S);  // the shortest snaps are of rounding size nearer to the fold
      RC_ASSERT(sign * deflection(farther, sign) < sign * snap.before.w);
    }
    double last = 0;
    bool folds = false;
    for (int i = 1; i <= 20000 && last < 0.3; ++i) {
      const double w = deflection(1 + 0.25 * (i / 20000.0) * (i / 20000.0), 1);
      folds = folds || w < last;
      last = w;
    }
    if (folds) RC_ASSERT(!history.snaps.empty());
    folding += folds;
  }));
  CHECK(folding > 5);
}

TEST_CASE(
    "path: the states equal the history bit for bit, in steps and continuously (identity: 60 random "
    "programmes)") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 60; ++i) {
    const auto [test, points, roughness] = some_programme(random, 0.6, 0.01);
    const auto check = [&](const TestPath& path, const History& history) {
      INFO("programme ", i);
      CHECK(path.status == history.status);
      REQUIRE(path.path.size() == history.path.size());
      for (std::size_t k = 0; k < path.path.size(); ++k) {
        CHECK(path.path[k].w == history.path[k].w);
        CHECK(path.path[k].F == history.path[k].F);
        CHECK(path.path[k].motion == history.path[k].motion);
      }
      REQUIRE(path.snaps.size() == history.snaps.size());
      for (std::size_t k = 0; k < path.snaps.size(); ++k) CHECK(path.snaps[k].released == history.snaps[k].released);
    };
    check(path_in_steps(test, points), follow_in_steps(test, points));
    check(path_continuously(test, points, 4), follow_continuously(test, points, 4));
  }
}

TEST_CASE("history: the energy account closes over any path (identity: 1,000 random programmes)") {
  std::mt19937_64 random(1);
  int snaps = 0, ends = 0;
  for (int i = 0; i < 1000; ++i) {
    auto [test, points, roughness] = some_programme(random, 0.6, 0.01);
    if (i % 5 == 1) test.friction.static_excess = Friction::constant(0.3);
    if (i % 4 == 1) test.rest = SnapRest::overshoot;
    const auto history = i % 2 ? follow_in_steps(test, points) : follow_continuously(test, points, 4);
    snaps += static_cast<int>(history.snaps.size());
    ends += history.status != HistoryStatus::ok;
    double greatest = 0, last_friction = 0, last_snaps = 0;
    bool falls = false;
    for (const auto& account : history.energy_at) {
      greatest = std::max(greatest, std::abs(account.stage_work));
      falls = falls || account.friction < last_friction || account.snaps < last_snaps;
      last_friction = account.friction;
      last_snaps = account.snaps;
    }
    INFO("programme ", i);
    for (const auto& account : history.energy_at) CHECK(std::abs(account.imbalance) <= 1e-10 * greatest);
    CHECK(std::abs(history.energy.imbalance) <= 1e-10 * std::max(greatest, history.energy.stage_work));
    CHECK(!falls);  // what is lost is lost
  }
  MESSAGE(snaps, " snaps; ", ends, " programmes ended early");
  CHECK(snaps > 1000);
}

TEST_CASE("history: work of fracture is the area under force and deflection (oracle: trapezium rule)") {
  const auto history = follow_continuously({friction_of_fig_8(), rig_of_fig_8}, std::vector{0.76}, 4000);
  double area = 0;
  for (std::size_t i = 1; i < history.path.size(); ++i)
    area += 0.5 * (history.path[i].F + history.path[i - 1].F) * (history.path[i].w - history.path[i - 1].w);
  CHECK(work_of_fracture(history.energy) == to(1e-6, area));
}

TEST_CASE("history: an invalid programme is refused with the index that is wrong (contract)") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [](const std::vector<double>& stages) {
    return message_of([&] { follow_in_steps({Friction::constant(0.3), {30}}, stages); });
  };
  const auto names = [&](const std::vector<double>& stages, const std::string& index, const std::string& value) {
    const auto message = refusal(stages);
    INFO("message: ", message);
    CHECK(message.find("position " + index) != std::string::npos);
    CHECK(message.find(value) != std::string::npos);
  };
  names({-0.1, 0.2}, "0", "-0.1");
  names({0.1, 0.2, -0.15}, "2", "-0.15");
  names({0.1, nan}, "1", "nan");
  names({0.1, infinity}, "1", "inf");
  CHECK(refusal({}).find("above 0") != std::string::npos);
  CHECK(refusal({0.0, 0.0}).find("above 0") != std::string::npos);
  const auto continuous = [](double stage, int n) {
    return message_of([&] { load_continuously(Friction::constant(0.3), {30}, stage, n); });
  };
  CHECK(continuous(0, 10).find("above 0") != std::string::npos);
  CHECK(continuous(-1, 10).find("-1") != std::string::npos);
  CHECK(continuous(nan, 10).find("nan") != std::string::npos);
  CHECK(continuous(0.3, 1).find("1") != std::string::npos);
}

}  // namespace flexslip
