// The posterior of friction along a fibre: which kernels and which waves explain a record, and how well.
//
// Every mode found is a component of a mixture, weighed by its evidence (Laplace). Nothing is chosen but what the weights say.
#pragma once

#include <vector>

#include "inference/process_mode.h"

namespace flexslip {

struct SearchOptions {
  std::vector<Kernel> kernels{all_kernels.begin(), all_kernels.end()};
  bool without_wave = true;  // modes that have none
  std::size_t waves = 1;     // modes with so many; 0: none are looked for
};

struct Component {
  Mode mode;
  double log_evidence;
  Eigen::MatrixXd spread;  // covariance of θ, by the curvature of the merit
};

struct ScannedWavelength {
  double wavelength;  // [L]
  double gain;        // of the logarithm of the evidence, hyperparameters unchanged
};

struct ProcessSearch {
  std::vector<Component> components;    // likeliest first
  std::vector<ScannedWavelength> scan;  // of the mode without a wave, λ rising
};

// Domain:     options.kernels not empty.
// Method:     From the rises of the record, the modes without a wave; a scan over wavelengths; from each of its peaks the modes with a wave,
//             from two linearisations. Those within 12 of the best are polished, and continued to the other kernels.
ProcessSearch search(const FrictionProcess& process, const SearchOptions& options);

}  // namespace flexslip
