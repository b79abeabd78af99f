// What a test measures: the path of states through a programme of stage positions, with its snaps and its energy account.
//
// The state of the test is (S, q) and the stage position. This file follows loading, in which the fibre slides in along
// q = μ(S) and the measured state is the running maximum of G (rig.h). A path is a list of points that say how the fibre
// moved to reach them, so sticking and sliding out are further kinds of motion in the same list.
#pragma once

#include <span>
#include <vector>

#include "bending_test/rig.h"
#include "contact/friction.h"

namespace flexslip {

enum class Motion { stick, slip_in, slip_out, snap };

struct PathPoint {
  double stage;   // [L]
  double w;       // [L]
  double F;       // [EI/L^2]
  double S;       // [L]
  double q;       // [1]
  Motion motion;  // by which the fibre came to this point from the one before
};

// A jump at constant stage position: in (w, F) a line of slope -k.
struct Snap {
  double stage;  // [L]
  PathPoint before, after;
};

// Energies in EI/L, accumulated from the start to the end of the path.
struct EnergyAccount {
  double stage_work;  // ∫ F d(stage)
  double bending;     // change of the bending energy
  double load_train;  // change of F^2/(2k)
  double friction;    // ∫ q P_n dS, in sliding and along the way of each snap
  double snaps;       // what the snaps set free beyond friction: noise, vibration
  double imbalance;   // stage_work less the sum of the others; zero but for rounding and quadrature
};

enum class HistoryStatus {
  ok,
  slipped_through,  // a stage position exceeds every equilibrium traced: the fibre slips through the supports. The path
                    // holds the points before.
};

struct History {
  HistoryStatus status;
  std::vector<PathPoint> path;
  std::vector<Snap> snaps;
  EnergyAccount energy;
};

// The states at given stage positions.
// Domain:     stages >= 0, never falling, the last at least 1e-6; std::invalid_argument, naming the index, otherwise.
// Max error:  as overall_equilibria(); the energy account closes to 1e-10 of the stage work.
// Fails:      slipped_through.
History load_in_steps(const Friction& friction, const Rig& rig, std::span<const double> stages);

// The whole curve up to a stage position: n points on each stable part, its ends among them, so that the snaps are exact.
// Domain:     stage_max >= 1e-6, n >= 2; std::invalid_argument otherwise.
History load_continuously(const Friction& friction, const Rig& rig, double stage_max, int n);

}  // namespace flexslip
