#include "inference/rig_error_effects.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

FitProblem on_rollers() {
  const SimulatedTruth truth{.friction = Friction::constant(0.4), .fibre = Fibre({.radius = 0.02, .half_depth = 0.01})};
  return {simulated_record(truth), {truth.stiffness, truth.fibre}, {0.02, 0.03, 0.0005}};
}

TEST_CASE("restated: to first order readings move by what RigShifts says, and supports change as stated") {
  const FitProblem problem = on_rollers();
  const RigErrorEffects shifts(problem, 0.4);
  constexpr double more = 1e-6;
  constexpr double second_order = 10 * more;  // of spans and forces of the order of 10
  for (const StatedQuantity quantity : stated_quantities) {
    CAPTURE(static_cast<int>(quantity));
    const FitProblem changed = restated(problem, quantity, more);
    const Supports &before = problem.rig.fibre.supports(), &after = changed.rig.fibre.supports();
    CHECK(after.radius - before.radius ==
          doctest::Approx(quantity == StatedQuantity::support_radius ? more : 0).epsilon(1e-9));
    CHECK(after.half_depth - before.half_depth ==
          doctest::Approx(quantity == StatedQuantity::thickness ? 0.5 * more : 0).epsilon(1e-9));
    if (quantity == StatedQuantity::support_radius || quantity == StatedQuantity::thickness) {
      CHECK(changed.record.force == problem.record.force);
      continue;
    }
    for (std::size_t i = 0; i < problem.record.force.size(); i += 20) {
      const double w = problem.record.deflection[i], F = problem.record.force[i];
      const Shift shift = shifts.by(quantity, w, F);
      CHECK(std::abs((changed.record.deflection[i] - w) / more - shift.deflection) < second_order);
      CHECK(std::abs((changed.record.force[i] - F) / more - shift.force) < second_order);
    }
  }
}

TEST_CASE("restated: what is stated larger and then smaller again is as it was") {
  const FitProblem problem = on_rollers();
  for (const StatedQuantity quantity : stated_quantities) {
    CAPTURE(static_cast<int>(quantity));
    constexpr double more = 0.01;
    const double back = changes_in_spans(quantity) ? -more : 1 / (1 + more) - 1;
    const FitProblem same = restated(restated(problem, quantity, more), quantity, back);
    CHECK(same.rig.stiffness == doctest::Approx(problem.rig.stiffness).epsilon(1e-12));
    CHECK(same.record.force.back() == doctest::Approx(problem.record.force.back()).epsilon(1e-12));
    CHECK(same.record.stage.back() == doctest::Approx(problem.record.stage.back()).epsilon(1e-12));
  }
  CHECK(message_of([&] { restated(problem, StatedQuantity::span, -1); }) != "");
}

}  // namespace
}  // namespace flexslip
