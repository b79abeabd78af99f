// The parameters of least misfit, from a start: Levenberg-Marquardt on the whitened residuals, and searches across the jumps.
#pragma once

#include <limits>
#include <span>

#include <Eigen/Dense>

#include "inference/correlated_noise.h"
#include "inference/force_model.h"
#include "inference/polar_parameters.h"

namespace flexslip {

struct FitPoint {
  ModelLayout layout;
  Eigen::VectorXd p;
  CorrelatedNoise noise;  // at p
  double log_likelihood;  // with the prior of the bending stiffness
  bool converged;         // the last step changed it no more
};

// Fits of one layout, with the freedom that is left.
class Descent {
 public:
  Descent(const ForceModel& model, const ModelLayout& layout, Freedom freedom);

  // A loss that grows as r^2 at first and is capped at cap^2 standard deviations: residuals that a drop shifts past do not
  // decide. Infinite: least squares.
  static constexpr double least_squares = std::numeric_limits<double>::infinity();

  // Twice the negative log likelihood at a given noise; infinite where not permitted.
  double cost(const Eigen::VectorXd& p, const CorrelatedNoise& noise, double cap = least_squares) const;

  struct Step {
    Eigen::VectorXd p;
    double cost;
    bool converged;
  };
  Step descend(const Eigen::VectorXd& start, const CorrelatedNoise& noise, double cap, int most_evaluations = 25) const;

  // Rounds of estimating the noise and descending; the cap applies to the first of them.
  FitPoint refined(Eigen::VectorXd p, double cap, int rounds) const;

  // The residuals jump where a drop passes a point, and a descent stops at such steps. Searches along the axes of the error
  // ellipsoid cross them: steps of `scales` standard errors, taken as long as they gain.
  Step searched(Step from, const CorrelatedNoise& noise, const Eigen::MatrixXd& errors,
                std::span<const double> scales) const;

  // Searches and descents in turn, until they gain no more.
  FitPoint polished(FitPoint point) const;

  FitPoint at(const Eigen::VectorXd& p, bool converged) const;

  // Of the parameters that are free, by Gauss and Newton.
  Eigen::MatrixXd covariance(const FitPoint& point) const;

 private:
  const ForceModel& model_;
  ModelLayout layout_;
  Freedom freedom_;
};

// Mean and drift anew by least squares in F itself. Strong correlation makes the likelihood nearly blind to the level of
// the curve; the waves are known from the differences, but the mean is what the level says.
Eigen::VectorXd levelled(const ForceModel& model, const FitPoint& point);

// The inverse of the covariance of the parameters, by Gauss and Newton, with the prior of the bending stiffness.
Eigen::MatrixXd information(const ForceModel& model, const FitPoint& point);

}  // namespace flexslip
