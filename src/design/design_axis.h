// What a number of a case goes through in a map or a sweep.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "design/design_case.h"

namespace flexslip {

enum class Spacing { linear, logarithmic };

// From one end to the other, both finite and included; logarithmic ones are positive.
struct AxisRange {
  double from, to;  // SI or reduced, as the case
  Spacing spacing;
  std::uint64_t points;  // of a grid, at least 2; 0 in a Latin hypercube
};

using AxisValues = std::vector<double>;  // at least one; only in a grid

// A parameter of a design that goes through values.
struct DesignAxis {
  DesignParameterName parameter;
  std::variant<AxisRange, AxisValues> values;
};

// The value of a range at t in [0, 1]; at 0 and 1 its ends, exactly.
// Max error:  4 ulp if linear, 30 ulp if logarithmic.
// Method:     linear; or halving the ratio of the ends by square roots until it is linear to rounding.
double value_at(const AxisRange& range, double t);

// How many values an axis of a grid has.
std::uint64_t points_of(const DesignAxis& axis);

// All values of an axis of a grid, in their order.
std::vector<double> values_of(const DesignAxis& axis);

// The numbers of a row of a grid, one for each axis: SI or reduced, as the case. The last axis changes fastest.
// Domain:     at least one axis, row below the product of their points.
std::vector<double> grid_inputs(const std::vector<DesignAxis>& axes, std::uint64_t row);

}  // namespace flexslip
