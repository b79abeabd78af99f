// The kernels of the roughness of friction along the specimen, and the parameters of roughness and
// noise.
#pragma once

#include <array>
#include <string_view>

namespace flexslip {

// The smoothness of the roughness: `exponential` (Matérn 1/2) has no derivative along the specimen,
// `matern_3_2` has one, `matern_9_2` four. `none` is friction without roughness.
enum class Kernel { none, exponential, matern_3_2, matern_9_2 };

inline constexpr std::array all_kernels{Kernel::none, Kernel::exponential, Kernel::matern_3_2, Kernel::matern_9_2};

std::string_view name_of(Kernel kernel);

// The parameters of the roughness and of the noise of a record.
struct Hyperparameters {
  double noise;        // [EI/L^2] standard deviation σ of one force reading
  double correlation;  // [1] ρ of the errors of readings one row apart, in [0, 0.95)
  double roughness;    // [1] standard deviation σ_g of μ about its mean; unused without a kernel
  double length;       // [L] correlation length ℓ along the specimen; unused without a kernel
};

}  // namespace flexslip
