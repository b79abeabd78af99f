// What makes probabilities of the causes of drops (causes.h). Written by tools/calibrate-verdict of 2103 simulated records, 438 of them loaded again, not
// by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// Of the log odds of cracks, and of both, over slips, by inputs_of.
inline constexpr std::array cracks{0.245,  0.404, 7.176,  -3.074, -0.944, 1.391, -2.016,
                                   -3.834, 0.372, -1.245, -1.323, 1.061,  3.294, 0.206};
inline constexpr std::array both{-1.673, 1.115,  2.286,  0.263,  0.263, 0.129,  -2.117,
                                 -2.520, -2.350, -1.107, -0.992, 7.129, -1.254, 0.000};

// Of a record that was loaded again: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12), whether a drop comes again, and the log odds of one loading.
inline constexpr std::array cracks_by_reload{0.047, 1.826, 4.230, -0.865, 0.477, 1.753, -2.835, 0.567, -0.109};
inline constexpr std::array both_by_reload{-2.958, 8.447, 1.581, -0.274, -0.829, -0.710, -0.769, 0.095, 0.338};

}  // namespace flexslip::cause_coefficients
