// A simulated test as it is told: its path point by point in the units of the case, its snaps, its legs and where the energy goes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "bending_test/history.h"
#include "case/problem.h"
#include "data/record.h"

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

// Legs of a path, in indices of its points. The way from the straight fibre to the first point belongs to the first leg.
// Domain:     as find_legs.
std::vector<Leg> legs_of(const History& history, const LegOptions& options);
std::vector<SimulatedLeg> told_legs(const Simulation& test, const LegOptions& options);

Simulation simulated(const Case& input, const History& history, const Fibre& fibre, const Scales& scales,
                     const LegOptions& options);

// Gaussian noise on the force, and so on the deflection, which an experiment infers from the force and the stage.
// Units:      deviation in those of the case, stiffness of the load train likewise. The same seed gives the same readings.
void add_noise(std::vector<SimulatedPoint>& path, double deviation, double stiffness, std::uint64_t seed);

}  // namespace flexslip
