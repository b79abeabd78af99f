#pragma once

#include <array>

namespace flexslip::cause_coefficients {
inline constexpr std::array cracks{0.880, -0.135, 2.747, -0.115, -1.225, -3.084, -0.354, -0.016, -2.063, -1.890, -0.845, -0.549, 1.642, 1.192, -1.223, -0.051, -0.399, 0.656, 0.471, -0.887, 2.506, -0.487, 0.287, -2.314, -0.476, -0.550};
inline constexpr std::array both{0.098, -0.201, 1.183, -0.353, 0.774, 0.341, 0.078, -0.310, -2.653, -0.045, -0.889, 0.774, 0.413, 0.179, -2.410, 0.639, 0.164, 0.457, -0.097, -0.687, 2.944, -0.053, -0.189, -0.320, 0.386, -0.302};
inline constexpr std::array cracks_by_reload{-2.750, 5.403, 3.259, -1.871, 2.037, 1.011, 0.534, 0.0};
inline constexpr std::array both_by_reload{-3.501, 6.696, 2.821, 0.433, -0.903, 0.381, -0.145, 0.0};
}  // namespace flexslip::cause_coefficients
