#include "data/rounded_drops.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"

using namespace flexslip;

namespace {

constexpr int finer = 20;  // stage positions a row

// A specimen that snaps from crest to crest, run forward finely; the force follows as behind a low-pass, and noise is added where it is read.
Record slipping(double lag, double noise, unsigned seed) {
  const auto of = [&](unsigned from, double least, double most) {
    return least + (most - least) * std::fmod(from * std::numbers::phi, 1);
  };
  const double wavelength = of(seed, 9, 16) / 1278, mean = of(seed + 50, 0.3, 0.8);
  constexpr double stiffness = 60, step = 2.0 / 1278;
  std::vector<double> stages;
  for (int i = 1; i < 280 * finer; ++i) stages.push_back(i * step / finer);
  const auto history = follow_in_steps({Friction::sinusoid(mean, 0.2, wavelength, 1), {stiffness}}, stages);
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal(0, noise);
  Record record;
  double force = 0;
  const double follows = lag > 0 ? 1 - std::exp(-1 / (lag * finer)) : 1;
  for (std::size_t i = 0; i < history.path.size(); ++i) {
    force += follows * (history.path[i].F - force);
    if (i % finer != finer - 1) continue;
    record.stage.push_back(history.path[i].stage);
    record.force.push_back(force + normal(engine));
    record.deflection.push_back(record.stage.back() - record.force.back() / stiffness);
  }
  return record;
}

TEST_CASE("rounded drops: a low-pass is detected, with its lag, and sharp drops are not (simulation)") {
  struct Row {
    double lag;        // [rows]
    int fewest, most;  // detected, of 30 tests
  };
  for (const auto& [lag, fewest, most] : {Row{0, 0, 1}, Row{1, 10, 30}, Row{2, 20, 30}}) {
    CAPTURE(lag);
    int told = 0;
    double lags = 0;
    constexpr int tests = 30;
    for (unsigned seed = 1; seed <= tests; ++seed) {
      const RoundedDrops found = rounded_drops(slipping(lag, 0.01, seed));
      told += found.lag > 0;
      lags += found.lag;
    }
    REQUIRE(told >= fewest);
    CHECK(told <= most);
    if (lag > 0) CHECK(lags / told == doctest::Approx(lag).epsilon(0.4));  // from few drops
  }
}

// A symmetric filter with triangular weights over this many rows on either side.
Record smoothed(Record record, int beside) {
  const std::vector<double> force = record.force;
  const int rows = static_cast<int>(force.size());
  for (int i = beside; i + beside < rows; ++i) {
    double sum = 0, weights = 0;
    for (int k = -beside; k <= beside; ++k) {
      const double weight = beside + 1 - std::abs(k);
      sum += weight * force[static_cast<std::size_t>(i + k)];
      weights += weight;
    }
    record.force[static_cast<std::size_t>(i)] = sum / weights;
  }
  return record;
}

TEST_CASE("rounded drops: a symmetric filter is detected, and sharp drops are not (simulation)") {
  struct Row {
    int beside;
    double lag;
    int fewest, most;  // detected, of 30 tests
  };
  for (const auto& [beside, lag, fewest, most] :
       {Row{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 2, 0, 1}, {1, 0, 25, 30}, {2, 0, 25, 30}, {3, 0, 25, 30}}) {
    CAPTURE(beside);
    CAPTURE(lag);
    int told = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
      const RoundedDrops found = rounded_drops(smoothed(slipping(lag, 0.01, seed), beside));
      told += found.spread > 0;
      if (beside > 0) CHECK(found.lag == 0);
    }
    CHECK(told >= fewest);
    CHECK(told <= most);
  }
}

TEST_CASE("rounded drops: a record without drops, or with too few rows, has none (limit)") {
  Record few = slipping(2, 0.01, 3);
  CHECK(rounded_drops(few).drops >= 3);
  for (auto* column : {&few.stage, &few.deflection, &few.force}) column->resize(29);
  CHECK(rounded_drops(few).drops == 0);
  Record smooth = slipping(0, 0, 3);
  for (std::size_t i = 0; i < smooth.force.size(); ++i) smooth.force[i] = 40 * smooth.stage[i];
  CHECK(rounded_drops(smooth).drops == 0);
}

}  // namespace
