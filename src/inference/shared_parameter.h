// One value of a parameter for several tests: the likeliest, each test weighing as much as its own record says.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "inference/fit.h"

namespace flexslip {

// Log likelihoods of all tests together at values of the parameter, everything else fitted anew in each test.
using JointLikelihood = std::function<std::vector<double>(std::span<const double> values)>;

enum class SharedStatus {
  ok,
  at_bound,  // the likelihood still rises where the range ends: the estimate is there, and its interval is cut
};

struct SharedEstimate {
  SharedStatus status;
  ParameterEstimate estimate;  // unit of the parameter; 95 % interval by the fall of the likelihood
};

// Where to look: from `low` to `high`, first at `points` values evenly spaced in the logarithm. Between neighbours the
// likelihood must have no more than one maximum worth finding.
struct SharedRange {
  double low, high;  // unit of the parameter
  std::size_t points;
};

// Domain:     0 < low < high, points >= 5; std::invalid_argument otherwise. A likelihood may be -infinity, but not at all values.
// Max error:  1e-3 of the width of the interval in its ends and in the value.
// Method:     grids that close in on the maximum and on the two places where the log likelihood has fallen by 1.92.
// Cost:       points + about 60 values.
SharedEstimate estimate_shared(const SharedRange& range, const JointLikelihood& log_likelihood);

}  // namespace flexslip
