#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "bending_test/sliding_table.h"
#include "fibre/elastica.h"

namespace flexslip {
namespace {

TEST_CASE("oracle: w and F of the ladder agree with the exact states to 1e-12, within the table and beyond it") {
  for (const double S_max : {1.05, 1.5, 2.1}) {
    const SlidingLadder ladder(S_max, 0.004);
    for (const double mu : {0.0, 0.013, 0.4, 1.0, 1.7, 2.0}) {
      const auto curve = ladder.curve(std::vector<double>(ladder.lengths().size(), mu));
      for (std::size_t i = 1; i < ladder.lengths().size(); ++i) {
        const auto [state, exact] = fibre_state_slopes(ladder.lengths()[i], mu);
        REQUIRE(state.status == FibreStatus::ok);
        CHECK(std::abs(curve.w[i] - state.w) <= 1e-12 * state.w);
        const double condition_of_F = state.F + (state.S - 1) * std::abs(exact.F_S) + mu * exact.F_q;  // times F
        CHECK(std::abs(curve.F[i] - state.F) <= 1e-12 * condition_of_F);
      }
    }
  }
}

TEST_CASE("oracle: the measured curve on the ladder agrees with the exact folds, snaps included") {
  const Friction friction = Friction::sinusoid(0.6, 0.2, 0.008, 0.3);
  const double k = 80;
  std::vector<double> stages;
  for (int i = 1; i <= 300; ++i) stages.push_back(0.0018 * i);
  const auto exact = follow_in_steps({friction, {k}}, stages);
  const SlidingLadder ladder(1.6, 2 * 0.008 / 20);
  std::vector<double> mu;
  for (const double S : ladder.lengths()) mu.push_back(friction.at(S).mu);
  const auto curve = ladder.curve(mu);
  const auto measured = measured_curve(curve.w, curve.F, 1 / k, stages);
  // 60/n^4 of a tooth's height in F, about 1, with n = 20 lengths a period
  for (std::size_t i = 0; i < stages.size(); ++i) CHECK(std::abs(measured[i] - exact.path[i].F) < 60 / std::pow(20, 4));
}

TEST_CASE("limit: a ladder that cannot be made is refused") {
  CHECK_THROWS_AS(SlidingLadder(1.0, 0.01), std::invalid_argument);
  CHECK_THROWS_AS(SlidingLadder(2.2, 0.01), std::invalid_argument);
  CHECK_THROWS_AS(SlidingLadder(1.5, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace flexslip
