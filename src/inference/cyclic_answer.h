// A measured load-unload-reload test from its record to its answers: friction both ways, the loops run forward again, where the
// work went, and whether the specimen lost stiffness, and over which length friction builds up.
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

// Over which length of sliding friction builds up after a reversal: Dahl's (contact/build_up.h), read off the points of a cyclic test.

struct BuildUpLength {
  Estimate length;  // [L] of S, as both sides slide; its error from reversal to reversal, NaN of a single one
  double least;     // [L] that can be told: what is slid from row to row, and five times its noise

  // Is it told from none?
  bool is_told() const { return length.value > least && length.value > 2 * length.standard_error; }
};

// [1] What is left, in the friction read, of the height of a wave of a length [L] along the specimen.
double share_read(const BuildUpLength& build_up, double wavelength);

// None without a reversal after which six points or more are seen from the first on.
// Domain:     points in the order of the record, of these legs.
// Method:     after each reversal q = a + b exp(-s/σ), a and b its own, s the way slid since the second row of its leg (before the first the stage may
//             still have been turning), over a sixth of the
//             longest way seen (more, if that is not four times σ): beyond, what varies is friction along the specimen. One σ for all, by
//             least squares on a grid of 4 %; the error by leaving out each reversal in turn, and half a step of
//             the grid.
// Max error:  of simulated tests with noise tests/inference/build_up_length_test.cpp.
// Cost:       some ms.
std::optional<BuildUpLength> measure_build_up(std::span<const Leg> legs, std::span<const CyclicPoint> points);

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
  std::optional<BuildUpLength>
      build_up{};  // likewise; none if the record has no reversal that is seen from its beginning
};

// Domain:     columns of one length, finite, at least two legs; rig in the units of `scales`; std::invalid_argument otherwise.
// Fails:      as measure_cycles.
CyclicAnswer analyse_cycles(const Record& record, const Scales& scales, const Rig& rig,
                            const CyclesOptions& options = {});

}  // namespace flexslip
