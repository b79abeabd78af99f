// A specimen that bends straight, with noise such as readings have.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "data/record.h"

// A test in stage steps of 2 µm, with contact at `contact`, specimen stiffness 60 N/m in series with 90 N/m.
inline flexslip::Record straight_test(std::size_t points, double contact, double noise, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> stage(points), force(points);
  for (std::size_t i = 0; i < points; ++i) {
    stage[i] = 2e-6 * static_cast<double>(i);
    force[i] = std::max(0.0, stage[i] - contact) * (60.0 * 90.0 / 150.0) + noise * normal(generator);
  }
  return flexslip::record_from_stage_and_force(stage, force, 90);
}
