// Intervals by simulation: tests made of the fitted curve and of its own residuals in blocks, each fitted again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "inference/fit.h"

namespace flexslip {

struct BootstrapOptions {
  std::size_t count = 0;  // 0: none
  std::uint64_t seed = 1;
};

struct BootstrapEstimate {
  double standard_error;  // the scatter
  double low, high;       // 2.5 and 97.5 % of the estimates
};

struct BootstrapWave {
  BootstrapEstimate amplitude, wavelength, phase;  // units as in WaveEstimate; the phase on the turn of the estimate
};

struct Bootstrap {
  std::size_t count;  // 0: nothing else is valid
  std::size_t block;  // residuals in a block
  std::uint64_t seed;
  BootstrapEstimate mu0, drift;
  std::vector<BootstrapWave> waves;
  BootstrapEstimate bending_stiffness;
};

// Domain:     a problem as fit_friction takes, a model found for it, not the constant one; std::invalid_argument otherwise.
// Method:     moving blocks (Künsch), as long as it takes the correlation of the residuals to fall to 1 %, at least 1 and at most a
//             quarter of the record; each test is fitted from the solution and from the likeliest runner-up, and the better is
//             taken. The prior of the bending stiffness is drawn anew for each, as it is an observation too.
// Cost:       0.5 ms each for one wave and 260 points.
Bootstrap block_bootstrap(const FitProblem& problem, const ModelFit& fit, const BootstrapOptions& options,
                          const HeldValues& held = {});

}  // namespace flexslip
