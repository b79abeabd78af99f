// The test that a case describes, computed forward: what it would measure, and what there is to say of that.
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

// A point of a path. Units: those of the case.
struct SimulatedPoint {
  double stage, deflection, force;
  double length;  // of the axis between the contacts
  double q;       // [1]
  std::string_view motion;
  double drawn_in, imaged;
  double strain = 0, stress = 0;  // of the surface at midspan
  double left = 0, right = 0;     // drawn in over each support
  EnergyAccount energy{};         // [EI/L] from the start of the test
};

// From a turn of the stage to the next.
struct SimulatedLeg {
  Direction direction;
  double from, to;          // stage positions, in the units of the case
  EnergyAccount change;     // [EI/L] the last up to the end of the test, which may be beyond the last point
  double work_of_fracture;  // [EI/L] likewise
};

struct Simulation {
  std::string_view status;
  std::vector<SimulatedPoint> path;
  std::vector<Snap> snaps;
  std::vector<CrackOpened> cracks;
  std::optional<double> wraps_nose_from;  // [L] stage position
  std::vector<SimulatedLeg> legs;
  EnergyAccount energy{};  // at the end
  // Which numbers of the points are told: those that are not are told by others, or do not exist.
  bool has_surface, has_three_lengths, has_two_sides;
};

Simulation simulated(const Test& input, const History& history, const Fibre& fibre, const Scales& scales,
                     const LegOptions& options);

struct SimulationOptions {
  int points = 200;        // on each stretch of sticking or sliding, where the stage moves continuously; at least 2
  double noise = 0;        // [N] standard deviation of the force readings, in the units of the case
  std::uint64_t seed = 1;  // of the noise
  HistoryProgress progress = {};
};

// What was followed: what figures are drawn of.
struct FollowedTest {
  BendingTest bending_test;
  History history;
  std::vector<double> stages;  // [L] between which the stage moved, or at which it stood
  bool in_steps;
  LegOptions legs;
};

struct SimulatedTest {
  bool reduced, in_inches;  // as the case
  Scales scales;
  Simulation simulation;
  FollowedTest followed;
  std::vector<std::string> remarks;  // sentences
  std::string why_it_ends;           // before its programme does; "" if it does not
};

// Friction is made ready for stage positions up to `farthest` [L], of which figures may ask beyond the programme.
// Fails:      InputError as bending_test_of; for a path that does not fit into a gigabyte.
SimulatedTest simulate(const Test& input, const SimulationOptions& options, double farthest = 0);

// The test as a picture shows it: of a stage in steps also between its readings.
struct SimulatedPortrait {
  History history;
  std::vector<Leg> legs;  // of its path
  SlidingLimits limits;
};
SimulatedPortrait portrait_of(const SimulatedTest& test, const std::vector<Crack>& cracks);

// Its overall equilibria at some stage positions [L].
OverallPortrait overall_portrait(const SimulatedTest& test, std::span<const double> stages);

}  // namespace flexslip
