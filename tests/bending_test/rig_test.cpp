#include "bending_test/rig.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/snap.h"
#include "fibre/elastica.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/fig_8.h"
#include "tests/generators.h"
#include "tests/refusal.h"
#include "tests/unit.h"

namespace flexslip {
namespace {

constexpr double first_fold_of_second_tooth = 0.698273165117728631;  // folds.csv

struct FoldRow {
  bool is_maximum;
  double S, stage, w, F;
};
std::vector<FoldRow> fold_rows() {
  std::ifstream file(FLEXSLIP_SOURCE_DIR "/tests/fibre/reference/folds.csv");
  std::vector<FoldRow> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("fold ", 0) != 0) continue;
    std::stringstream cells(line);
    std::string what, q, S, stage, w, F;
    for (auto* cell : {&what, &q, &S, &stage, &w, &F}) std::getline(cells, *cell, ',');
    rows.push_back({what == "fold max", std::stod(S), std::stod(stage), std::stod(w), std::stod(F)});
  }
  return rows;
}

std::vector<Stability> stabilities(const std::vector<OverallEquilibrium>& found) {
  std::vector<Stability> all;
  for (const auto& equilibrium : found) all.push_back(equilibrium.stability);
  return all;
}

double stage_at(const Friction& friction, const Rig& rig, double S) {
  const auto state = fibre_state(S, friction.at(S).mu);
  return state.w + state.F / rig.stiffness;
}

// What 16 ulp of S do to G: the accuracy promised of an equilibrium.
double rounding_of_stage(const RigPoint& point) {
  return 16 * unit * (std::abs(point.stage_slope) * point.S + point.stage);
}

// The oracle: G sampled so finely that folds show as changes of sign of its differences.
struct Extremum {
  double S;  // to within one step
  bool is_maximum;
};
std::vector<Extremum> sampled_extrema(const Friction& friction, const Rig& rig, double S_max, double step) {
  std::vector<Extremum> found;
  const int n = static_cast<int>(std::ceil((S_max - 1) / step));
  double before = 0, last = 0;
  for (int i = 0; i <= n; ++i) {
    const double S = std::min(1 + step * i, S_max);
    const double stage = stage_at(friction, rig, S);
    if (i > 1 && (stage > last) != (last > before)) found.push_back({1 + step * (i - 1), last > before});
    before = last;
    last = stage;
  }
  return found;
}

// No extremum of the oracle is missed; folds beyond those come in pairs too close for the oracle's step, or lie in its last
// one; and G is monotone between folds. Returns how many folds there are.
std::size_t folds_are_those_sampled(const Friction& friction, const Rig& rig, double S_max, double step) {
  const auto curve = trace_loading_curve(friction, rig, S_max);
  const auto sampled = sampled_extrema(friction, rig, curve.end.S, step);
  std::size_t next = 0;
  for (const auto& extremum : sampled) {
    while (next < curve.folds.size() && (curve.folds[next].point.S < extremum.S - 1.01 * step ||
                                         curve.folds[next].is_maximum != extremum.is_maximum))
      ++next;
    if (next == curve.folds.size() || curve.folds[next].point.S > extremum.S + 1.01 * step)
      RC_FAIL("a fold is missed near S = " + std::to_string(extremum.S));
    ++next;
  }
  RC_ASSERT(curve.folds.size() >= sampled.size());
  const bool one_at_end = !curve.folds.empty() && curve.folds.back().point.S > curve.end.S - step;
  RC_ASSERT((curve.folds.size() - sampled.size()) % 2 == 0u || one_at_end);
  double S = 1, stage = 0;
  bool rising = true;
  for (std::size_t i = 0; i <= curve.folds.size(); ++i) {
    const auto& to = i < curve.folds.size() ? curve.folds[i].point : curve.end;
    if (i < curve.folds.size()) RC_ASSERT(curve.folds[i].is_maximum == rising);
    RC_ASSERT(to.S > S);
    for (int j = 1; j <= 40; ++j) {
      const double next_stage = j == 40 ? to.stage : stage_at(friction, rig, S + (to.S - S) * j / 40);
      RC_ASSERT((next_stage - stage) * (rising ? 1 : -1) >= -16 * unit);
      stage = next_stage;
    }
    S = to.S;
    rising = !rising;
  }
  return curve.folds.size();
}

