// The likelihood of what is seen of a Gaussian process, with its gradient.
#pragma once

#include <array>
#include <span>

#include "inference/looks.h"

namespace flexslip {

struct LikelihoodGradient {
  double value;                           // ln p(y)
  std::array<double, 4> hyperparameters;  // its derivatives to ln σ, ρ, ln σ_g and ln ℓ
  std::array<double, 2>
      log_wavelengths;  // and to ln λ of each wave: waves are the last pairs of columns, cos(2πx/λ) and sin(2πx/λ)
};

// Domain:     as require_domain; wavelengths: at most two [L], > 0.
// Method:     the filter on dual numbers; exact up to rounding.
LikelihoodGradient likelihood_gradient(const Looks& looks, Kernel kernel, const Hyperparameters& at,
                                       std::span<const double> wavelengths);

}  // namespace flexslip
