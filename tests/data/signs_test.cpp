#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "data/record.h"

using namespace flexslip;

namespace {

struct Curve {
  std::vector<double> displacement, force;
};

// Rows before the contact, a rise, a break and what follows it, with noise on both.
Curve broken_test(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1);
  Curve curve;
  for (int i = 0; i < 400; ++i) {
    const double way = 0.01 * i - 0.5;
    const double rise = way < 0 || i > 320 ? 0 : way < 2 ? 5 * way : 10 - way;
    curve.displacement.push_back(way + 0.0005 * noise(random));
    curve.force.push_back(rise + 0.05 * noise(random));
  }
  return curve;
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

bool found(const Curve& curve, int displacement, int force) {
  const Signs signs = find_signs(times(curve.displacement, displacement), times(curve.force, force));
  return signs.displacement == displacement && signs.force == force;
}

}  // namespace

TEST_CASE("signs: each of the four conventions of a simulated test is found (truth)") {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Curve curve = broken_test(seed);
    for (const int displacement : {1, -1})
      for (const int force : {1, -1}) CHECK(found(curve, displacement, force));
  }
}

TEST_CASE("signs: load, unload, reload, and a record that begins by unloading (truth)") {
  Curve curve;
  for (const double x : {0.0, 1.0, 2.0, 3.0, 2.0, 1.0, 2.0, 3.0, 4.0}) {
    curve.displacement.push_back(x);
    curve.force.push_back(2 * x);
  }
  for (const int displacement : {1, -1})
    for (const int force : {1, -1}) CHECK(found(curve, displacement, force));

  const Curve unloading{{5, 4, 3, 2, 1}, {10, 8, 6, 4, 2}};
  CHECK(found(unloading, 1, 1));
  CHECK(found(unloading, -1, -1));
}

TEST_CASE("signs: one or two readings turn none, nor does a way back of the stage before the test (truth)") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Curve curve = broken_test(seed);
    for (const std::size_t at : {std::size_t{10}, curve.force.size() / 2, curve.force.size() - 3}) {
      Curve spiked = curve;
      spiked.force[at] = spiked.force[at + 1] = -999;
      CHECK(found(spiked, 1, 1));
      CHECK(found(spiked, -1, -1));
    }
    const double farthest = curve.displacement.back(), first = curve.displacement.front(),
                 at_first = curve.force.front();
    std::vector<double> back, free;
    for (int i = 0; i < 50; ++i) {
      back.push_back(first + 2 * (farthest - first) * (50 - i) / 50);
      free.push_back(at_first - 1e-6 * (50 - i));
    }
    curve.displacement.insert(curve.displacement.begin(), back.begin(), back.end());
    curve.force.insert(curve.force.begin(), free.begin(), free.end());
    CHECK(found(curve, 1, 1));
    CHECK(found(curve, 1, -1));
  }
}

TEST_CASE("signs: where the displacement counts from makes no difference (identity)") {
  Curve curve = broken_test(7);
  for (double& x : curve.displacement) x -= 1000;
  CHECK(found(curve, 1, 1));
  CHECK(found(curve, -1, -1));
}

TEST_CASE("signs: constant columns keep their sign (limit)") {
  const Signs still = find_signs(std::vector<double>{1, 1, 1}, std::vector<double>{0, 0, 0});
  CHECK(still.displacement == 1);
  CHECK(still.force == 1);
  CHECK(find_signs({}, {}).force == 1);
  CHECK_THROWS_AS(find_signs(std::vector<double>{1, 2}, std::vector<double>{1}), std::invalid_argument);
}
