// A planned test over a range of one of its numbers, or of two.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "design/design_axis.h"
#include "design/design_result.h"

namespace flexslip {

// A range from "stiffness=10 N/m:1000 N/m:50": name, ends and how many values. They are evenly spaced, in the logarithm where the ends
// are ten times apart or more.
// Fails:      InputError, without a place, for a name or a range that the case does not have.
DesignAxis map_axis(const DesignCase& input, std::string_view text, std::uint64_t usual_points);

// One axis or two, each from such a text; none of none. Errors name the flag --over.
// Fails:      InputError as map_axis; for more axes, the same parameter twice, and more than a million designs.
std::vector<DesignAxis> map_axes(const DesignCase& input, const std::vector<std::string>& texts);

struct MapPoint {
  std::vector<double> values;  // of the parameters of the axes
  DesignResult result;
  double margin;  // [1] as stiffness_margin; above 0 the specimen does not snap; NaN where there is no outcome
};

// All of the grid, the last axis fastest.
// Domain:     axes of ranges.
// Cost:       one outcome and one critical stiffness each. The same points for any number of them.
// Fails:      with an empty list once `stop` is true: at the end of the designs under way.
std::vector<MapPoint> design_map(const DesignCase& input, const std::vector<DesignAxis>& axes, unsigned threads,
                                 const std::atomic<bool>* stop = nullptr);

// Where the margin of a map over two axes vanishes: on the edges of the grid's cells, evenly in the logarithm of a logarithmic axis, and straight
// between them.
struct BorderPiece {
  std::array<double, 2> from, to;  // the two parameters
};
std::vector<BorderPiece> border_of_snapping(const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points);

}  // namespace flexslip
