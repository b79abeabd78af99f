// What makes probabilities of the causes of drops (causes.h). Written by tools/calibrate-verdict of 1299 simulated records, 100 of them loaded again, not
// by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// Of the log odds of cracks, and of both, over slips, by inputs_of.
inline constexpr std::array cracks{1.466,  0.713,  4.160, 0.238, -0.581, -4.423, -1.102, 1.440,
                                   -2.586, -3.068, 0.331, 0.740, 0.285,  -0.825, -1.471, -2.004,
                                   -0.926, 0.559,  3.957, 0.967, -1.253, -0.871, 0.197};
inline constexpr std::array both{-0.757, 1.848,  0.274,  -0.316, 1.832,  -0.057, 0.500,  -0.267,
                                 -2.490, -1.699, 0.476,  0.244,  -2.579, -0.289, -1.022, -1.168,
                                 -0.101, 5.697,  -2.267, 0.200,  -0.449, 0.206,  -0.032};

// Of a record that was loaded again: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12) and the log odds of one loading.
inline constexpr std::array cracks_by_reload{0.425, -0.440, 0.711, 0.189, 1.090, 2.367, 1.140, -0.155};
inline constexpr std::array both_by_reload{-0.399, 1.952, 0.270, 0.345, 0.677, 0.298, 0.331, 0.811};

}  // namespace flexslip::cause_coefficients
