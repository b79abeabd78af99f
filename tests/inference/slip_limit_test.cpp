#include "inference/slip_limit.h"

#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "numerics/elementary.h"

using namespace flexslip;

namespace {

double limit_at(double w, const Supports& supports, double advance = 0) {
  const ReducedRecord record{{w, w + advance}, {w, w + advance}, {1, 0.5}};
  const std::array drops{Drop{.before = 0, .after = 1, .force_fall = 0.5, .advance = advance, .significance = 9}};
  return most_by_slips(record, drops, supports).front();
}

TEST_CASE("slip limit: of a stocky bar that is hardly bent it is 1.5 h/L of the force (limit)") {
  for (const double height : {0.005, 0.01, 0.02}) {
    CAPTURE(height);
    CHECK(limit_at(1e-4, {0, 0.5 * height}) == doctest::Approx(1.5 * height).epsilon(0.01));
  }
}

TEST_CASE("slip limit: of a slender specimen on edges it grows as 1.6 w/L (limit)") {
  for (const double w : {0.005, 0.01, 0.02}) {
    CAPTURE(w);
    const double x = 1.6 * w;
    CHECK(limit_at(w, {0, 0}) == doctest::Approx(x / (1 + x)).epsilon(0.05));
  }
}

TEST_CASE("slip limit: a specimen that moves on while the force falls can lose less") {
  const Supports bar{0, 0.03};
  CHECK(limit_at(0.02, bar, 0.001) < limit_at(0.02, bar));
  CHECK(limit_at(0.02, bar, 0.01) == 0);
}

}  // namespace
