// What makes probabilities of the causes of drops: causes_of (judgement.h). Written by bench/causes/calibrate.py of 372 simulated records, not by hand.
#pragma once

#include <array>

namespace flexslip::cause_coefficients {

// Of the log odds of cracks, and of both, over slips: by 1, tanh(z/3), tanh(z/8), tanh(c/3), tanh(c/8), tanh((z² - c²)/12) and the log odds of one loading.
inline constexpr std::array cracks{-2.750, 5.403, 3.259, -1.871, 2.037, 1.011, 0.534};
inline constexpr std::array both{-3.501, 6.696, 2.821, 0.433, -0.903, 0.381, -0.145};

}  // namespace flexslip::cause_coefficients
