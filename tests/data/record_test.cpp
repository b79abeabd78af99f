#include "data/record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "numerics/elementary.h"
#include "tests/data/straight_test.h"

using namespace flexslip;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST_CASE("record: any two columns and the stiffness give the third (identity)") {
  const std::vector<double> stage{0, 2e-6, 4e-6}, deflection{0, 1e-6, 2.5e-6}, force{0, 9e-5, 1.35e-4};
  const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::abs(a[i] - b[i]) > 4 * std::numeric_limits<double>::epsilon() * std::abs(b[i]))
        return false;  // 3 roundings
    return a.size() == b.size();
  };
  for (const Record& record :
       {record_from_stage_and_force(stage, force, 90), record_from_deflection_and_force(deflection, force, 90),
        record_from_stage_and_deflection(stage, deflection, 90)}) {
    CHECK(same(record.stage, stage));
    CHECK(same(record.deflection, deflection));
    CHECK(same(record.force, force));
  }
}

TEST_CASE("record: under displacement control stage and deflection are one (limit)") {
  const std::vector<double> x{0, 1, 2}, force{0, 3, 5};
  CHECK(record_from_stage_and_force(x, force, infinity).deflection == x);
  CHECK(record_from_deflection_and_force(x, force, infinity).stage == x);
  CHECK_THROWS_AS(record_from_stage_and_deflection(x, x, infinity), std::invalid_argument);
}

TEST_CASE("record: columns of two lengths and stiffnesses that are none are refused (contract)") {
  const std::vector<double> two{0, 1}, three{0, 1, 2};
  CHECK_THROWS_WITH(record_from_stage_and_force(two, three, 90), "columns of 2 and 3 points");
  for (const double bad : {0.0, -90.0, nan})
    CHECK_THROWS_AS(record_from_stage_and_force(two, two, bad), std::invalid_argument);
  CHECK_THROWS_WITH(record_from_stage_and_force(two, two, -90), "load-train stiffness = -90 N/m is not positive");
}

