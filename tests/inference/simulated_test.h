// A test made by the model itself, with known truth: what the inference is judged by.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "bending_test/history.h"
#include "data/record.h"
#include "inference/sliding_ladder.h"

namespace flexslip {

struct SimulatedTruth {
  Friction friction;
  double stiffness = 90;     // [EI/L^3] nominal
  double stiffening = 1;     // [1] true over nominal bending stiffness
  double noise = 0;          // [EI/L^2]
  double step = 2.0 / 1278;  // [L] of the stage
  double deflection = 0.4;   // [L] at which the test ends
  std::uint64_t seed = 1;
};

inline ReducedRecord simulated_record(const SimulatedTruth& truth) {
  std::mt19937_64 generator(truth.seed);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); };
  std::vector<double> stages;
  for (int i = 1; i * truth.step < 1.6 * truth.deflection + 0.3; ++i) stages.push_back(i * truth.step);
  const auto history = follow_in_steps({truth.friction, {truth.stiffness / truth.stiffening}}, stages);
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

// Constant friction, and a bending stiffness that at some deflections falls to what is left of it: each loss is a drop along the load line.
struct Crack {
  double deflection, left;  // [L], [1]
};
inline ReducedRecord cracked_record(const SimulatedTruth& truth, const std::vector<Crack>& cracks) {
  std::mt19937_64 generator(truth.seed);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); };
  const SlidingLadder ladder(1.58, 5e-4);
  const auto curve = ladder.curve(truth.friction.at(ladder.lengths()).mu);
  ReducedRecord record;
  std::size_t cracked = 0;
  for (int i = 1;; ++i) {
    const double stage = i * truth.step;
    double force = 0, deflection = 0;
    for (bool settled = false; !settled;) {
      const double stiffness = truth.stiffening * (cracked > 0 ? cracks[cracked - 1].left : 1);
      const std::vector<double> stages{stage};
      force = stiffness * measured_curve(curve.w, curve.F, stiffness / truth.stiffness, stages).F[0];
      deflection = stage - force / truth.stiffness;
      settled = cracked == cracks.size() || deflection < cracks[cracked].deflection;
      if (!settled) ++cracked;
    }
    if (deflection > truth.deflection) return record;
    force += truth.noise * normal();
    record.stage.push_back(stage);
    record.force.push_back(force);
    record.deflection.push_back(stage - force / truth.stiffness);
  }
}

}  // namespace flexslip
