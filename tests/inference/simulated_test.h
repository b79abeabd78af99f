// A test made by the model itself, with known truth: what the inference is judged by.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "bending_test/history.h"
#include "data/record.h"
#include "data/scales.h"
#include "inference/fit.h"

namespace flexslip {

// They leave 0.6 of the bending stiffness.
inline const std::vector<Crack> six_cracks{{0.12, 0.06},           {0.17, 1 - 0.88 / 0.94}, {0.21, 1 - 0.8 / 0.88},
                                           {0.26, 1 - 0.74 / 0.8}, {0.31, 1 - 0.66 / 0.74}, {0.35, 1 - 0.6 / 0.66}};

// Span and bending stiffness of a spicule.
inline const Scales scales(1278e-6, 1.02 * 1278e-6 * 1278e-6 * 1278e-6);

// Of a rig that is as stated.
inline constexpr RigErrors none_off{
    .load_train = 0, .span = 0, .force_gain = 0, .thickness = 0, .support_radius = 0, .preload = 0, .slow_force = 0};

struct SimulatedTruth {
  Friction friction;
  double stiffness = 90;     // [EI/L^3] nominal
  double stiffening = 1;     // [1] true over nominal bending stiffness
  double noise = 0;          // [EI/L^2]
  double step = 2.0 / 1278;  // [L] of the stage
  double deflection = 0.4;   // [L] at which the test ends
  std::uint64_t seed = 1;
  Fibre fibre{};  // on its supports
  SnapRest rest = SnapRest::nearest_stable;
};

inline ReducedRecord simulated_record(const SimulatedTruth& truth, const std::vector<Crack>& cracks = {}) {
  std::mt19937_64 generator(truth.seed);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); };
  std::vector<double> stages;
  for (int i = 1; i * truth.step < 1.6 * truth.deflection + 0.3; ++i) stages.push_back(i * truth.step);
  const auto history =
      follow_in_steps({truth.friction, {truth.stiffness / truth.stiffening, truth.fibre}, truth.rest}, stages, cracks);
  ReducedRecord record;
  for (const auto& point : history.path) {
    if (point.w > truth.deflection) break;
    const double force = point.F * truth.stiffening + truth.noise * normal();
    record.stage.push_back(point.stage);
    record.force.push_back(force);
    record.deflection.push_back(point.stage - force / truth.stiffness);
  }
  return record;
}

}  // namespace flexslip
