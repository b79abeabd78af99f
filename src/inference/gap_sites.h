// Gaps that the fibre jumped over, and what is taken for the bounds that friction had there.
#pragma once

#include <cstddef>
#include <vector>

#include "inference/first_passages.h"

namespace flexslip {

inline constexpr double bound_softness = 0.003;  // [1] of μ

// What a place in a gap, where friction must have been below a bound, is taken for: a Gaussian of the slack between the two.
struct GapSite {
  std::size_t reading;        // the first beyond the gap
  std::size_t node, nodes;    // which of how many
  double precision = 0;       // [1]
  double precision_mean = 0;  // [1]
  double slope = 0;           // [1/L] dμ/dS of the friction fitted
};

// The sites of a linearisation at a noise [1] of μ: where the fibre advanced by far more than friction that stays would let it, it jumped.
// Those that were there before stay as they were.
std::vector<GapSite> sites_of(const Passages& passages, const Linearisation& at, double noise,
                              const std::vector<GapSite>& before);

// What a site adds to the evidence beyond the Gaussian that stands for it, which gives the slack this mean and variance.
double log_weight(const GapSite& site, double mean, double variance);

}  // namespace flexslip
