#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <doctest/doctest.h>

#include "data/record.h"

namespace flexslip {
namespace {

// Stage positions in steps of 1 through the turning points given, each of them once.
std::vector<double> programme(std::vector<double> turns) {
  std::vector<double> stage{turns.front()};
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double step = turns[i] > turns[i - 1] ? 1 : -1;
    while (stage.back() != turns[i]) stage.push_back(stage.back() + step);
  }
  return stage;
}

// The legs must contain all points, in order, with alternating directions.
void check_partition(const std::vector<Leg>& legs, std::span<const double> stage) {
  REQUIRE(!legs.empty());
  CHECK(legs.front().first == 0);
  CHECK(legs.back().last == stage.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    REQUIRE(legs[i].first < legs[i].last);
    if (i == 0) continue;
    CHECK(legs[i].first == legs[i - 1].last);
    CHECK(legs[i].direction != legs[i - 1].direction);
    const double from = stage[legs[i].first - 1];
    const double to = stage[legs[i].last - 1];
    CHECK((to > from) == (legs[i].direction == Direction::loading));
  }
}

TEST_CASE("identity: the turning points of a programme without noise are found exactly, growing amplitudes too") {
  const auto stage = programme({0, 100, 5, 200, 5, 300, 150});
  const auto legs = find_legs(stage);
  check_partition(legs, stage);
  REQUIRE(legs.size() == 6);
  const double turns[] = {100, 5, 200, 5, 300, 150};
  for (std::size_t i = 0; i < 6; ++i) CHECK(stage[legs[i].last - 1] == turns[i]);
}

TEST_CASE("limit: one direction is one leg, a stage that stands still none") {
  CHECK(find_legs({}).empty());
  CHECK(find_legs(std::vector<double>{1.0}).empty());
  CHECK(find_legs(std::vector<double>{1.0, 1.0, 1.0}).empty());
  const auto up = find_legs(programme({0, 50}));
  REQUIRE(up.size() == 1);
  CHECK(up[0].direction == Direction::loading);
  CHECK(up[0].last == 51);
  const auto down = find_legs(programme({50, 0}));
  REQUIRE(down.size() == 1);
  CHECK(down[0].direction == Direction::unloading);
}

TEST_CASE("limit: noise of the stage larger than the minimum travel makes no loading (truth known)") {
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0, 1);
  std::vector<double> stage = programme({0, 120, 40, 130});
  for (double& position : stage) position += noise(engine);
  CHECK(find_legs(stage).size() == 3);
  CHECK(find_legs(std::span(stage).first(120)).size() == 1);
}

TEST_CASE("limit: an excursion counts from the minimum travel") {
  CHECK(find_legs(programme({0, 100, 99, 200})).size() == 1);
  CHECK(find_legs(programme({0, 100, 98, 200}), {.min_travel = 0.004}).size() == 3);  // of 200: 0.8 < 1
  CHECK(find_legs(programme({0, 200, 196})).size() == 1);                             // 2 %, and no more
  CHECK(find_legs(programme({0, 200, 195})).size() == 2);
}

TEST_CASE("limit: small cycles at the beginning count from a quarter of the minimum travel") {
  CHECK(find_legs(programme({0, 6, 2, 6, 2, 600})).size() == 5);
  CHECK(find_legs(programme({0, 6, 4, 600})).size() == 1);      // back by less than half of the previous travel
  CHECK(find_legs(programme({0, 3, 0, 600})).size() == 1);      // 0.5 %, and no more
  CHECK(find_legs(programme({0, 300, 294, 600})).size() == 1);  // later
  CHECK(find_legs(programme({600, 594, 598, 0})).size() == 3);
}

TEST_CASE("identity: a hold at the turning point turns at its first point") {
  auto stage = programme({0, 50});
  stage.insert(stage.end(), 10, 50.0);
  for (int i = 49; i >= 0; --i) stage.push_back(i);
  const auto legs = find_legs(stage);
  check_partition(legs, stage);
  REQUIRE(legs.size() == 2);
  CHECK(legs[0].last == 51);
}

TEST_CASE(
    "oracle: with noise of the stage the turning points lie where the programme without noise has them, to the noise") {
  const auto clean = programme({0, 200, 20, 400, 0});
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> noise(-1.5, 1.5);
    auto stage = clean;
    for (auto& position : stage) position += noise(generator);
    const auto legs = find_legs(stage);
    check_partition(legs, stage);
    REQUIRE(legs.size() == 4);
    const double turns[] = {200, 20, 400};
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::abs(clean[legs[i].last - 1] - turns[i]) <=
            3);  // beyond the range of the noise no point can be farther
  }
}

TEST_CASE("limit: broken contracts are named") {
  const std::vector<double> stage{0, 1, std::numeric_limits<double>::quiet_NaN()};
  CHECK_THROWS_AS(find_legs(stage), std::invalid_argument);
  CHECK_THROWS_AS(find_legs(std::vector<double>{0, 1}, {.min_travel = 0}), std::invalid_argument);
  CHECK_THROWS_AS(find_legs(std::vector<double>{0, 1}, {.min_travel = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace flexslip
