// A function of one number as a Chebyshev series.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "bending_test/polynomial.h"

namespace flexslip::chebyshev {

inline constexpr std::size_t terms = 14;
using Nodes = std::array<double, terms>;

// From `least` to `greatest`, straight on beyond.
struct Series {
  double least, greatest;
  Nodes coefficients;
};

ValueAndSlope evaluate(const Series& series, double at);

// Where a series is to be known, and the series through its values there.
Nodes nodes_between(double least, double greatest);
Series series_through(double least, double greatest, std::span<const double> at_nodes);

// Where a series that rises has a value.
double inverse(const Series& series, double value);

}  // namespace flexslip::chebyshev
