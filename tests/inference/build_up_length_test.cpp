#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "contact/build_up.h"
#include "inference/cyclic_answer.h"

namespace flexslip {
namespace {

const Rig rig{300};

CyclicFriction measured(const Friction& friction, double noise, std::uint64_t seed) {
  std::vector<double> stages;
  const auto go = [&](double from, double to) {
    const int steps = static_cast<int>(std::ceil(std::abs(to - from) / 1e-3));
    for (int i = 1; i <= steps; ++i) stages.push_back(from + (to - from) * i / steps);
  };
  go(0, 0.25);
  go(0.25, 0.05);
  go(0.05, 0.3);
  go(0.3, 0.05);
  go(0.05, 0.35);
  go(0.35, 0.1);
  const History history = follow_in_steps({friction, rig}, stages);
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0, 1);
  ReducedRecord record;
  for (const PathPoint& point : history.path) {
    record.stage.push_back(point.stage);
    record.force.push_back(point.F + noise * normal(generator));
    record.deflection.push_back(point.stage - record.force.back() / rig.stiffness);
  }
  return measure_cycles(record, rig);
}

Friction building_up(double sigma) {
  return Friction::path_dependent(std::make_shared<const BuildUp>(Friction::sinusoid(0.45, 0.2, 0.02, 1), sigma, 1.6));
}

}  // namespace

TEST_CASE("build-up length, oracle: that which was simulated is found, in noise within three standard errors") {
  for (const double sigma : {0.001, 0.002, 0.004}) {
    const auto exact = measured(building_up(sigma), 0, 1);
    const auto found = measure_build_up(exact.legs, exact.points);
    REQUIRE(found);
    CHECK(found->length.value == doctest::Approx(sigma).epsilon(0.15));  // friction varies along the specimen meanwhile
    if (sigma == 0.004) CHECK(found->is_told());                         // the others are slid from row to row
  }
  int within = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto noisy = measured(building_up(0.002), 0.01, seed);
    const auto found = measure_build_up(noisy.legs, noisy.points);
    REQUIRE(found);
    within += std::abs(found->length.value - 0.002) < 3 * found->length.standard_error + 0.15 * 0.002;
  }
  CHECK(within >= 9);
}

TEST_CASE("build-up length, limit: of friction that is there at once none is told") {
  for (const double noise : {0.001, 0.01, 0.03})
    for (const Friction& friction : {Friction::sinusoid(0.45, 0.2, 0.02, 1), Friction::constant(0.5)})
      for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const auto sharp = measured(friction, noise, seed);
        const auto found = measure_build_up(sharp.legs, sharp.points);
        REQUIRE(found);
        CHECK_FALSE(found->is_told());
      }
}

TEST_CASE("build-up length, limit: none without a reversal") { CHECK_FALSE(measure_build_up({}, {})); }

}  // namespace flexslip
