// The simulation of the test that a case describes, and remarks on it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bending_test/history.h"
#include "case/case_file.h"
#include "case/mechanics.h"
#include "data/record.h"
#include "data/scales.h"

namespace flexslip {

// A point of a path, in the units of the case.
struct SimulatedPoint {
  double stage, deflection, force;
  double length;  // of the axis between the contacts
  double q;       // [1]
  std::string_view motion;
  double drawn_in, imaged;
  double strain = 0, stress = 0;  // of the surface at midspan
  double left = 0, right = 0;     // sliding length over each support
  EnergyAccount energy{};         // [EI/L] from the start of the test
};

// The part of a path between two turns of the stage.
struct SimulatedLeg {
  Direction direction;
  double from, to;          // stage positions, in the units of the case
  EnergyAccount change;     // [EI/L] the last leg up to the end of the test, possibly beyond the last point
  double work_of_fracture;  // [EI/L] up to the end of the test too
};

struct Simulation {
  std::string_view status;
  std::vector<SimulatedPoint> path;
  std::vector<Snap> snaps;
  std::vector<CrackOpened> cracks;
  std::optional<double> wraps_nose_from;  // [L] stage position
  std::vector<SimulatedLeg> legs;
  EnergyAccount energy{};  // at the end
  // Flags for numbers of the points: false if a number does not exist or duplicates another.
  bool has_surface, has_three_lengths, has_two_sides;
};

Simulation simulated(const Test& input, const History& history, const Fibre& fibre, const Scales& scales,
                     const LegOptions& options);

struct SimulationOptions {
  int points = 200;        // on each segment of sticking or sliding of a continuous stage; at least 2
  double noise = 0;        // [N] standard deviation of force readings, in the units of the case
  std::uint64_t seed = 1;  // of the noise
  HistoryProgress progress = {};
};

// The simulated path, the input of figures.
struct FollowedTest {
  BendingTest bending_test;
  History history;
  std::vector<double> stages;  // [L] stage positions of turns and rests
  bool in_steps;
  LegOptions legs;
};

struct SimulatedTest {
  bool reduced, in_inches;  // as the case
  Scales scales;
  Simulation simulation;
  FollowedTest followed;
  std::vector<std::string> remarks;  // sentences
  std::string why_it_ends;           // the reason for an early end; "" if the programme was completed
};

// `farthest` [L]: friction is prepared up to this stage position, which figures may need beyond the
// programme.
// Fails:      InputError as bending_test_of; for a path of more than a gigabyte.
SimulatedTest simulate(const Test& input, const SimulationOptions& options, double farthest = 0);

// The test for figures: a stage in steps is also shown between its readings.
struct SimulatedPortrait {
  History history;
  std::vector<Leg> legs;  // of its path
  SlidingLimits limits;
};
SimulatedPortrait portrait_of(const SimulatedTest& test, const std::vector<Crack>& cracks);

// All its equilibria at some stage positions [L].
OverallPortrait overall_portrait(const SimulatedTest& test, std::span<const double> stages);

}  // namespace flexslip
