// The coefficients of the probabilities in causes.h. tools/calibrate-verdict writes this file from
// 2103 simulated records, 438 of them with a reload.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// The log odds of cracks only, and of both, against slips only: coefficients of inputs_of.
inline constexpr std::array cracks{-0.312, 0.331, 7.422,  -2.907, -0.939, 1.421, -1.579,
                                   -3.346, 0.163, -1.283, 1.747,  3.144,  0.206};
inline constexpr std::array both{-2.037, 1.070,  2.479,  0.330, 0.285,  0.139, -1.843,
                                 -2.088, -2.475, -1.137, 7.544, -1.368, -0.000};

// The same for a record with a reload: coefficients of 1, tanh(z/3), tanh(z/8), tanh((z² - c²)/12),
// whether a drop repeats, and the log odds of one loading.
inline constexpr std::array cracks_by_reload{-0.110, 1.854, 4.170, 2.151, -2.882, 0.582, -0.147};
inline constexpr std::array both_by_reload{-3.119, 8.449, 1.494, -0.235, -0.857, 0.132, 0.275};

}  // namespace flexslip::cause_coefficients
