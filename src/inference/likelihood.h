// What a record alone says of a number: how likely it is made by each value, up to a factor.
//
// A record's posterior is a mixture of normal distributions, what was known beforehand one of them: their quotient is a sum of bells.
#pragma once

#include <span>
#include <vector>

#include "inference/fit.h"

namespace flexslip {

// ln of it at x: height + slope (x - at) - curvature/2 (x - at)^2.
struct Bell {
  double height;
  double at;         // unit of the number
  double slope;      // its reciprocal
  double curvature;  // its reciprocal squared; > 0, or 0 with a slope of 0: a value as likely as any other
};

using Likelihood = std::vector<Bell>;

// Domain:     a posterior with parts, their deviations > 0; prior_deviation > 0, infinite where all values were alike;
//             std::invalid_argument otherwise.
// Method:     a part of the posterior over the prior, as it is where the part is narrower. A part about as wide as the prior, which is no
//             more than an approximation there, would have its quotient rise without end beyond all that the record has been asked: it is
//             made to fall from 3 deviations of the part on, its value and slope at the middle of the part kept.
Likelihood likelihood_of(const Marginal& marginal);

// A normal distribution as one more factor.
Likelihood likelihood_of_normal(double mean, double deviation);

// Of values that scatter normally about x, one of which made the record: ∫ likelihood(v) N(v; x, spread²) dv. Domain: spread >= 0.
Likelihood blurred(const Likelihood& likelihood, double spread);

// ln of the likelihood at x.
double log_of(const Likelihood& likelihood, double x);

// ln of the product, and where it is greatest near x: it never falls on the way.
double log_of_product(std::span<const Likelihood> factors, double x);
double climbed(std::span<const Likelihood> factors, double x);

}  // namespace flexslip
