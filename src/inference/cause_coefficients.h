// What makes probabilities of the causes of drops (causes.h). Written by tools/calibrate-verdict of 2101 simulated records, 100 of them loaded again, not
// by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// Of the log odds of cracks, and of both, over slips, by inputs_of.
inline constexpr std::array cracks{0.554,  0.314,  6.855,  -3.361, -0.935, 1.347, -2.122,
                                   -3.749, -0.022, -1.263, -1.702, 1.033,  3.332, 0.197};
inline constexpr std::array both{-1.468, 1.073,  2.026,  0.205,  0.372, -0.041, -2.153,
                                 -2.451, -2.661, -1.111, -1.288, 7.116, -1.361, 0.004};

// Of a record that was loaded again: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12) and the log odds of one loading.
inline constexpr std::array cracks_by_reload{0.073, 1.044, 1.057, -1.077, 1.911, 1.490, 0.897, 0.048};
inline constexpr std::array both_by_reload{-0.272, 2.066, 0.259, -0.846, 2.026, 0.968, 0.131, 0.848};

}  // namespace flexslip::cause_coefficients
