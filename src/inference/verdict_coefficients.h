// What makes a probability of what tells slips from cracks: cracks_alone (slip_or_crack.h). Written by tools/calibrate-verdict of 7743 simulated tests, not
// by hand.
#pragma once

#include <cstddef>

namespace flexslip::verdict_coefficients {

// Of the log odds that cracks alone made the drops, over the root of the number of rises, by tanh((feature - middle)/width).
inline constexpr double constant = 0.292;
inline constexpr double of_given_back = -1.732;
inline constexpr double of_friction_needed = -0.490;
inline constexpr double of_margin = -0.203;
inline constexpr double of_loss_margin = 0.280;
inline constexpr double given_back_middle = 0.25;
inline constexpr double friction_needed_middle = 0.7;
inline constexpr std::size_t rises_that_count = 16;
inline constexpr double given_back_width = 0.4;
inline constexpr double friction_needed_width = 0.4;
inline constexpr double margin_width = 15;
inline constexpr double loss_margin_width = 10;

// What the simulated tests range over.
inline constexpr std::size_t fewest_rows = 60;
inline constexpr std::size_t most_rows = 2000;
inline constexpr double softest_train = 12;
inline constexpr double stiffest_train = 300;
inline constexpr double shallowest = 0.15;

}  // namespace flexslip::verdict_coefficients
