// Over which length of sliding friction builds up after a reversal: Dahl's (contact/build_up.h), read off the points of a cyclic test.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "data/estimate.h"
#include "data/legs.h"
#include "inference/cycles.h"

namespace flexslip {

struct BuildUpLength {
  Estimate length;  // [L] of S, as both sides slide; its error from reversal to reversal, NaN of a single one
  double least;     // [L] that can be told: what is slid from row to row, and five times its noise
  std::size_t reversals;

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

}  // namespace flexslip
