// Friction along the fibre as a random process: a Matérn process about a mean that is linear in what is sought.
//
// A place x on the fibre is its distance from the middle of the fibre seen, in spans: x = (S - S_middle)/2, so that λ is the period in x.
#pragma once

#include <array>
#include <string_view>

namespace flexslip {

// How smooth the roughness is: a path of `exponential` (Matérn 1/2) has no slope, one of `matern_3_2` one, of `matern_5_2` two derivatives.
enum class Kernel { none, exponential, matern_3_2, matern_5_2 };

inline constexpr std::array all_kernels{Kernel::none, Kernel::exponential, Kernel::matern_3_2, Kernel::matern_5_2};

std::string_view name_of(Kernel kernel);

// What the process and the noise of a record are like.
struct Hyperparameters {
  double noise;        // [EI/L^2] standard deviation σ of one force reading
  double correlation;  // [1] ρ of the errors of readings one row apart, in [0, 0.95)
  double roughness;    // [1] standard deviation σ_g of μ about its mean; without a kernel not used
  double length;       // [L] correlation length ℓ along the fibre; likewise
};

}  // namespace flexslip