TEST_CASE(
    "record: columns of two lengths and readings that are no numbers are refused by all that ask for readings "
    "(contract)") {
  CHECK_NOTHROW(require_readings(Record{{0, 1}, {0, 1}, {0, 1}}));
  CHECK_NOTHROW(require_readings(ReducedRecord{}));
  CHECK_THROWS_AS(require_readings(Record{{0, 1}, {0}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(require_readings(Record{{0}, {0, 1}, {0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS(require_readings(ReducedRecord{{0, 1}, {0, nan}, {0, 1}}), std::invalid_argument);
}

TEST_CASE("record: each fault is found, with its place (table)") {
  const Record good{{0, 1, 1, 2}, {0, 1, 1, 2}, {0, 1, 2, 3}};
  CHECK(check_record(good).fault == RecordFault::none);
  CHECK(check_record({}).fault == RecordFault::none);

  Record shorter = good;
  shorter.force.pop_back();
  CHECK(check_record(shorter).fault == RecordFault::lengths_differ);
  CHECK(check_record(shorter).index == 3);

  for (const double bad : {nan, infinity, -infinity}) {
    Record broken = good;
    broken.deflection[2] = bad;
    CHECK(check_record(broken).fault == RecordFault::not_finite);
    CHECK(check_record(broken).index == 2);
  }

  Record backwards = good;
  backwards.stage[3] = 0.5;
  CHECK(check_record(backwards).fault == RecordFault::stage_runs_back);
  CHECK(check_record(backwards).index == 3);
}

TEST_CASE("record: a parabola is its own smooth course, to its ends (identity)") {
  Record record = straight_test(100, 0, 0, 1);
  for (std::size_t i = 0; i < 100; ++i) record.force[i] = 1e3 * record.stage[i] * (1.5e-4 - record.stage[i]);
  const auto smooth = smooth_steps(record);
  REQUIRE(smooth.size() == 99);
  for (std::size_t i = 0; i < 99; ++i)
    CHECK(std::abs(smooth[i] - (record.force[i + 1] - record.force[i])) < 1e-18);  // steps are 1e-7 N, rounded at 1e-21
}

TEST_CASE("record: smooth steps of uneven, noisy readings are medians sought by trying each slope (oracle)") {
  constexpr std::size_t n = 130, half = 10;  // steps, and those either side of a window
  std::mt19937_64 random(20210829);
  std::uniform_real_distribution<double> part(0, 1);
  Record record{{0}, {0}, {0}};
  for (std::size_t i = 0; i < n; ++i) {
    record.stage.push_back(record.stage.back() +
                           1e-6 * (i % 9 == 4 ? 0 : part(random)));  // a stage that rests now and then
    record.deflection.push_back(record.stage.back());
    record.force.push_back(900 * record.stage.back() - 2e6 * record.stage.back() * record.stage.back() +
                           2e-4 * part(random));
  }
  const auto travel = [&](std::size_t i) { return record.stage[i + 1] - record.stage[i]; };
  const auto middle_slope = [&](std::size_t centre, double bend) {
    const auto slope = [&](std::size_t i) {
      const double own = travel(i) == 0 ? 0 : (record.force[i + 1] - record.force[i]) / travel(i);
      return own - bend * (static_cast<double>(i) - static_cast<double>(centre));
    };
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t at = centre - half; at <= centre + half; ++at) {
      double loss = 0;
      for (std::size_t i = centre - half; i <= centre + half; ++i) loss += travel(i) * std::abs(slope(i) - slope(at));
      if (loss < least) least = loss, best = slope(at);
    }
    return best;
  };
  const std::size_t tail = n - 1 - half;
  const auto smooth = smooth_steps(record);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t centre = std::clamp(i, half, tail);
    const std::size_t from = centre - std::min(half, centre - half), to = std::min(centre + half, tail);
    const double bend = (middle_slope(to, 0) - middle_slope(from, 0)) / static_cast<double>(to - from);
    const double ahead = static_cast<double>(i) - static_cast<double>(centre);
    const double expected = (middle_slope(centre, bend) + bend * ahead) * travel(i);
    CHECK(std::abs(smooth[i] - expected) <= 1e-12 * std::abs(expected));
  }
}

TEST_CASE("record: ten drops in a window leave its smooth course on the curve (limit)") {
  Record record = straight_test(101, 0, 0, 1);
  const double step = record.force[1] - record.force[0];
  double lost = 0;
  for (std::size_t i = 1; i < 101; ++i) {
    if (i % 2 == 0 && i >= 40 && i < 60) lost += 5 * step;
    record.force[i] -= lost;
  }
  for (const double smooth : smooth_steps(record)) CHECK(smooth == doctest::Approx(step));
}

TEST_CASE("record: the noise is the one put in, with and without drops (simulation)") {
  const int tests = 200;
  double plain = 0, dropping = 0;
  for (int seed = 0; seed < tests; ++seed) {
    Record record = straight_test(260, 0, 4e-6, static_cast<unsigned>(seed));
    plain += force_noise(record) / tests;
    for (std::size_t i = 130; i < 260; ++i) record.force[i] -= 3e-4 * static_cast<double>((i - 130) / 5 + 1);
    dropping += force_noise(record) / tests;
  }
  CHECK(plain ==
        doctest::Approx(4e-6).scale(0).epsilon(0.04 + 0.03));  // the promised 4 %, and three deviations: 12 %/√200
  CHECK(dropping == doctest::Approx(4e-6).scale(0).epsilon(0.15));  // half as many windows to choose from
}

TEST_CASE("record: noise is never below the resolution, and zero only without noise (limit)") {
  Record record = straight_test(200, 0, 0, 1);
  CHECK(force_noise(record) < 1e-15);  // rounding of forces of 0.01 N
  for (double& F : record.force) F = 1e-4 * std::round(F / 1e-4);
  CHECK(force_noise(record) >= 0.99 * 1e-4 / std::sqrt(12.0));  // the deviation of one rounding
  record.force.assign(200, 0.5);
  CHECK(force_noise(record) == 0);
  CHECK_THROWS_AS(force_noise(straight_test(10, 0, 0, 1)), std::invalid_argument);
}

TEST_CASE("record: readings in steps have their resolution, whether two are alike or not (limit)") {
  std::vector<double> rising, alike{0, 0.3, 0.3, 0.7};
  for (int i = 0; i < 100; ++i)
    rising.push_back(0.1 * (10 * i + (i % 3 == 0 ? 0 : 2 + i % 3)));  // 1.3, 1.1 and 0.6 apart
  CHECK(resolution_of(rising) == doctest::Approx(0.1));
  CHECK(resolution_of(alike) == doctest::Approx(0.3));
  for (std::size_t i = 0; i < rising.size(); ++i) rising[i] += 0.01 * std::sin(static_cast<double>(i));
  CHECK(resolution_of(rising) == 0);
}

TEST_CASE("record: a load cell that sleeps before contact does not hide the noise (limit)") {
  Record record = straight_test(300, 0, 4e-6, 3);
  const double awake = force_noise(record);
  for (std::size_t i = 0; i < 100; ++i) record.force[i] = 0;
  CHECK(force_noise(record) > 0.6 * awake);  // 12 % scatter of each, and fewer windows; without care it would be 0
}

}  // namespace
