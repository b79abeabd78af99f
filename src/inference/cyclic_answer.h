// A measured load-unload-reload test from its record to its answers: friction both ways, the loops run forward again, where the
// work went, and whether the specimen lost stiffness.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bending_test/rig.h"
#include "data/loading_stiffness.h"
#include "data/record.h"
#include "data/scales.h"
#include "inference/cycles.h"
#include "numerics/statistics.h"

namespace flexslip {

// The friction table of all loops run forward over the record's stage positions.
struct LoopReplay {
  std::vector<double> force;  // [EI/L^2] nominal, at each row; NaN out of contact, and where the table does not reach
  std::vector<double> residual_rms;  // [1] of each loop, over the greatest measured force of the record
};

// Work at the supports' side, ∫ F dw0, from the measured points of one loop past CyclesOptions::min_deflection [EI/L] nominal.
// NaN: of a leg that the loop does not have, and what hangs on it.
struct LoopEnergy {
  double loading;    // put in: the apparent work of fracture of this loading
  double unloading;  // given back
  double stored;     // kept by bending, from where the loop begins to where it ends
  double lost;       // the area of the loop less that
  double friction;   // ∫ |q| Pn |dS| where the fibre slides, at the EI and the contact estimated
};

struct CyclicAnswer {
  CyclicFriction friction;
  std::vector<LoopEnergy> energy;           // of each loop of `friction`
  std::vector<LoadingStiffness> stiffness;  // of each loading leg
  LoopReplay replay;                        // empty unless friction.status is ok or no_mirror
};

// Domain:     columns of one length, finite, at least two legs; rig in the units of `scales`; std::invalid_argument otherwise.
// Fails:      as measure_cycles.
CyclicAnswer analyse_cycles(const Record& record, const Scales& scales, const Rig& rig,
                            const CyclesOptions& options = {});

}  // namespace flexslip
