#include <cmath>

#include <doctest/doctest.h>

#include "inference/analysis.h"
#include "tests/approximately.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {
namespace {

// F = 48 EI w/L³, of a stage that pushes through a load train of 90 N/m.
Record straight(double EI, double span, double force_sign = 1) {
  Record record;
  for (int i = 0; i <= 200; ++i) {
    const double w = 2e-6 * i, F = force_sign * 48 * EI * w / (span * span * span);
    record.deflection.push_back(w);
    record.force.push_back(F);
    record.stage.push_back(w + std::abs(F) / 90);
  }
  return record;
}

}  // namespace

TEST_CASE("stiffness_from_slope: a straight record gives its stiffness back (identity)") {
  constexpr double EI = 2.1e-12, span = 1.278e-3;
  const StiffnessFromSlope found = stiffness_from_slope(straight(EI, span), span);
  REQUIRE(found.found);
  CHECK(found.value == to(1e-12, EI));
  CHECK(found.relative_error == doctest::Approx(std::hypot(0.03, 0.03)).epsilon(1e-6));  // of a slope without noise
  Record late = straight(EI, span);
  const double error = 1e-3 * found.deflection;
  for (double& deflection : late.deflection) deflection += error;
  CHECK(stiffness_from_slope(late, span).value / found.value == doctest::Approx(1 - 1e-3).epsilon(1e-4));
}

TEST_CASE("stiffness_from_slope: none where the force does not rise") {
  CHECK(!stiffness_from_slope(straight(2.1e-12, 1.278e-3, -1), 1.278e-3).found);
  CHECK(!stiffness_from_slope(straight(0, 1.278e-3), 1.278e-3).found);
}

TEST_CASE(
    "stiffness_from_slope: of a simulated sawtooth its error covers the truth, and one that is mostly noise tells "
    "none") {
  SimulatedTruth truth{.friction = Friction::sinusoid(0.6, 0.3, 14.0 / 1278, 1.0), .stiffness = 90, .noise = 0.01};
  const StiffnessFromSlope found = stiffness_from_slope(to_physical(simulated_record(truth), scales), scales.span());
  REQUIRE(found.found);
  CHECK(std::abs(scales.bending_stiffness() / found.value - 1) < 1.96 * found.relative_error);
  truth.noise = 1.5;
  CHECK(!stiffness_from_slope(to_physical(simulated_record(truth), scales), scales.span()).found);
}

}  // namespace flexslip
