#include "data/no_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

constexpr double stiffness = 90, step = 2e-6, reading_noise = 1e-5;

// A curve that flattens, with slips of 30 steps each if asked.
Record curve(double slip, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, reading_noise);
  Record record;
  double fallen = 0;
  for (int i = 0; i < 300; ++i) {
    const double stage = step * i;
    if (i % 30 == 29) fallen = slip;
    fallen = std::max(0.0, fallen - 0.3 * stiffness * step);
    record.stage.push_back(stage);
    record.force.push_back(0.012 * std::sin(stage / 4e-4) - fallen + normal(engine));
    record.deflection.push_back(stage - record.force.back() / stiffness);
  }
  return record;
}

TEST_CASE("spikes: readings that the load train cannot have made are found, and no others (truth known)") {
  for (const double by : {0.4e-3, -0.4e-3, 5e-3, -0.02})
    for (const std::size_t length : {1u, 2u, 3u})
      for (unsigned seed = 1; seed <= 4; ++seed)
        for (const double train : {stiffness, std::numeric_limits<double>::infinity()}) {
          CAPTURE(by);
          CAPTURE(length);
          CAPTURE(train);
          Record record = curve(0, seed);
          std::vector<std::size_t> made;
          for (const std::size_t at : {60u, 130u, 131u + 40u, 250u})
            for (std::size_t k = 0; k < length; ++k) {
              record.force[at + k] += by;
              made.push_back(at + k);
            }
          CHECK(find_spikes(record, train) == made);
        }
}

TEST_CASE("stray positions: what the stage jumps to and comes back from is found, and no turn of it (truth known)") {
  for (const double to : {99e-3, -99e-3, 0.0})
    for (const std::size_t length : {1u, 2u, 3u}) {
      CAPTURE(to);
      CAPTURE(length);
      auto [stage, deflection, force] = curve(0, 1);
      std::vector<std::size_t> made;
      for (const std::size_t at : {60u, 130u, 250u})
        for (std::size_t k = 0; k < length; ++k) {
          stage[at + k] = to;
          made.push_back(at + k);
        }
      CHECK(find_stray_positions(stage, force) == made);
    }
  std::vector<double> to_and_fro, in_steps;
  for (int i = 0; i < 300; ++i) {
    to_and_fro.push_back(step * (i % 100 < 50 ? i % 100 : 0));  // back at once, and from there again
    in_steps.push_back(step * (i / 10) * 30);
  }
  CHECK(find_stray_positions(to_and_fro, curve(0, 1).force).empty());
  CHECK(find_stray_positions(in_steps, curve(0, 1).force).empty());
  CHECK(find_stray_positions(std::vector<double>(20, 1.0), std::vector<double>(20, 1.0)).empty());
}

TEST_CASE(
    "stray positions: a word for what could not be read is found, however long it stays; a stage that goes there is "
    "none") {
  for (const double to : {99e-3, -99e-3, -1e-3})
    for (const std::size_t length : {5u, 30u, 100u}) {
      CAPTURE(to);
      CAPTURE(length);
      auto [stage, deflection, force] = curve(0, 1);
      std::vector<std::size_t> made;
      for (std::size_t k = 0; k < length; ++k) {
        stage[120 + k] = to;
        made.push_back(120 + k);
      }
      CHECK(find_stray_positions(stage, force) == made);
      for (std::size_t k = 0; k < length; ++k) force[120 + k] = to < 0 ? 0 : 2 * force.back();  // the specimen feels it
      CHECK(find_stray_positions(stage, force).empty());
    }
}

TEST_CASE("spikes: slips are none, however deep (limit)") {
  for (const double slip : {0.0, 0.2e-3, 2e-3, 6e-3})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      CAPTURE(slip);
      CHECK(find_spikes(curve(slip, seed), stiffness).empty());
      CHECK(find_spikes(curve(slip, seed), std::numeric_limits<double>::infinity()).empty());
    }
}

