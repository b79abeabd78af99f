// Random tests with random programmes, for properties and oracles.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "bending_test/history.h"

namespace flexslip {

struct SomeProgramme {
  BendingTest test;
  std::vector<double> turning_points;
  double roughness;  // [L] wavelength or correlation length
};

// A sinusoidal or a rough friction, a rig from soft to displacement control, three to eight turning points up to `farthest`.
inline SomeProgramme some_programme(std::mt19937_64& random, double farthest, double min_wavelength) {
  const auto draw = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const double length = min_wavelength * std::exp(draw(0, 2));
  const double mu0 = draw(0.05, 0.9);
  const bool rough = draw(0, 1) < 0.3;
  const Friction friction = rough ? Friction::rough(mu0, draw(0, 0.5), length, random(), longest_at_stage(farthest))
                                  : Friction::sinusoid(mu0, draw(0, 0.9), length, draw(0, 2 * std::numbers::pi));
  const double k =
      draw(0, 1) < 0.1 ? std::numeric_limits<double>::infinity() : std::exp(draw(std::log(8), std::log(500)));
  std::vector<double> points{draw(0.3, 1) * farthest};
  const int more = static_cast<int>(draw(2, 8));
  for (int i = 0; i < more; ++i) points.push_back(draw(0.02, 1) * farthest);
  return {{friction, {k}}, points, length};
}

}  // namespace flexslip
