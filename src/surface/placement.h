// Where along a trace a friction profile was measured: by the correlation of the slopes, and how easily chance finds as good a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flexslip {

// Slopes at even distances.
struct Slopes {
  double begin;               // [L] position of the first
  double step;                // [L] > 0
  std::vector<double> value;  // [1]
};

struct Placement {
  bool turned;         // the trace is run through the other way, its slopes with the other sign
  double offset;       // [L] s of the trace = offset + position of the profile; offset - position if turned
  double correlation;  // [1]
  double p_value;      // [1] that chance finds one as high at any place, either way round
};

// How a placement is sought. The seed makes it the same at every call.
struct PlacementOptions {
  std::size_t surrogates = 999;
  std::uint64_t seed = 20210829;
};

// The place of the greatest correlation, of all at which the shorter lies within the longer, either way round.
// Domain:     the same step; at least 8 slopes each that are not all alike, at most 2^20; std::invalid_argument otherwise.
// Method:     p = (1 + those of the surrogates that reach it)/(1 + surrogates). Surrogates of the trace have its coherent waves, each with a random
//             phase, and for the rest its spectrum with random phases; they are sought in all the same places. So the p value pays for the places
//             tried, for slopes that are correlated along the trace, and for waves that are alike wherever they are laid on each other.
// Cost:       two Fourier transforms a surrogate: a second for 4000 slopes.
Placement placed(const Slopes& profile, const Slopes& trace, const PlacementOptions& options = {});

// Slopes at a coarser step: each the mean of the trace over one step.
// Domain:     step not below that of the slopes; std::invalid_argument otherwise.
Slopes averaged(const Slopes& slopes, double step);

}  // namespace flexslip
