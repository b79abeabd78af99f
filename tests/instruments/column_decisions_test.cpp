#include "instruments/column_decisions.h"

#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE(
    "column decisions: a second load cell and a force of noise are found, an unrelated channel is not, by "
    "construction") {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  std::vector<double> ramp, cell, scatter, hum;
  for (int i = 0; i < 500; ++i) {
    ramp.push_back(i + 2 * noise(random));
    cell.push_back(-0.01 * i + 0.02 * noise(random));
    scatter.push_back(noise(random));
    hum.push_back(noise(random));
  }
  const auto find = [](const std::vector<double>& force, const std::vector<double>& volts) {
    const std::vector<MeasuredColumn> columns{{force, false, true}, {volts, true, false}};
    return voltage_for_force(columns);
  };
  REQUIRE(find(ramp, cell));
  CHECK(find(ramp, cell)->correlation < -0.99);
  REQUIRE(find(scatter, cell));
  CHECK(find(scatter, cell)->force_is_noise);
  CHECK_FALSE(find(ramp, hum));
  const std::vector<MeasuredColumn> alone{{cell, true, false}};
  CHECK(voltage_for_force(alone));
}