Rig any_rig() { return {std::pow(10, *between(0.7, 3))}; }

// How far to trace for some periods of a wave, for the oracle's sake.
double after_periods(double wavelength, double most) { return 1 + std::min(0.6, 2 * wavelength * *between(1, most)); }

}  // namespace

TEST_CASE("rig: the folds of Fig. 8B (table)") {
  const auto rows = fold_rows();
  REQUIRE(rows.size() == 6);
  const auto curve = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, 1.5);
  REQUIRE(curve.folds.size() >= rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [point, is_maximum] = curve.folds[i];
    CHECK(is_maximum == rows[i].is_maximum);
    CHECK(point.S == to(1e-12, rows[i].S));
    CHECK(point.stage == to(1e-14, rows[i].stage));
    CHECK(point.w == to(1e-12, rows[i].w));
    CHECK(point.F == to(1e-12, rows[i].F));
  }
}

TEST_CASE("rig: the folds of Fig. 8B to six digits (paper)") {
  const std::vector<std::pair<double, double>> published{{1.14852, 0.588456}, {1.18579, 0.569262}, {1.26252, 0.698273},
                                                         {1.31637, 0.636468}, {1.38547, 0.754599}, {1.44293, 0.677394}};
  const auto curve = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, 1.5);
  for (std::size_t i = 0; i < published.size(); ++i) {
    CHECK(std::abs(curve.folds[i].point.S - published[i].first) <= 0.5e-5);
    CHECK(std::abs(curve.folds[i].point.stage - published[i].second) <= 0.5e-6);
  }
}

TEST_CASE(
    "rig: one, three and five overall equilibria at w_s = 0.52, 0.65, 0.69, in turn stable and unstable (paper, Fig. "
    "8B)") {
  const auto curve = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, longest_at_stage(0.7));
  using enum Stability;
  CHECK(stabilities(overall_equilibria(curve, 0.52)) == std::vector{stable});
  CHECK(stabilities(overall_equilibria(curve, 0.65)) == std::vector{stable, unstable, stable});
  CHECK(stabilities(overall_equilibria(curve, 0.69)) == std::vector{stable, unstable, stable, unstable, stable});
}

TEST_CASE("rig: at the fold the equilibrium is partially stable (paper, Fig. 8B)") {
  const auto curve = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, longest_at_stage(0.7));
  using enum Stability;
  const auto found = overall_equilibria(curve, first_fold_of_second_tooth);
  CHECK(stabilities(found) == std::vector{partially_stable, stable, unstable, stable});  // four, as the paper counts
  REQUIRE(!found.empty());
  CHECK(found.front().point.S == to(1e-12, 1.26251965972998261868));
  CHECK(stabilities(overall_equilibria(curve, first_fold_of_second_tooth * (1 + 1e-8))) ==
        std::vector{stable, unstable, stable});
}

TEST_CASE("rig: every overall equilibrium balances wedge and cantilever, and none is missed (oracle: dense sampling)") {
  CHECK(rc::check("random rigs and stage positions", [] {
    const double wavelength = *between(0.01, 0.2);
    const auto friction = Friction::sinusoid(*between(0.1, 0.9), *between(0, 0.6), wavelength, *between(0, 6));
    const Rig rig = any_rig();
    const double stage = *between(0.05, 0.7);
    const auto curve = trace_loading_curve(friction, rig, longest_at_stage(stage));
    const auto found = overall_equilibria(curve, stage);
    for (const auto& [point, stability] : found) {
      RC_ASSERT(std::abs(rig.stiffness * (stage - point.w) - point.F) <= rig.stiffness * rounding_of_stage(point));
      RC_ASSERT((stability == Stability::stable) == (point.stage_slope > 0));
      RC_ASSERT(point.q == friction.at(point.S).mu);
    }
    // Roots as changes of sign; a pair within one step is not seen, hence <=.
    const int n = 20 + static_cast<int>(100 * (curve.end.S - 1) / wavelength);
    std::size_t roots = 0;
    bool below = true;
    for (int i = 1; i <= n; ++i) {
      const bool now = stage_at(friction, rig, 1 + (curve.end.S - 1) * i / n) < stage;
      roots += now != below;
      below = now;
    }
    RC_ASSERT(roots <= found.size());
    RC_ASSERT((found.size() - roots) % 2 == 0u);
    RC_ASSERT(found.size() <= roots + 2);
  }));
}

