#include "inference/sliding_map.h"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "fibre/elastica.h"

namespace flexslip {
namespace {

TEST_CASE("oracle: w and F of the map agree with the exact states to 1e-6, slopes to 1e-3") {
  for (const double S_max : {1.05, 1.5, 2.1}) {
    const SlidingMap map(S_max, 0.004, 2.0);
    for (const double mu : {0.0, 0.013, 0.4, 1.0, 1.7, 2.0}) {
      const auto curve = map.curve(std::vector<double>(map.lengths().size(), mu));
      const auto slopes = map.slopes(std::vector<double>(map.lengths().size(), mu));
      for (std::size_t i = 1; i < map.lengths().size(); ++i) {
        const auto [state, exact] = fibre_state_slopes(map.lengths()[i], mu);
        REQUIRE(state.status == FibreStatus::ok);
        const double scale = state.F / (1 + state.F);  // F -> 0 at the end of the branch: absolute there
        CHECK(std::abs(curve.w[i] - state.w) <= 1e-6 * state.w);
        CHECK(std::abs(curve.F[i] - state.F) <=
              1e-6 * (1 + state.F) * std::max(scale, std::sqrt(map.lengths()[i] - 1)));
        CHECK(std::abs(slopes.F[i] - exact.F_q) <= 1e-3 * exact.F_q);
      }
    }
  }
}

TEST_CASE("oracle: the measured curve on the ladder is that of the exact folds, snaps included") {
  const Friction friction = Friction::sinusoid(0.6, 0.2, 0.008, 0.3);
  const double k = 80;
  std::vector<double> stages;
  for (int i = 1; i <= 300; ++i) stages.push_back(0.0018 * i);
  const auto exact = follow_in_steps({friction, {k}}, stages);
  const SlidingMap map(1.6, 2 * 0.008 / 20, 2.0);
  std::vector<double> mu;
  for (const double S : map.lengths()) mu.push_back(friction.at(S).mu);
  const auto curve = map.curve(mu);
  const auto measured = measured_curve(curve.w, curve.F, 1 / k, stages);
  // 60/n^4 of a tooth's height in F, about 1, with n = 20 lengths a period
  for (std::size_t i = 0; i < stages.size(); ++i)
    CHECK(std::abs(measured.F[i] - exact.path[i].F) < 60 / std::pow(20, 4));
}

TEST_CASE("limit: a map that cannot be made is refused") {
  CHECK_THROWS_AS(SlidingMap(1.0, 0.01, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(SlidingMap(2.2, 0.01, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(SlidingMap(1.5, 0.0, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(SlidingMap(1.5, 0.01, 6.0), std::invalid_argument);
}

}  // namespace
}  // namespace flexslip
