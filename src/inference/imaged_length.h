// The length pulled in as a camera saw it, against what the force says.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/estimate.h"
#include "inference/profile.h"

namespace flexslip {

struct ImagedPoint {
  std::size_t index;  // in the record
  double inferred;    // [L] S - 1, from the force
  double imaged;      // [L]
};

struct ImagedLength {
  std::vector<ImagedPoint> points;  // of the profile that were imaged
  Estimate
      offset;  // [L] median of inferred less imaged, its error if the points erred independently; NaN without points
  double scatter;  // [L] about it, 1.48 times the median absolute deviation
};

// Domain:     pulled_in [L] of each point of the record, NaN where it was not imaged.
ImagedLength compare_with_images(const FrictionProfile& profile, std::span<const double> pulled_in);

}  // namespace flexslip
