#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "data/contact.h"
#include "tests/data/straight_test.h"

using namespace flexslip;

namespace {

struct Curve {
  std::vector<double> displacement, force;
};

constexpr double noise = 0.1;  // [N]

// `free_rows` before the contact; then a toe that settles over ten rows, and a straight rise of 0.25 N a row.
Curve loading(int free_rows, double offset, double correlation, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> unit(0, 1);
  Curve curve;
  double error = noise * unit(random);
  for (int i = 0; i < free_rows + 300; ++i) {
    const double way = i - free_rows;
    const double rise = way < 0 ? 0 : way < 10 ? 0.0125 * way * way : 0.25 * (way - 5);
    curve.displacement.push_back(0.001 * i);
    curve.force.push_back(offset + rise + error);
    error = correlation * error + std::sqrt(1 - correlation * correlation) * noise * unit(random);
  }
  return curve;
}

ForceZero zero_of(const Curve& curve) { return find_force_zero(curve.displacement, curve.force, noise); }

}  // namespace

TEST_CASE("force_zero: the offset of simulated tests within its error (truth)") {
  for (const double correlation : {0.0, 0.4}) {
    const int tests = 400;
    int found = 0, covered = 0;
    double bias = 0;
    for (unsigned seed = 1; seed <= tests; ++seed) {
      const ForceZero zero = zero_of(loading(80, -3.7, correlation, seed));
      if (zero.status != ForceZeroStatus::found) continue;
      ++found;
      bias += (zero.offset + 3.7) / noise;
      covered += std::abs(zero.offset + 3.7) < 1.96 * zero.error;
    }
    CAPTURE(correlation);
    CAPTURE(found);
    CAPTURE(covered);
    CHECK(found >= tests * 95 / 100);
    CHECK(covered >= found * 90 / 100);    // of nominal 95: about twenty rows determine their autocorrelation poorly
    CHECK(std::abs(bias / found) < 0.05);  // [noise] the standard error of 400 means of 20 rows or more is 0.02
  }
}

TEST_CASE("force_zero: an offset is significant, noise about zero is not (truth)") {
  int significant = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    CHECK(is_significant(zero_of(loading(80, 0.5, 0, seed))));
    significant += is_significant(zero_of(loading(80, 0, 0, seed)));
  }
  CHECK(significant <= 2);  // four standard errors: 0.03 of 400 in the mean, and the errors are estimates
}

TEST_CASE("force_zero: a record that begins in contact has none, for any preload (limit)") {
  for (unsigned seed = 1; seed <= 100; ++seed)
    for (const double preload : {0.0, 2.0}) {
      Curve curve = loading(0, preload, 0, seed);
      const auto from = curve.force.begin() + 10;  // past the toe
      curve.force.erase(curve.force.begin(), from);
      curve.displacement.erase(curve.displacement.begin(), curve.displacement.begin() + 10);
      CHECK(zero_of(curve).status == ForceZeroStatus::no_free_rows);
    }
}

TEST_CASE("force_zero: a stationary stage in contact gives no zero (limit)") {
  Curve curve;
  for (int i = 0; i < 300; ++i) {
    curve.displacement.push_back(i < 40 ? 0 : 0.001 * (i - 40));
    curve.force.push_back(2.5 + (i < 40 ? 0 : 0.25 * (i - 40)));
  }
  CHECK(zero_of(curve).status == ForceZeroStatus::no_free_rows);
}

TEST_CASE("force_zero: a force that never rises, and too few rows (limit)") {
  CHECK(zero_of({std::vector<double>(200, 1), std::vector<double>(200, 0.3)}).status == ForceZeroStatus::no_free_rows);
  CHECK(zero_of({{0, 1, 2}, {0, 0, 5}}).status == ForceZeroStatus::no_free_rows);
  CHECK(zero_of({}).status == ForceZeroStatus::no_free_rows);
}

TEST_CASE("baseline: a force that drifts or settles before contact is found and extrapolated (truth known)") {
  constexpr double white = 1e-5;  // [N]
  const auto with = [](auto baseline, unsigned seed) {
    const Record record = straight_test(500, 300e-6, white, seed);
    std::vector<double> force = record.force;
    for (std::size_t i = 0; i < force.size(); ++i) force[i] += baseline(record.stage[i]);
    return find_baseline(record.stage, force);
  };
  int told = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    told += with([](double) { return 1e-4; }, seed).points > 0;
    const Baseline drift = with([](double x) { return 0.2e-3 * x / 300e-6; }, seed);
    REQUIRE(drift.points > 100);
    CHECK(drift.points <= 150);
    CHECK(drift.settles_by == 0);
    CHECK(std::abs(drift.at(300e-6) - 0.2e-3) < 4 * drift.error);
    const auto settling = [](double x) { return 0.3e-3 * std::exp(-x / 80e-6); };
    const Baseline settles = with(settling, seed);
    REQUIRE(settles.points > 100);
    CHECK(settles.settles_by != 0);
    // The decay length comes from a grid of powers of two, wrong by up to 1.4 times: an error of 0.1 of the remainder at
    // contact, or 0.05 of the amplitude.
    CHECK(std::abs(settles.at(300e-6) - settling(300e-6)) < 0.05 * 0.3e-3);
  }
  CHECK(told == 0);  // six of its errors
  CHECK(find_baseline(std::vector<double>(20, 0.0), std::vector<double>(20, 0.0)).points == 0);
}

TEST_CASE("force_zero: what is broken is refused (contract)") {
  CHECK_THROWS_AS(find_force_zero(std::vector<double>{1, 2}, std::vector<double>{1}, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(find_force_zero(std::vector<double>{1}, std::vector<double>{1}, -0.1), std::invalid_argument);
}