TEST_CASE("rig: no fold of a sinusoid is missed (oracle: 200 samples a period)") {
  std::size_t folds = 0;
  CHECK(rc::check("wavelengths from 0.001 to 0.5", [&] {
    const double wavelength = std::pow(10, *between(-3, std::log10(0.5)));
    const auto friction = Friction::sinusoid(*between(0.05, 1.2), *between(0, 1), wavelength, *between(0, 6.3));
    folds += folds_are_those_sampled(friction, any_rig(), after_periods(wavelength, 12), 2 * wavelength / 200);
  }));
  CHECK(folds > 100);  // there was something to miss
}

TEST_CASE("rig: no fold of incommensurate sinusoids is missed (oracle: 200 samples a period)") {
  std::size_t folds = 0;
  CHECK(rc::check("three sinusoids and a drift", [&] {
    const double wavelength = std::pow(10, *between(-2.5, -1));
    const double golden = std::numbers::phi;
    const auto friction =
        Friction::waves({.mu0 = *between(0.2, 0.9),
                         .drift = *between(-6, 2),  // to zero and beyond
                         .terms = {{*between(0, 0.3), wavelength, *between(0, 6.3)},
                                   {*between(0, 0.3), wavelength * golden, *between(0, 6.3)},
                                   {*between(0, 0.3), wavelength * golden * std::numbers::sqrt3, *between(0, 6.3)}}});
    folds += folds_are_those_sampled(friction, any_rig(), after_periods(wavelength, 12), 2 * wavelength / 200);
  }));
  CHECK(folds > 100);  // there was something to miss
}

TEST_CASE("rig: no fold of a table is missed (oracle: 200 samples a knot)") {
  std::size_t folds = 0;
  CHECK(rc::check("random tables", [&] {
    FrictionTable table;
    double S = 1;
    const double spacing = std::pow(10, *between(-3, -1.3));
    for (int i = 0; i < 15; ++i) {
      table.S.push_back(S);
      table.mu.push_back(*between(0, 1));
      S += spacing * *between(0.5, 1.5);
    }
    folds += folds_are_those_sampled(Friction::table(table), any_rig(), S + spacing, spacing / 100);
  }));
  CHECK(folds > 100);  // there was something to miss
}

TEST_CASE("rig: no fold of a rough profile is missed (oracle: 200 samples a correlation length)") {
  std::size_t folds = 0;
  CHECK(rc::check("random seeds", [&] {
    const double length = std::pow(10, *between(-2.5, -1.7));
    const double S_max = 1 + *between(0.05, 0.4);
    const auto friction = Friction::rough(*between(0.2, 0.8), *between(0.1, 0.5), length,
                                          static_cast<std::uint64_t>(*whole(0, 1 << 30)), S_max);
    folds += folds_are_those_sampled(friction, any_rig(), S_max, 2 * length / 200);
  }));
  CHECK(folds > 100);  // there was something to miss
}

TEST_CASE("rig: the two folds of a tooth appear where G' first touches zero (oracle: minimisation of G')") {
  const double wavelength = 0.02 * std::numbers::pi;
  const auto friction_with = [&](double amplitude) { return Friction::sinusoid(0.6, amplitude, wavelength, 0); };
  // The least G' on the first tooth, by golden section.
  const auto least_slope = [&](double amplitude) {
    const auto curve = trace_loading_curve(friction_with(amplitude), rig_of_fig_8, 1.2);
    const auto slope = [&](double S) { return point_at_length(curve, S).stage_slope; };
    double low = 1.14, high = 1.2;
    while (high - low > 1e-9) {
      const double third = (high - low) * (2 - std::numbers::phi);
      (slope(low + third) < slope(high - third) ? high : low) =
          slope(low + third) < slope(high - third) ? high - third : low + third;
    }
    return slope(low);
  };
  double without = 0.001, with = 0.4;
  REQUIRE(least_slope(without) > 0);
  REQUIRE(least_slope(with) < 0);
  while (with - without > 1e-12) {
    const double middle = 0.5 * (without + with);
    (least_slope(middle) > 0 ? without : with) = middle;
  }
  const auto folds = [&](double amplitude) {
    const auto all = trace_loading_curve(friction_with(amplitude), rig_of_fig_8, 1.2).folds;
    return all.size();
  };
  for (const double off :
       {1e-3, 1e-6, 1e-8, 1e-10}) {  // the folds are √off of the period apart, 1e-5 of it at the last
    CAPTURE(off);
    CHECK(folds(without * (1 - off)) == 0);
    CHECK(folds(with * (1 + off)) == 2);
  }
}

