#include <cmath>

#include <doctest/doctest.h>

#include "bending_test/rig.h"
#include "bending_test/trace.h"
#include "tests/generators.h"
#include "tests/refusal.h"

namespace flexslip {

TEST_CASE("reach, identity: a loading does not slide in beyond it, and only slightly less") {
  CHECK(rc::check([] {
    const Friction friction =
        Friction::sinusoid(*between(0, 1.2), *between(0, 0.9), *between(0.008, 0.2), *between(0, 6.28));
    const Rig rig{std::pow(10, *between(0.5, 3))};
    const double stage = *between(0.05, 1);
    const double S = longest_in_loading(friction, rig, stage);
    const auto whole = trace_loading_curve(friction, rig, longest_at_stage(stage));
    RC_ASSERT(S <= longest_at_stage(stage));
    for (const auto& part : stable_parts(whole)) {
      if (part.from.stage >= stage) break;
      if (part.to.stage < stage) continue;
      RC_ASSERT(point_at_stage(whole, part, stage).S <= S);
    }
  }));
}

TEST_CASE("reach, contract: a rig without stiffness and a stage that stands are refused with their values") {
  const Friction friction = Friction::constant(0.5);
  CHECK(message_of([&] { longest_in_loading(friction, {-1}, 0.5); }).find("-1") != std::string::npos);
  CHECK(message_of([&] { longest_in_loading(friction, {30}, 0); }).find("0.000000") != std::string::npos);
}

}  // namespace flexslip
