// The search for the modes of the posterior of friction along a fibre: which kernels and which waves explain a record, and how well.
//
// Every mode found is a component of a mixture, weighed by its evidence (Laplace). The weights alone choose between them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "inference/process_mode.h"

namespace flexslip {

// The explanations that are compared.
struct Hypotheses {
  std::vector<Kernel> kernels{all_kernels.begin(), all_kernels.end()};
  std::optional<std::size_t>
      waves;  // modes with so many, or fewer where no further one is told from those that are there; not given: with none, with one, and with two where both are claimed
};

struct Component {
  Mode mode;
  double log_evidence;
  Eigen::MatrixXd spread;  // covariance of θ, by the curvature of the log_posterior as it is linearised
  // [1] Of ln λ of each wave, by how the log_posterior falls where it is linearised anew: wavelengths and the errors of the rig make up for each other.
  std::array<double, max_waves> wavelength_deviation{};
  // [rad] By how much the angle of each wave at the middle turns with ln of the lengths, along that valley.
  std::array<double, max_waves> turn{};
};

struct ScannedWavelength {
  double wavelength;  // [L]
  double gain;        // of the logarithm of the evidence, hyperparameters unchanged
};

struct ProcessSearch {
  std::vector<Component> components;    // likeliest first; none where the readings are too far from any friction
  std::vector<ScannedWavelength> scan;  // of the mode without a wave, λ rising
};

// Domain:     asked.kernels not empty.
// Method:     From the rises of the record, the mode without a wave; a scan over wavelengths, and where noise blurs the places of readings one
//             more from the rises; from the best two peaks of each, modes with a wave. The best is polished, and continued to the other kernels unless
//             it loses 2. A second wave likewise. What weighs anything is linearised until it agrees with itself, and the likeliest waves are moved
//             along the valley that their length shares with the rig.
ProcessSearch search(const FrictionProcess& process, const Hypotheses& asked);

}  // namespace flexslip
