#include "bending_test/rolling.h"

#include <limits>
#include <stdexcept>

#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE(
    "rolling, identity: specimen and load train in line are as far as the stage, and no farther than it without one") {
  for (const Supports& supports : {Supports{0.05, 0}, Supports{0.02, 0.03}})
    for (const double stiffness : {5.0, 50.0, std::numeric_limits<double>::infinity()})
      for (const double stage : {1e-3, 0.05, 0.2}) {
        const auto found = state_at_stage(stage, stiffness, supports);
        REQUIRE(found);
        const SupportedState& state = found->state;
        CHECK(state.w + state.F / stiffness == doctest::Approx(stage).epsilon(1e-12));
      }
  CHECK(state_at_stage(0, 50, {0.05, 0})->state.F == 0);
}

TEST_CASE("rolling, limit: a specimen that falls through has no state, and none is bent by nothing") {
  CHECK_FALSE(state_at_stage(1.8, std::numeric_limits<double>::infinity(), {0.05, 0}));
  CHECK_THROWS_AS(state_at_stage(-0.1, 50, {0.05, 0}), std::invalid_argument);
}

}  // namespace flexslip
