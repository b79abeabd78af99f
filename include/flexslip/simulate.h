// Simulated tests: what a stage that moves in steps would record.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "flexslip/test.h"

namespace flexslip::v1 {

// The positions between which the stage moves, in steps. The test begins at 0 with the straight specimen.
// Domain:     at least two positions from 0 to 100 spans; step > 0, at most 1e7 steps; force_noise >= 0.
struct Programme {
  std::vector<double> stages;  // [m] turning points: {0, 700e-6, 0} loads and unloads
  double step;                 // [m] between two readings
  double force_noise = 0;      // [N] standard deviation of a reading
  std::uint64_t seed = 1;      // of the noise; the same seed gives the same readings
};

// One reading.
struct PathPoint {
  double stage, deflection;  // [m]
  double force;              // [N]
  double length;             // [m] of the axis between the contacts
  double friction;           // [1] mobilised
  std::string_view motion;   // since the last reading: stick, slip_in, slip_out, snap, apart (from the nose)
};

// A sudden slip at constant stage position.
struct Snap {
  double stage;                                // [m]
  double deflection_before, deflection_after;  // [m]
  double force_before, force_after;            // [N]
  double pulled_in;                            // [m] of length between the supports
  double friction;                             // [J] heat at the supports
  double released;                             // [J] beyond the heat of friction: noise, vibration
};

// [J] The energies from the start to the end of the test. The stage's work is the sum of the others.
struct Energies {
  double stage_work;        // ∫ F d(stage)
  double bending;           // in the specimen
  double load_train;        // in the load train
  double friction;          // heat at the supports
  double snaps;             // released in snaps beyond friction
  double work_of_fracture;  // ∫ F d(deflection)
};

struct Simulation {
  std::vector<PathPoint> path;
  std::vector<Snap> snaps;
  Energies energies;
  std::string why_it_ends;  // the reason for an early end, a sentence; empty if the programme was completed
};

// Simulates a test.
// Domain:     a setup with a span, a load train and a bending stiffness.
// Max error:  the rounding of the stage position, for events; the energies close to 1e-10 of the largest,
//             less well after a reversal where the specimen is nearly straight.
// Fails:      Error for an input outside the domains. A specimen that slips through the supports ends the path.
// Cost:       a few µs for each reading.
Simulation simulate(const Setup& setup, const Friction& friction, const Programme& programme);

}  // namespace flexslip::v1
