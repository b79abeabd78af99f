// The posterior of friction along a fibre: which kernels and which waves explain a record, and how well.
//
// Every mode found is a component of a mixture, weighed by its evidence (Laplace). Nothing is chosen but what the weights say.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "inference/process_mode.h"

namespace flexslip {

// Of the logarithm of the evidence: what one wave more must bring to be claimed.
inline constexpr double claiming_gain = 3;

struct SearchOptions {
  std::vector<Kernel> kernels{all_kernels.begin(), all_kernels.end()};
  std::optional<std::size_t>
      waves;  // modes with so many; not given: with none, with one, and with two where both are claimed
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
  std::vector<Component> components;    // likeliest first; none where the readings are too far from any friction
  std::vector<ScannedWavelength> scan;  // of the mode without a wave, λ rising
};

// Domain:     options.kernels not empty.
// Method:     From the rises of the record, the mode without a wave; scans over wavelengths at three settings of the hyperparameters; from the
//             best two peaks of each, modes with a wave. The best three within 12 of the first are polished, if the first gains anything, and
//             those within 3 continued to the other kernels, unless no wave is likelier by more than 2. A second wave likewise.
ProcessSearch search(const FrictionProcess& process, const SearchOptions& options);

}  // namespace flexslip