TEST_CASE("rig: with infinite stiffness the stage position is the deflection (limit)") {
  const auto curve = trace_loading_curve(friction_of_fig_8(), {infinity}, 1.6);
  CHECK(curve.folds.empty());  // the deflection depends almost on S alone
  for (const double S : {1.0, 1.1, 1.5}) CHECK(point_at_length(curve, S).stage == point_at_length(curve, S).w);
  const auto found = overall_equilibria(curve, 0.4);
  REQUIRE(found.size() == 1);
  CHECK(found.front().point.w == to(16 * unit, 0.4));
}

TEST_CASE("rig: constant friction has the folds of F alone, where k is soft (limit)") {
  // G' = w_S + F_S/k: with k -> 0 the maximum of G is that of F.
  const auto curve = trace_loading_curve(Friction::constant(0.6), {1e-9}, 1.5);
  REQUIRE(curve.folds.size() == 1);
  CHECK(curve.folds.front().point.F == to(1e-12, 9.50343010672679644488645323038));
  CHECK(curve.folds.front().point.S == to(1e-8, 1.19753085077872304850086107331));  // moved by k w_S/F_SS
  CHECK(trace_loading_curve(Friction::constant(0.6), {1000}, 1.5).folds.empty());
}

TEST_CASE("rig: a fibre longer than longest_at_stage is at a later stage position (identity)") {
  CHECK(rc::check("q in [0, 20]", [] {
    const double stage = std::pow(10, *between(-5, 1));
    const double S = longest_at_stage(stage) * (1 + std::pow(10, *between(-12, 0)));
    const auto state = fibre_state(S, *between(0, 20));
    RC_PRE(state.status == FibreStatus::ok);
    RC_ASSERT(state.w > stage * (1 - 4 * unit / std::min(stage * stage, 1.0)));  // S - 1 is known to the rounding of S
  }));
  CHECK(longest_at_stage(0.5) == to(4 * unit, 1.6));
}

TEST_CASE("rig: slope and stage of a point are those of the curve (oracle: differences)") {
  CHECK(rc::check("random points of Fig. 8B", [] {
    const auto friction = friction_of_fig_8();
    static const auto curve = trace_loading_curve(friction, rig_of_fig_8, 1.5);
    const double S = *between(1.01, 1.49), h = 1e-6;
    const auto point = point_at_length(curve, S);
    RC_ASSERT(std::abs(point.stage - stage_at(friction, rig_of_fig_8, S)) <= 4 * unit);
    const double difference =
        (stage_at(friction, rig_of_fig_8, S + h) - stage_at(friction, rig_of_fig_8, S - h)) / (2 * h);
    RC_ASSERT(std::abs(point.stage_slope - difference) <= 1e-5);  // G''' h^2/6, G''' of 1e6 with λ
  }));
}

TEST_CASE("rig: stable parts rise, and each takes over where the one before ended (identity)") {
  CHECK(rc::check("random rigs", [] {
    const auto friction = Friction::sinusoid(*between(0.1, 0.9), *between(0, 0.8), *between(0.01, 0.1), *between(0, 6));
    const auto curve = trace_loading_curve(friction, any_rig(), 1.6);
    const auto parts = stable_parts(curve);
    RC_ASSERT(!parts.empty() && parts.front().from.S == 1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto& [from, last] = parts[i];
      RC_ASSERT(from.S < last.S && from.stage < last.stage);
      if (i > 0) {
        RC_ASSERT(std::abs(from.stage - parts[i - 1].to.stage) <= rounding_of_stage(from));
        RC_ASSERT(from.S > parts[i - 1].to.S);
      }
      const double stage = from.stage + (last.stage - from.stage) * *between(0, 1);
      const auto point = point_at_stage(curve, parts[i], stage);
      RC_ASSERT(std::abs(point.stage - stage) <= rounding_of_stage(point));
      RC_ASSERT(point.S >= from.S && point.S <= last.S);
      // The first S with G >= stage: no stable part before reaches it, and no equilibrium lies before it.
      for (const auto& equilibrium : overall_equilibria(curve, stage))
        RC_ASSERT(equilibrium.point.S >= point.S * (1 - 1e-7));
    }
  }));
}

