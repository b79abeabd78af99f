// Friction with a sawtooth, and its drops as they stand in a record without noise.
#pragma once

#include <cstddef>
#include <vector>

#include "data/drops.h"
#include "tests/inference/simulated_test.h"

namespace flexslip {

inline constexpr double tooth_wavelength = 12.0 / 1278;  // [L]

inline Friction toothed() { return Friction::sinusoid(0.6, 0.3, tooth_wavelength, 1.0); }

inline Drop drop_between(std::size_t before, std::size_t after) { return {before, after, 0, 0, 0}; }

inline std::vector<Drop> plain_drops(const ReducedRecord& record) {
  std::vector<Drop> drops;
  for (std::size_t i = 1; i < record.force.size(); ++i)
    if (record.force[i] < record.force[i - 1] - 0.05) drops.push_back(drop_between(i - 1, i));
  return drops;
}

}  // namespace flexslip
