// A height profile of a surface, from an atomic force microscope, a profilometer, or the edge in an
// image.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

// Heights at equal spacing. All lengths have one unit, called L here.
struct HeightTrace {
  double begin;                // [L] position of the first
  double step;                 // [L] > 0
  std::vector<double> height;  // [L] positive away from the material

  double position(std::size_t i) const { return begin + step * static_cast<double>(i); }
};

// for positions that an instrument rounds to three digits
inline constexpr double even_enough = 0.01;

// A trace from heights at positions, reversed if the positions fall. If a spacing differs from the
// mean by more than even_enough of it, heights are interpolated linearly at the mean spacing.
// Domain:     columns of equal length, at least 2 points; positions strictly monotone;
//             std::invalid_argument otherwise.
HeightTrace sampled(std::span<const double> position, std::span<const double> height);

// The trace minus a least-squares polynomial: degree 0 removes the mean, 1 the tilt, 2 the bow.
// Domain:     degree at most max_degree and below the number of heights; std::invalid_argument
//             otherwise.
// Max error:  1e-13 of the maximum height.
inline constexpr std::size_t max_degree = 9;
HeightTrace levelled(HeightTrace trace, std::size_t degree);

// The trace after the Gaussian low-pass of ISO 16610-21, which halves the amplitude of a wave as
// long as the cutoff.
// Domain:     cutoff > 0; std::invalid_argument otherwise. At the ends the remaining weights are
//             renormalised.
// Max error:  1e-13 of the maximum height.
// Cost:       a product for each pair of heights within 1.5 cutoffs.
HeightTrace smoothed(HeightTrace trace, double cutoff);

}  // namespace flexslip
