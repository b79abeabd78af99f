#include "fibre/loose_rollers.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE("loose rollers, published numbers: slope, deflection and force of rollers of a twentieth of the span") {
  for (const auto& [theta0, w, F] : {std::array{0.1584073464, 0.0526279283143, 2.59586794931},
                                     std::array{0.4584073464, 0.151883872593, 7.52281567434}}) {
    const auto [state, span] = state_on_loose_rollers(w, {0.05, 0});
    REQUIRE(state.status == FibreStatus::ok);
    CHECK(state.theta0 == doctest::Approx(theta0).epsilon(1e-9));
    CHECK(state.F == doctest::Approx(F).epsilon(1e-10));
    CHECK(state.q == doctest::Approx(std::tan(0.5 * theta0)).epsilon(1e-9));
    CHECK(state.slid == doctest::Approx(1 - span).epsilon(1e-12));
  }
}

TEST_CASE("loose rollers, identity: the work of the force is the bending energy, but for what thickness loses") {
  for (const Supports& supports : {Supports{0.05, 0}, Supports{0.01, 0}, Supports{0.04, 0.03}}) {
    const double from = 0.05, to = 0.2;
    const int steps = 200;
    double work = 0;
    const auto force = [&](double w) { return state_on_loose_rollers(w, supports).state.F; };
    for (int i = 0; i < steps; ++i) {  // Simpson's rule
      const double a = from + (to - from) * i / steps, b = from + (to - from) * (i + 1) / steps;
      work += (b - a) / 6 * (force(a) + 4 * force(0.5 * (a + b)) + force(b));
    }
    const double gained = state_on_loose_rollers(to, supports).state.U - state_on_loose_rollers(from, supports).state.U;
    CHECK(work == doctest::Approx(gained).epsilon(supports.half_depth > 0 ? 1e-5 : 1e-9));
  }
}

TEST_CASE("loose rollers, limit: hardly bent they are those that are fixed, without friction") {
  const auto loose = state_on_loose_rollers(1e-4, {0.05, 0.01}).state;
  CHECK(loose.F == doctest::Approx(48e-4).epsilon(1e-3));
  CHECK(loose.q < 2e-4);
}

TEST_CASE("loose rollers, contract: an edge rolls nowhere, and what no roller holds has no state") {
  CHECK_THROWS_AS(state_on_loose_rollers(0.1, {0, 0.01}), std::invalid_argument);
  CHECK_THROWS_AS(state_on_loose_rollers(-0.1, {0.05, 0}), std::invalid_argument);
  CHECK(state_on_loose_rollers(1.5, {0.05, 0}).state.status != FibreStatus::ok);
}

}  // namespace flexslip
