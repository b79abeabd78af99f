#include <cmath>

#include <doctest/doctest.h>

#include "inference/analysis.h"
#include "tests/approximately.h"

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
}

TEST_CASE("stiffness_from_slope: none where the force does not rise") {
  CHECK(!stiffness_from_slope(straight(2.1e-12, 1.278e-3, -1), 1.278e-3).found);
  CHECK(!stiffness_from_slope(straight(0, 1.278e-3), 1.278e-3).found);
}

}  // namespace flexslip