TEST_CASE("spikes: a force that shakes all the time has none (limit)") {
  Record record = curve(0, 1);
  for (std::size_t i = 0; i < record.force.size(); i += 7) record.force[i] += 1e-3;
  CHECK(find_spikes(record, stiffness).empty());
}

TEST_CASE("holds: what is read while the stage halts is found, several readings at each place are none (truth known)") {
  std::vector<double> stage, staircase;
  std::vector<std::size_t> halted;
  for (int i = 0; i < 200; ++i) {
    stage.push_back(step * i);
    for (int k = 0; k < 4; ++k) staircase.push_back(step * i);
    if (i != 50 && i != 120) continue;
    for (int k = 0; k < (i == 50 ? 6 : 80); ++k) {
      halted.push_back(stage.size());
      stage.push_back(step * (i + 0.002 * (k % 2)));
    }
  }
  CHECK(find_halts(stage) == halted);
  CHECK(find_halts(staircase).empty());
  CHECK(find_halts({}).empty());
  CHECK(find_halts({1, 1, 1, 1, 1, 1}).empty());  // it never moves
}

TEST_CASE(
    "overload: a counter that is full begins anew far below zero, a specimen that breaks does not (truth known)") {
  Record record = curve(0, 1);
  const double full = record.force[200];
  for (std::size_t i = 201; i < record.force.size(); ++i) record.force[i] -= 2 * full;
  CHECK(points_before_overload(record) == 201);
  for (std::size_t i = 201; i < record.force.size(); ++i) record.force[i] = -0.999 * full;
  CHECK(points_before_overload(record) == 201);
  for (double& force : record.force) force = -force;  // compression is negative
  CHECK(points_before_wrap(record.force) == 201);
  for (double& force : record.force) force = -force;
  Record glitch = curve(0, 1);
  glitch.force[100] = 1, glitch.force[101] = -1;
  CHECK(points_before_wrap(glitch.force) == glitch.force.size());
  for (std::size_t i = 201; i < record.force.size(); ++i) record.force[i] = -0.1 * full;
  CHECK(points_before_overload(record) == record.force.size());
}

TEST_CASE("overload: a force that stays at its greatest value is the end of the load cell, a flat top is not") {
  Record record = curve(0, 1);
  CHECK(points_before_overload(record) == 300);
  for (double& force : record.force) force = std::min(force, 0.008);
  const auto first =
      static_cast<std::size_t>(std::find(record.force.begin(), record.force.end(), 0.008) - record.force.begin());
  CHECK(points_before_overload(record) == first + 1);

  for (unsigned seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(0, reading_noise);
    Record ended = curve(0, seed), yielding = ended;
    for (double& force : ended.force)
      if (force > 0.008) force = 0.008 + 0.05 * normal(engine);  // the last digit of the converter flickers
    CHECK(std::abs(static_cast<double>(points_before_overload(ended)) - static_cast<double>(first)) <= 5);
    for (double& force : yielding.force)
      if (force > 0.008) force = 0.008 + normal(engine);
    CHECK(points_before_overload(yielding) == 300);
    Record top = curve(0, seed);  // goes over its top
    for (double& stage : top.stage) stage *= 2;
    for (std::size_t i = 0; i < top.force.size(); ++i)
      top.force[i] = 0.012 * std::sin(top.stage[i] / 4e-4) + normal(engine);
    CHECK(points_before_overload(top) == 300);
    Record dense;  // whose steps are far below the noise
    for (int i = 0; i < 6000; ++i) {
      dense.stage.push_back(0.5e-6 * i / 5);
      dense.force.push_back(0.012 * std::sin(dense.stage.back() / 4e-4) + normal(engine));
      dense.deflection.push_back(dense.stage.back());
    }
    CHECK(points_before_overload(dense) == 6000);
    CHECK(points_before_overload(curve(0.2e-3, seed)) == 300);
    CHECK(points_before_overload(curve(2e-3, seed)) == 300);
  }

  Record coarse = curve(0, 1);  // its top is flat within the steps of the converter
  for (double& force : coarse.force) force = 2e-4 * std::round(force / 2e-4);
  CHECK(points_before_overload(coarse) == 300);
}

}  // namespace
