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
  double width() const { return step * static_cast<double>(height.size()); }  // [L] of the field
};

// A trace made of heights at positions.
struct Sampled {
  HeightTrace trace;
  bool turned;        // positions fell: the rows were taken in the reverse order
  double unevenness;  // [1] the greatest departure of a distance from their mean, in means
  bool interpolated;  // the unevenness is beyond even_enough: heights were interpolated linearly at the mean distance
};

inline constexpr double even_enough = 0.01;  // of positions that an instrument rounds to three digits

// Domain:     columns of one length, at least 2; positions that rise strictly, or fall strictly; std::invalid_argument otherwise.
Sampled sampled(std::span<const double> position, std::span<const double> height);

// A polynomial taken off by least squares: 0 the mean, 1 the tilt, 2 the bow of a fibre.
// Domain:     degree at most max_degree, more heights than that; std::invalid_argument otherwise.
// Max error:  1e-13 of the greatest height.
inline constexpr std::size_t max_degree = 9;
HeightTrace levelled(HeightTrace trace, std::size_t degree);

// Root of the mean square. Domain: at least one number.
double root_mean_square(std::span<const double> values);

// The least distance of two heights of which all distances are multiples, as a converter or the pixels of an image leave them; 0 if there is none.
// Method:     all distances of neighbours lie within 1e-3 of a multiple of the least, a tenth of them at most three of it, and they are not all alike.
double height_quantum(std::span<const double> height);

// Waves shorter than a cutoff taken out: the Gaussian filter of ISO 16610-21, which leaves half of the amplitude of a wave as long as its cutoff.
// Domain:     cutoff > 0; std::invalid_argument otherwise. At the ends the weights that are left are normed anew.
// Max error:  1e-13 of the greatest height. Cost: O(n log n).
HeightTrace smoothed(HeightTrace trace, double cutoff);

}  // namespace flexslip
