#include "bending_test/trace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/snap.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/bending_test/some_rig.h"
#include "tests/fig_8.h"
#include "tests/generators.h"
#include "tests/refusal.h"
#include "tests/unit.h"

namespace flexslip {
namespace {

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

// How far to trace for some periods of a wave, for the oracle's sake.
double after_periods(double wavelength, double most) { return 1 + std::min(0.6, 2 * wavelength * *between(1, most)); }

}  // namespace

TEST_CASE("trace: the folds of Fig. 8B (table)") {
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

TEST_CASE("trace: the folds of Fig. 8B to six digits (paper)") {
  const std::vector<std::pair<double, double>> published{{1.14852, 0.588456}, {1.18579, 0.569262}, {1.26252, 0.698273},
                                                         {1.31637, 0.636468}, {1.38547, 0.754599}, {1.44293, 0.677394}};
  const auto curve = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, 1.5);
  for (std::size_t i = 0; i < published.size(); ++i) {
    CHECK(std::abs(curve.folds[i].point.S - published[i].first) <= 0.5e-5);
    CHECK(std::abs(curve.folds[i].point.stage - published[i].second) <= 0.5e-6);
  }
}

TEST_CASE("trace: no fold of a sinusoid is missed (oracle: 200 samples a period)") {
  std::size_t folds = 0;
  CHECK(rc::check("wavelengths from 0.001 to 0.5", [&] {
    const double wavelength = std::pow(10, *between(-3, std::log10(0.5)));
    const auto friction = Friction::sinusoid(*between(0.05, 1.2), *between(0, 1), wavelength, *between(0, 6.3));
    folds += folds_are_those_sampled(friction, any_rig(), after_periods(wavelength, 12), 2 * wavelength / 200);
  }));
  CHECK(folds > 100);  // there was something to miss
}

TEST_CASE("trace: no fold of incommensurate sinusoids is missed (oracle: 200 samples a period)") {
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

TEST_CASE("trace: no fold of a table is missed (oracle: 200 samples a knot)") {
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

TEST_CASE("trace: no fold of a rough profile is missed (oracle: 200 samples a correlation length)") {
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

TEST_CASE("trace: the two folds of a tooth appear where G' first touches zero (oracle: minimisation of G')") {
  const double wavelength = 0.02 * std::numbers::pi;
  const auto friction_with = [&](double amplitude) { return Friction::sinusoid(0.6, amplitude, wavelength, 0); };
  // The smallest G' on the first tooth, by golden section.
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

TEST_CASE("trace: constant friction has the folds of F alone, where k is soft (limit)") {
  // G' = w_S + F_S/k: with k -> 0 the maximum of G is the maximum of F.
  const auto curve = trace_loading_curve(Friction::constant(0.6), {1e-9}, 1.5);
  REQUIRE(curve.folds.size() == 1);
  CHECK(curve.folds.front().point.F == to(1e-12, 9.50343010672679644488645323038));
  CHECK(curve.folds.front().point.S == to(1e-8, 1.19753085077872304850086107331));  // moved by k w_S/F_SS
  CHECK(trace_loading_curve(Friction::constant(0.6), {1000}, 1.5).folds.empty());
}

TEST_CASE("trace: a curve says why it ended (limit)") {
  const auto whole = trace_loading_curve(friction_of_fig_8(), rig_of_fig_8, 1.5);
  CHECK(whole.end_reason == CurveEnd::reached);
  CHECK(whole.end.S == to(2 * unit, 1.5));
  const auto branch = trace_loading_curve(Friction::constant(0), rig_of_fig_8, 5);
  CHECK(branch.end_reason == CurveEnd::branch_ended);
  CHECK(branch.end.S == to(16 * unit, 2.18843961522647663884));
  CHECK(branch.end.F <= 1e-13);
}

TEST_CASE("trace: what cannot be traced is refused with its value (contract)") {
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

TEST_CASE("trace: the work of finding folds is bounded by the knots of a table, for any values (property)") {
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
