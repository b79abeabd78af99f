// What makes probabilities of the causes of drops (causes.h). Written by tools/calibrate-verdict of 1294 simulated records, 98 of them loaded again, not
// by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// Of the log odds of cracks, and of both, over slips, by inputs_of.
inline constexpr std::array cracks{
    1.584, 0.807, 4.270, 0.079, -0.511, -4.269, -0.870, 1.247, -2.748,
    -2.769, 0.133, 0.633, 0.231, -0.808, -1.358, -2.229, -0.871, 0.608,
    2.898, 0.440, -1.120, -0.875, 0.163};
inline constexpr std::array both{
    -0.873, 1.637, 0.606, -0.496, 1.869, -0.160, 0.548, -0.248, -2.517,
    -1.696, 0.521, 0.339, -2.610, -0.229, -0.710, -1.113, -0.107, 5.622,
    -1.978, 0.050, -0.577, 0.234, -0.030};

// Of a record that was loaded again: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12) and the log odds of one loading.
inline constexpr std::array cracks_by_reload{
    0.295, -0.167, 1.926, -0.711, 0.264, 1.992, 1.117, -0.177};
inline constexpr std::array both_by_reload{
    -2.161, 6.638, 0.049, -0.188, -0.935, -1.103, 0.271, 0.658};

}  // namespace flexslip::cause_coefficients
