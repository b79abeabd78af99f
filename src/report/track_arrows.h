// Arrows on a line that say which way it goes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace flexslip {

struct Spot {
  double x, y;  // [1] of the ranges of the axes
};

// A short arrow on the part of a line from one spot to another: where the line is straight for its length, so that the arrow lies on it and crosses no
// teeth; the nearer to the middle the better, and away from other arrows. None if there is no such place.
struct Arrow {
  Spot from, to;
};
std::optional<Arrow> arrow_on(std::span<const Spot> line, std::size_t first, std::size_t last,
                              const std::vector<Arrow>& others);

}  // namespace flexslip
