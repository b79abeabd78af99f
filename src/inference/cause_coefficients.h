// What makes probabilities of the causes of drops (causes.h). Written by tools/calibrate-verdict of 1294 simulated records, 98 of them loaded again, not
// by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// Of the log odds of cracks, and of both, over slips, by inputs_of.
inline constexpr std::array cracks{1.413,  0.693,  4.315, 0.168, -0.685, -4.343, -0.924, 1.257,
                                   -2.591, -3.048, 0.372, 0.763, 0.243,  -0.801, -1.410, -1.981,
                                   -0.898, 0.574,  3.900, 0.713, -1.362, -0.922, 0.197};
inline constexpr std::array both{-0.684, 1.688,  0.500,  -0.457, 1.934,  -0.060, 0.562,  -0.345,
                                 -2.538, -1.676, 0.493,  0.227,  -2.518, -0.227, -0.985, -1.163,
                                 -0.127, 5.608,  -2.334, 0.053,  -0.515, 0.244,  -0.037};

// Of a record that was loaded again: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12) and the log odds of one loading.
inline constexpr std::array cracks_by_reload{0.476, -0.108, 1.889, -0.654, 0.109, 2.004, 1.118, -0.181};
inline constexpr std::array both_by_reload{-2.152, 6.655, 0.113, -0.263, -0.846, -1.133, 0.288, 0.681};

}  // namespace flexslip::cause_coefficients
