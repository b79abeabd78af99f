// What `simulate` tells, described once.
#pragma once

#include "case/simulated_test.h"
#include "result/fields.h"

namespace flexslip {

// Which fields of a point are told.
struct PathColumns {
  bool surface, three_lengths, two_sides, energies;
};
inline constexpr PathColumns all_columns{true, true, true, true};

// Those that a test has.
inline PathColumns columns_of(const Simulation& test, bool energies) {
  return {test.has_surface, test.has_three_lengths, test.has_two_sides, energies};
}

Fields<SimulatedPoint> path_fields(const PathColumns& columns);

// Of `simulate --json`.
Fields<Simulation> simulation_fields(const PathColumns& columns);

}  // namespace flexslip
