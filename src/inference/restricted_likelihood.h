// How likely parameters are, whatever the size and the correlation of the noise: what intervals are measured by.
#pragma once

#include <Eigen/Dense>

#include "inference/correlated_noise.h"
#include "inference/descent.h"
#include "inference/force_model.h"

namespace flexslip {

// The noise of a fit by the restricted likelihood of Patterson & Thompson. The likelihood itself takes the residuals of a fit for
// the noise, and so makes the noise too small and too little correlated, by the parameters that were fitted.
CorrelatedNoise restricted_noise(const ForceModel& model, const FitPoint& fit);

// Twice the negative restricted log likelihood, at its best in the size of the noise, its correlation held. With the correlation
// free the likelihood of real tests has a ridge on which the noise becomes a random walk that says nothing of the level.
class RestrictedLikelihood {
 public:
  RestrictedLikelihood(const ForceModel& model, const FitPoint& fit, const CorrelatedNoise& noise);

  double deviance(const Eigen::VectorXd& p) const;  // infinite where not permitted

  // By how much the deviance rises from its minimum at the ends of a 95 % interval of one parameter.
  double rise95() const;

 private:
  const ForceModel& model_;
  ModelLayout layout_;
  CorrelatedNoise noise_;
  double degrees_of_freedom_;
};

}  // namespace flexslip
