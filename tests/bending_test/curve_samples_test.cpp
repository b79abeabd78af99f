#include <cmath>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/sliding_piece.h"
#include "bending_test/sliding_table.h"

namespace flexslip {
namespace {

std::vector<double> way(double from, double to, int n) {
  std::vector<double> x;
  for (int i = 0; i <= n; ++i) x.push_back(from + (to - from) * i / n);
  return x;
}

TEST_CASE("identity: many samples equal single samples, and pieces have their values") {
  const Friction friction = Friction::sinusoid(0.6, 0.3, 0.01, 1);
  for (const double stiffness : {20.0, 300.0, std::numeric_limits<double>::infinity()})
    for (const Sliding sliding : {Sliding::in, Sliding::out}) {
      // let out, the fibre's branch ends near S = 1.3: some samples do not exist
      const auto x = sliding == Sliding::in ? way(0, 0.85, 500) : way(-0.7, 0, 500);
      const auto exact = samples_at(friction, {stiffness}, sliding, x);
      const auto pieces = pieces_between(friction, {stiffness}, sliding, x);
      int missing = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        const CurveSample one = sample_at(friction, {stiffness}, sliding, x[i]);
        REQUIRE(exact[i].exists == one.exists);
        missing += !one.exists;
        if (i < pieces.size()) REQUIRE(std::isnan(pieces[i].F.front()) == !one.exists);
        if (!one.exists) continue;
        CHECK(exact[i].point.stage == one.point.stage);
        CHECK(exact[i].slope == one.slope);
        CHECK(exact[i].scale == one.scale);
        if (i == pieces.size()) continue;
        const double F = pieces[i].F.front(), stage = pieces[i].stage.front();
        // 1e-12 of F times its condition number, which is 10 where F is of the order 1 (fibre/state_table.h)
        CHECK(std::abs(F - one.point.F) <= 1e-11 * (1 + one.point.F));
        CHECK(std::abs(stage - one.point.stage) <= 1e-11 * (1 + one.point.stage));
      }
      CHECK((missing > 0) == (sliding == Sliding::out));
    }
}

TEST_CASE("oracle: slopes equal differences of the stage position") {
  const Friction friction = Friction::sinusoid(0.6, 0.3, 0.05, 1);
  const double h = 1e-5;
  for (const double x : {0.2, 0.4, 0.6}) {
    const auto at = samples_at(friction, {50}, Sliding::in, std::vector<double>{x - h, x, x + h});
    const double difference = (at[2].point.stage - at[0].point.stage) / (2 * h);
    CHECK(std::abs(difference - at[1].slope) <=
          1e-5 * at[1].scale);  // h² of the third derivative, (π/λ)² ~ 4000 of the first
  }
}

}  // namespace
}  // namespace flexslip
