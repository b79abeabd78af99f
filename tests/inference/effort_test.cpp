// No input without an end: whatever record, legal but absurd, meets whatever rig, a whole fit takes no more than its rows allow.
#include "numerics/effort.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "inference/analysis.h"
#include "inference/passes.h"
#include "tests/generators.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

// One in so many is 10^[-decades, decades], the others 1.
double off(int one_in, double decades) {
  const double exponent = *between(-decades, decades);
  return *whole(1, one_in) == 1 ? std::pow(10, exponent) : 1;
}

enum class Oddity { none, wanders, halts, begins_under_a_force, few_rows };

// Of a simulated test with or without cracks: as it is, or of a force that wanders and falls, in several readings at a place, from a preload on, or in
// few rows.
ReducedRecord some_record() {
  const SimulatedTruth truth{
      .friction = Friction::sinusoid(*between(0, 0.8), *between(0, 0.4), *between(4, 40) / 1278, 1),
      .stiffness = std::pow(10, *between(0.5, 3)),
      .noise = std::pow(10, *between(-4, -1)),
      .step = *between(0.8, 6) / 1278,
      .deflection = *between(0.06, 0.5),
      .seed = static_cast<std::uint64_t>(*whole(1, 1 << 20)),
      .fibre = {}};
  const ReducedRecord made = simulated_record(truth, *whole(1, 3) == 1 ? six_cracks : std::vector<Crack>{});
  const auto oddity = static_cast<Oddity>(*whole(0, 4));
  const std::size_t rows = made.force.size(), begin = oddity == Oddity::begins_under_a_force ? rows / 6 : 0,
                    each = oddity == Oddity::few_rows ? rows / 40 + 1 : 1;
  std::mt19937_64 generator(truth.seed);
  ReducedRecord record;
  for (std::size_t i = begin; i < rows; i += each) {
    const double uniform = (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53;
    double force = made.force[i], stage = made.stage[i] - (begin > 0 ? made.stage[begin] : 0);
    if (oddity == Oddity::wanders && i > 0)
      force = uniform < 0.05 ? 0.5 * record.force.back() : record.force.back() + (uniform - 0.4) * 0.5;
    if (oddity == Oddity::halts) stage = made.stage[i - i % 7];
    record.stage.push_back(stage);
    record.force.push_back(force);
    record.deflection.push_back(stage - force / truth.stiffness);
  }
  return record;
}

TestDescription some_description() {
  constexpr std::array trains{90.65, 30.0, 0.001, infinity};
  const double train = trains[static_cast<std::size_t>(*whole(0, 3))] * off(2, 2);
  const double wide = *whole(1, 5) == 1 ? *between(0.001, 0.06) : 0;
  const double thick = *whole(1, 3) == 1 ? std::pow(10, *between(-3, -1.3)) : 0;
  return {.span = scales.span() * off(3, 1),
          .load_train_stiffness = train,
          .bending_stiffness = scales.bending_stiffness() * off(2, 2),
          .contact_error = *whole(1, 3) == 1 ? std::optional(*between(0, 20e-6)) : std::nullopt,
          .fibre = wide + thick > 0 ? Fibre({wide, thick}) : Fibre()};
}

// Of some 3,000 such tests the worst took 113,000 states for each row and 100 more, the worst on supports 41 million for 57 rows.
TEST_CASE("effort: an analysis takes no more than its rows allow, whatever its record meets (identity)") {
  CHECK(rc::check("absurd tests", [] {
    const Record record = to_physical(some_record(), scales);
    const TestDescription description = some_description();
    const std::size_t rows = record.force.size(), fitted = std::min<std::size_t>(rows, 1200) + 100;
    const std::uint64_t run_forward = description.fibre.on_edges() ? 0 : 60'000'000;
    RC_PRE(rows >= min_fitted_points);
    effort_spent.clear();
    analyse(record, description);
    RC_ASSERT(effort_spent.spent() <= 200'000 * fitted + 500 * rows + run_forward);
  }));
}

// Of a thick specimen, unloaded and loaded again, whose bending stiffness is stated wrongly by a factor.
struct Reloaded {
  Record record;
  Rig rig;
};

Reloaded reloaded(double stated) {
  const Rig true_rig{90, Fibre({0, 0.0136})};
  std::vector<double> stages;
  double at = 0;
  for (const double turn : {0.3, 0.05, 0.35, 0.1}) {
    const double step = std::copysign(2.0 / 1278, turn - at);
    while ((turn - at) * step > 0) stages.push_back(at += step);
  }
  const History history = follow_in_steps({Friction::sinusoid(0.4, 0.1, 10.0 / 1278, 1), true_rig}, stages);
  ReducedRecord record;
  for (const PathPoint& point : history.path) {
    record.stage.push_back(point.stage);
    record.force.push_back(point.F / stated);
    record.deflection.push_back(point.w);
  }
  return {to_physical(record, scales), {true_rig.stiffness / stated, true_rig.fibre}};
}

PassesProblem all_passes(const Record& record, const Rig& rig) {
  const auto legs = find_legs(record.stage);
  return {.record = to_reduced(record, scales),
          .rig = rig,
          .errors = {.force = 0, .bending_stiffness = 0.1, .contact = 0.0005},
          .first = legs.front().first,
          .last = legs.front().last,
          .drops = {}};
}

TEST_CASE("effort: loops take no more than their rows allow, whatever bending stiffness is stated (identity)") {
  for (const double stated : {0.03, 0.1, 0.3, 0.7, 1.0, 1.5, 3.0, 10.0, 30.0}) {
    CAPTURE(stated);
    const auto [record, rig] = reloaded(stated);
    effort_spent.clear();
    fit_passes(all_passes(record, rig));
    CHECK(effort_spent.spent() <= 5'000 * record.force.size());
  }
}

TEST_CASE("effort: loops and a loading that are stopped at once leave no damage (regression)") {
  const auto [record, rig] = reloaded(1.5);
  const TestDescription description{.span = scales.span(),
                                    .load_train_stiffness = 90.65,
                                    .bending_stiffness = scales.bending_stiffness(),
                                    .contact_error = std::nullopt,
                                    .fibre = rig.fibre};
  const std::atomic<bool> stop = true;
  const Stoppable stoppable(&stop);
  CHECK_THROWS_AS(fit_passes(all_passes(record, rig)), Stopped);
  CHECK_THROWS_AS(analyse(record, description), Stopped);
}

}  // namespace
}  // namespace flexslip
