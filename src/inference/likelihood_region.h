// The parameters that a record does not contradict: all whose likelihood is within that of a 95 % interval of the greatest.
//
// The profile-likelihood interval of a parameter is the range that it takes over this region, whatever the others do.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "inference/constrained_fit.h"

namespace flexslip {

struct ParameterRange {
  double low, high;
  bool
      open;  // at an end the likelihood had not fallen off when the parameter came to the bound of what is permitted, or
             // went ten standard errors
};

struct LikelihoodRegion {
  FitPoint best;                          // the likeliest met, with its noise
  double deviance;                        // there
  double rise95;                          // of the deviance at the ends
  Eigen::MatrixXd covariance;             // of the parameters at the best, by Gauss and Newton
  std::vector<ParameterRange> ranges;     // of the polar parameters, phases meant at the length 0; not wrapped
  std::vector<ParameterRange> at_middle;  // likewise, phases meant in the middle of the data; the others are left out
};

// Domain:     a fit that has converged, or nearly.
// Method:     from the best point each parameter is moved outwards in steps of half a standard error, the others fitted anew from
//             the neighbouring solution. The residuals jump where a drop passes a point, so that such a search can miss the
//             best fit at a value: every point met on the way of any parameter counts for the ranges of all, and where a
//             likelier one than the best turns up it is the new centre. What the searches then still miss makes a range too
//             short, not too long: none is taken shorter than the Gauss-Newton interval.
// Cost:       10 ms for one wave and 260 points.
LikelihoodRegion likelihood_region(const ForceModel& model, const FitPoint& fit);

// What the curvature at a fit says of what is free, without a search.
LikelihoodRegion curvature_region(const ForceModel& model, const FitPoint& fit, const Freedom& freedom);

// The range of the last wave's wavelength about another fit of the same layout in which the likelihood is within that of the
// region; none if it is not likely enough itself.
std::optional<ParameterRange> wavelength_range(const ForceModel& model, const FitPoint& other,
                                               const LikelihoodRegion& region);

}  // namespace flexslip
