// The search for the modes of the posterior of friction: the kernels and waves that explain a
// record.
//
// Each mode is a component of a mixture, weighed by its evidence (Laplace).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "inference/process_mode.h"

namespace flexslip {

// The hypotheses to compare.
struct Hypotheses {
  std::vector<Kernel> kernels{all_kernels.begin(), all_kernels.end()};
  std::optional<std::size_t>
      waves;  // number of waves, or fewer if no further one is found; default: none, one, and two if both are detected
};

struct Component {
  Mode mode;
  double log_evidence;
  Eigen::MatrixXd spread;  // covariance of θ, from the curvature of the log_posterior
  // [1] Of ln λ of each wave, with the log_posterior linearised anew at each step. Wavelengths and
  // errors of the rig are correlated.
  std::array<double, max_waves> wavelength_deviation{};
  // [rad] The change of the phase of each wave at the middle with ln of the lengths, in the direction
  // in which wavelengths and errors of the rig compensate each other.
  std::array<double, max_waves> turn{};
};

struct ScannedWavelength {
  double wavelength;  // [L]
  double gain;        // [ln evidence] at unchanged hyperparameters
};

struct ProcessSearch {
  std::vector<Component> components;    // the most probable first; empty if no friction explains the readings
  std::vector<ScannedWavelength> scan;  // of the mode without a wave, in order of λ
};

// Domain:     asked.kernels not empty.
// Method:     starts at the rises of the record and finds the mode without a wave. One scan over
//             wavelengths follows, and another from the rises if noise blurs the places. Modes with
//             a wave start at the two best peaks of each scan. The best mode is polished and
//             continued to the other kernels unless it loses 2. A second wave is treated in the
//             same way. Relevant modes are linearised until consistent, and the most probable waves
//             are moved along their valley with the rig.
ProcessSearch search(const FrictionProcess& process, const Hypotheses& asked);

}  // namespace flexslip
