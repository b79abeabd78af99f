#include "data/failure.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "tests/data/straight_test.h"

using namespace flexslip;

namespace {

TEST_CASE("failure: it is the last point before the force is lost for good (truth known)") {
  Record record = straight_test(300, 0, 0, 1);
  SUBCASE("at one stroke") {
    for (std::size_t i = 250; i < 300; ++i) record.force[i] = 1e-4;
    CHECK(find_failure(record).points == 250);
  }
  SUBCASE("beginning with a small step") {
    record.force[250] = 0.97 * record.force[249];
    for (std::size_t i = 251; i < 300; ++i) record.force[i] = 1e-4;
    CHECK(find_failure(record).points == 250);
  }
  SUBCASE("in two strokes, the first of them made up by nothing") {
    for (std::size_t i = 250; i < 300; ++i) record.force[i] *= i < 255 ? 0.8 : 0.05;
    CHECK(find_failure(record).points == 250);
    CHECK(find_failure(record).fallen == 250);  // what falls behind that point fell after the break
  }
  SUBCASE("after a slip that loading makes up again") {
    for (std::size_t i = 245; i < 300; ++i) record.force[i] -= 0.06 * record.force[244];
    for (std::size_t i = 275; i < 300; ++i) record.force[i] = 1e-4;
    CHECK(find_failure(record).points == 275);
  }
}

TEST_CASE("failure: what survives has no failure (limit)") {
  const auto survives = [](const Record& record) {
    const Failure failure = find_failure(record);
    return failure.status == FailureStatus::none && failure.points == record.force.size();
  };
  CHECK(survives({}));
  CHECK(survives({{0}, {0}, {0}}));
  CHECK(survives({{0, 1, 2}, {0, 1, 2}, {0, 0, 0}}));
  CHECK(survives(straight_test(300, 0, 5e-6, 1)));

  Record arch = straight_test(300, 0, 0, 1);  // the force returns to zero smoothly, as for a very flexible fibre
  for (std::size_t i = 0; i < 300; ++i) arch.force[i] = std::sin(3.14 * static_cast<double>(i) / 299);
  CHECK(survives(arch));

  // A cracked specimen whose force declines below half at large deflection: it has not broken.
  for (std::size_t i = 0; i < 300; ++i) arch.force[i] -= i > 200 ? 0.06 * arch.force[i] : 0;
  CHECK(survives(arch));

  Record turned =
      straight_test(100, 0, 0, 1);  // it slips by a quarter as the stage turns back, and bears the rest on the way
  turned.force.back() *= 0.75;
  for (std::size_t i = 99; i-- > 50;) {
    turned.stage.push_back(turned.stage[i]);
    turned.deflection.push_back(turned.deflection[i]);
    turned.force.push_back(0.7 * turned.force[i]);
  }
  CHECK(survives(turned));
  for (std::size_t i = 100; i < turned.force.size(); ++i) turned.force[i] *= 0.2;  // read in the midst of a break
  CHECK(find_failure(turned).points == 99);

  Record unloaded = straight_test(100, 0, 0, 1);  // loaded and taken back at a stroke
  unloaded.stage.push_back(0);
  unloaded.deflection.push_back(0);
  unloaded.force.push_back(0);
  CHECK(survives(unloaded));
}

// A specimen that sometimes slips by a hundredth and breaks at stage position 1, in n equal steps; the force falls over
// a part of the travel in each. Read so often.
struct Broken {
  int readings = 300;
  double noise = 1e-3;
  int steps = 1;
  double width = 1e-3;    // of a step
  double between = 0.02;  // of steps
  double after = 0.1;     // travel after the break
  double left = 0.03;     // of the force
};

Record broken(const Broken& how, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, how.noise);
  Record record;
  const double end = 1 + (how.steps - 1) * how.between + how.after;
  for (int i = 0; i < how.readings; ++i) {
    const double stage = end * i / (how.readings - 1);
    double kept = 1;
    for (int k = 0; k < how.steps; ++k) {
      const double fallen = std::clamp((stage - 1 - k * how.between) / how.width, 0.0, 1.0);
      kept -= fallen * (1 - how.left) / how.steps;
    }
    const double slips = 0.01 * std::floor(8 * std::min(stage, 1.0));
    record.stage.push_back(stage);
    record.deflection.push_back(stage);
    record.force.push_back((std::sin(1.4 * std::min(stage, 1.0)) - slips) * kept + normal(engine));
  }
  return record;
}

