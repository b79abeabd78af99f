// A height profile along a surface: of an atomic force microscope, a profilometer, or the edge in an image.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

// Heights at even distances. Units: one of length for all, called L here.
struct HeightTrace {
  double begin;                // [L] position of the first
  double step;                 // [L] > 0
  std::vector<double> height;  // [L] away from the material

  double position(std::size_t i) const { return begin + step * static_cast<double>(i); }
};

inline constexpr double even_enough = 0.01;  // of positions that an instrument rounds to three digits

// A trace made of heights at positions; if these fall, in the reverse order. Where a distance of positions departs from their mean by more than
// even_enough of it, heights are interpolated linearly at the mean distance.
// Domain:     columns of one length, at least 2; positions that rise strictly, or fall strictly; std::invalid_argument otherwise.
HeightTrace sampled(std::span<const double> position, std::span<const double> height);

// A polynomial taken off by least squares: 0 the mean, 1 the tilt, 2 the bow of a fibre.
// Domain:     degree at most max_degree, more heights than that; std::invalid_argument otherwise.
// Max error:  1e-13 of the greatest height.
inline constexpr std::size_t max_degree = 9;
HeightTrace levelled(HeightTrace trace, std::size_t degree);

// Waves shorter than a cutoff taken out: the Gaussian filter of ISO 16610-21, which leaves half of the amplitude of a wave as long as its cutoff.
// Domain:     cutoff > 0; std::invalid_argument otherwise. At the ends the weights that are left are normed anew.
// Max error:  1e-13 of the greatest height. Cost: a product for each height and each that lies within 1.5 cutoffs of it.
HeightTrace smoothed(HeightTrace trace, double cutoff);

}  // namespace flexslip
