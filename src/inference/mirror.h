// Bending stiffness and contacts at which loading and unloading are mirror images: by least squares, and the noise by its likelihood.
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Dense>

#include "inference/cycles.h"
#include "inference/loop_blocks.h"

namespace flexslip::loops {

// A step of the unknowns: ln EI, the contacts, and the mean difference of the directions if that is asked for.
struct NormalStep {
  Eigen::VectorXd step;
  Eigen::MatrixXd covariance;
  double objective;  // -2 log of the restricted likelihood
};

// A loop whose directions passed the same places.
struct Mirror {
  Pairs places;
  std::size_t column;  // of the contact
  double range;        // [L]
};

// Least squares over all mirrored loops in ln EI, the contacts and, with `differences` = 1, the mean difference of the directions.
class Estimator {
 public:
  Estimator(std::span<const Mirror> mirrors, const Calibration& calibration, const CyclesOptions& options)
      : mirrors_(mirrors), calibration_(calibration), options_(options) {}

  NormalStep estimate(const Noise& noise, Eigen::Index differences) const;

 private:
  std::span<const Mirror> mirrors_;
  const Calibration& calibration_;
  const CyclesOptions& options_;
};

// Maximises the restricted likelihood over the logarithms of the noise, by steps along each that shrink to 5 %.
Noise likely_noise(const Estimator& estimator, const Noise& start, double reading, double shortest, double longest);

}  // namespace flexslip::loops
