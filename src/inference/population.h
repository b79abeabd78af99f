// Specimens of a kind: their mean and how they differ, from what the record of each says of itself.
#pragma once

#include <span>
#include <vector>

#include "inference/shared_parameter.h"

namespace flexslip {

struct Population {
  Estimate mean;         // M
  Estimate spread;       // T: standard deviation of specimens about M, what their records err by taken off
  bool spread_is_bound;  // the records do not tell the specimens apart: spread.low is 0
  // Each in the light of the others: drawn from what its own record says towards their mean, the more the less that is. In the order of
  // the tests.
  std::vector<Estimate> specimens;
};

// The specimens' own values are x ~ N(M, T²). Beforehand M is as uncertain as the x of one specimen was, N(typical.mean, typical.deviation²),
// and T half-normal of scale typical.deviation: specimens of one kind hardly differ more than any specimen might have been expected to, and
// any lesser T is about as likely as any other, so that a few specimens alike do not make all alike.
// Domain:     at least two tests, as likelihood_of; 0 < typical.deviation < infinity; std::invalid_argument otherwise.
// Max error:  1 % of the standard errors.
// Method:     P(records | M, T) = Π ∫ L(x) N(x; M, T²) dx, a sum of bells in M at each T; M on a line of places at each of 48 T.
// Cost:       0.2 ms a test and part of its posterior.
Population population_of(std::span<const Marginal> tests, const PriorKnowledge& typical);

}  // namespace flexslip
