// What makes probabilities of the causes of drops (causes.h). Written by tools/calibrate-verdict of 2223 simulated records, 100 of them loaded again, not
// by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// Of the log odds of cracks, and of both, over slips, by inputs_of.
inline constexpr std::array cracks{0.620,  0.382,  6.963,  -3.169, -1.327, 1.468, -1.987,
                                   -3.606, -0.241, -1.238, -1.779, 1.838,  2.927, 0.133};
inline constexpr std::array both{-1.560, 0.976,  2.471,  0.273,  0.241, -0.066, -2.069,
                                 -2.404, -2.784, -1.013, -1.328, 7.710, -1.426, -0.039};

// Of a record that was loaded again: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12) and the log odds of one loading.
inline constexpr std::array cracks_by_reload{-0.063, 1.963, 1.277, -2.122, 3.388, 1.402, 0.924, 0.082};
inline constexpr std::array both_by_reload{-0.329, 2.260, 1.249, -1.557, 2.900, 0.909, 0.143, 0.907};

}  // namespace flexslip::cause_coefficients
