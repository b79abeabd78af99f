// Do the same points of a fibre resist in both directions?
#pragma once

#include <cstddef>
#include <span>

namespace flexslip {

inline constexpr std::size_t least_pairs = 10;  // places passed both ways: two unknowns of a loop and its noise

// Pearson's correlation of friction in the two directions, each less its quadratic trend in S, places weighted by their noise.
struct BumpCorrelation {
  double value;             // [1] NaN for fewer than 10 places, or without any bumps
  double low, high;         // [1] 95 % interval by Fisher's transform
  double effective_points;  // [1] n/(1 + 2 Σ ρ_in ρ_out) of n places: neighbouring places are no independent evidence
};

// Units:      noise is the variance of in - out [1] at each place.
// Domain:     columns of one length, S rising, noise >= 0; std::invalid_argument otherwise.
// Tolerance:  where the directions have nothing in common, an interval without 0 comes in at most 10 % of cases instead of 5
//             (tested for correlation lengths of 1/50 to 1/15 of the range; bumps wider than that are too few to tell).
BumpCorrelation correlate_bumps(std::span<const double> S, std::span<const double> in, std::span<const double> out,
                                std::span<const double> noise);

// That of several loops together: the mean of Fisher's transforms; NaN if none has enough places.
BumpCorrelation together(std::span<const BumpCorrelation> loops);

// How many independent numbers two series are worth, n/(1 + 2 Σ ρ_a ρ_b), the sum up to the first lag at which either has lost its
// correlation (Bartlett).
double effective_count(std::span<const double> a, std::span<const double> b);

}  // namespace flexslip
