// The best fit at a given value of one parameter, from a neighbouring solution: a point of a profile likelihood.
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "inference/descent.h"
#include "inference/force_model.h"
#include "inference/polar_parameters.h"
#include "inference/restricted_likelihood.h"

namespace flexslip {

struct LikelihoodPoint {
  Eigen::VectorXd p;
  double deviance;  // twice the negative restricted log likelihood; infinite where not permitted
};

// A parameter of the polar ones.
struct ProfiledParameter {
  PolarParameters polar;
  Eigen::Index index;
};

class ConstrainedFit {
 public:
  // The noise is that of the centre.
  ConstrainedFit(const ForceModel& model, const FitPoint& centre);
  // The same, of which some parameters are not free: their errors are 0.
  ConstrainedFit(const ForceModel& model, const FitPoint& centre, const Freedom& freedom);

  const FitPoint& centre() const { return centre_; }
  const LikelihoodPoint& best() const { return best_; }
  double rise95() const { return likelihood_.rise95(); }
  const Eigen::MatrixXd& covariance() const { return covariance_; }  // of the parameters, by Gauss and Newton
  Eigen::MatrixXd covariance(const PolarParameters& polar) const;    // of the polar ones
  double value(const ProfiledParameter& parameter) const;            // at the centre
  double deviation(const ProfiledParameter& parameter) const;        // standard deviation by Gauss and Newton

  // Method:     along the ridge of the error ellipsoid from the neighbour, a descent with capped loss and one without; where the
  //             deviance then lies above what the ellipsoid says, because a jump stopped them, searches along the axes of what
  //             is free.
  LikelihoodPoint at(const ProfiledParameter& parameter, double value, const Eigen::VectorXd& neighbour) const;

  // The likeliest of some points, if it is worthwhile to go there and no further than the ellipsoid may be wrong; else null.
  const LikelihoodPoint* likelier(const std::vector<LikelihoodPoint>& points) const;

 private:
  const ForceModel& model_;
  FitPoint centre_;
  RestrictedLikelihood likelihood_;
  LikelihoodPoint best_;
  Eigen::MatrixXd information_, covariance_;
};

}  // namespace flexslip