// How far behind the last stage at which it was whole the failure is found; whole travels for none.
double found_behind(const Record& record) {
  const Failure failure = find_failure(record);
  if (failure.status == FailureStatus::none) return record.stage.back();
  return record.stage[failure.points - 1] - 1;
}

TEST_CASE("failure: it is found at any rate of reading, over however many of them it falls (truth known)") {
  for (const int readings : {120, 300, 1000, 5000, 20000})
    for (const double width : {1e-4, 3e-3, 0.03})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        CAPTURE(readings);
        CAPTURE(width);
        const double off = found_behind(broken({.readings = readings, .width = width}, seed));
        const double reading = 1.1 / readings;
        CHECK(off > -2 * reading - 0.002);
        CHECK(off < 2 * reading + 0.05 * width);
      }
}

TEST_CASE("failure: of a break in steps it is the first that is not made good (truth known)") {
  for (const int steps : {2, 3, 5})
    for (const int readings : {300, 3000})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        CAPTURE(steps);
        CAPTURE(readings);
        CHECK(std::abs(found_behind(broken({.readings = readings, .steps = steps}, seed))) < 0.01);
      }
}

// A laminate: each ply that breaks takes its share of the stiffness, and the rest is loaded further.
Record plies_break(int plies, double between, double noise, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, noise);
  const auto broken_at = [&](int i) {
    return i <= 250 ? 0 : std::min(plies - 1, 1 + static_cast<int>((i / 250.0 - 1) / between));
  };
  Record record;
  double force = 0;
  for (int i = 0; i < 400; ++i) {
    const double lost_now = broken_at(i) - broken_at(i - 1);
    force += (1 - static_cast<double>(broken_at(i)) / plies) / 250 - lost_now / plies;
    record.stage.push_back(i / 250.0);
    record.deflection.push_back(i / 250.0);
    record.force.push_back(std::max(force, 0.0) + normal(engine));
  }
  return record;
}

TEST_CASE("failure: plies that break one after another are a failure at the first (truth known)") {
  for (const int plies : {5, 8, 12})
    for (const double noise : {5e-4, 5e-3}) {
      CAPTURE(plies);
      CAPTURE(noise);
      const Record record = plies_break(plies, 0.5 / plies, noise, 1);
      CHECK(record.force.back() < 0.5);
      const Failure failure = find_failure(record);
      REQUIRE(failure.status == FailureStatus::found);
      CHECK(std::abs(static_cast<int>(failure.points) - 251) <= 2);
    }
}

TEST_CASE("failure: a break that takes a fifth of the travel, with teeth, begins at its first fall (truth known)") {
  for (const int tooth : {4, 7, 12}) {
    Record record = straight_test(400, 0, 3e-6, 1);
    const double highest = record.force[299];
    for (std::size_t i = 300; i < 400; ++i) {
      const double fallen = std::min(1.0, static_cast<double>(i - 299) / 60);
      const double rises = fallen < 1 ? 0.02 * static_cast<double>((static_cast<int>(i) - 299) % tooth) / tooth : 0;
      record.force[i] = highest * (1 - 0.97 * fallen + rises);
    }
    CAPTURE(tooth);
    CHECK(std::abs(static_cast<int>(find_failure(record).points) - 300) <= 4);
  }
}

TEST_CASE("failure: a record that stops at the break ends with it; a record that continues survived (limit)") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    CHECK(std::abs(found_behind(broken({.after = 0.006, .left = 0.6}, seed))) < 0.01);
    CHECK(find_failure(broken({.after = 0.3, .left = 0.6}, seed)).status == FailureStatus::none);
  }
}

TEST_CASE("failure: a break within a slow fall that continues long after it (once without an end)") {
  Record record;
  const auto add = [&](double force) {
    record.stage.push_back(1e-6 * static_cast<double>(record.stage.size()));
    record.force.push_back(force);
    record.deflection.push_back(record.stage.back());
  };
  for (int i = 0; i <= 100; ++i) add(0.01 * i);
  for (int i = 1; i <= 48; ++i) add(1 - 0.01 * i);
  for (int i = 0; i <= 24; ++i) add(0.44 - 0.01 * i);
  CHECK(find_failure(record).points == 149);
}

}  // namespace
