// What is no number, and what is beyond all numbers.
#pragma once

#include <limits>

namespace flexslip {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace flexslip