TEST_CASE("rig: a curve says why it ended (limit)") {
  const auto whole = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, 1.5);
  CHECK(whole.end_reason == CurveEnd::reached);
  CHECK(whole.end.S == to(2 * unit, 1.5));
  const auto branch = trace_loading_curve(Friction::constant(0), rig_of_fig_8, 5);
  CHECK(branch.end_reason == CurveEnd::branch_ended);
  CHECK(branch.end.S == to(16 * unit, 2.18843961522647663884));
  CHECK(branch.end.F <= 1e-13);
}

TEST_CASE("rig: what cannot be traced is refused with its value (contract)") {
  const auto friction = friction_of_fig_8();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto traced = [](const Friction& of, double stiffness, double S_max) {
    return message_of([&] { trace_loading_curve(of, {stiffness}, S_max); });
  };
  CHECK(traced(friction, 0, 1.5).find("0.0") != std::string::npos);
  CHECK(traced(friction, -30, 1.5).find("-30") != std::string::npos);
  CHECK(traced(friction, nan, 1.5).find("nan") != std::string::npos);
  CHECK(traced(friction, 30, 1.0).find("1.0") != std::string::npos);
  CHECK(traced(friction, 30, infinity).find("inf") != std::string::npos);
  CHECK(traced(Friction::sinusoid(0.5, 0.1, 1e-8, 0), 30, 1.5).find("periods") != std::string::npos);
  CHECK(message_of([] { longest_at_stage(0); }).find("0.0") != std::string::npos);
  CHECK(message_of([] { longest_at_stage(-1); }).find("-1") != std::string::npos);
  const auto curve = trace_loading_curve(friction, {30}, 1.2);
  CHECK(message_of([&] { point_at_length(curve, 1.3); }).find("1.3") != std::string::npos);
  CHECK(message_of([&] { point_at_length(curve, 0.9); }).find("0.9") != std::string::npos);
  CHECK(message_of([&] { point_at_stage(curve, stable_parts(curve).front(), 3.5); }).find("3.5") != std::string::npos);
}

TEST_CASE("rig: the work of finding folds is bounded by the knots of a table, whatever it says (property)") {
  CHECK(rc::check([] {
    const Fibre fibre = *rc::gen::element(Fibre(), Fibre(Supports{0, 0.0136}), Fibre(Supports{0.02, 0.0136}));
    const Rig rig{std::pow(10, *between(0.5, 4)), fibre};
    FrictionTable table;
    const int pieces = *rc::gen::inRange(1, 12);
    double S = *between(1.01, 1.1);
    for (int piece = 0; piece < pieces; ++piece) {
      // Several readings of one stage position lie on its load line, along which G is level.
      const bool level = *rc::gen::arbitrary<bool>();
      const double mu = *between(0, 2);
      const FibreState there = fibre.state(S, mu);
      for (int i = 0; i < 6; ++i) {
        table.S.push_back(S);
        const HeldState held = held_at(S, there.w + there.F / rig.stiffness, rig, mu);
        table.mu.push_back(level && held.holding == Holding::held ? std::clamp(held.state.q, 0.0, 2.0)
                                                                  : *between(0, 2));
        S += std::pow(10, *between(-6, -2.5));
      }
    }
    const SlidingCurve curve = trace_loading_curve(Friction::as_met(table), rig, S + 0.1);
    // Halving a cell down to a corner looks at 18 points, twenty times, from the table and exactly; a cell between knots has a few folds.
    const double cells = static_cast<double>(table.S.size()) + 100;
    RC_ASSERT(static_cast<double>(curve.looked_at) < 3 * 2 * 20 * 18 * cells);
  }));
}

}  // namespace flexslip
