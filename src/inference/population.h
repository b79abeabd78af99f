// What records say of a number: their likelihoods, one value for several of them, and specimens of a kind, their mean and how they differ.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "inference/fit.h"

namespace flexslip {

// What a record alone says of a number: how likely it is made by each value, up to a factor.
//
// A record's posterior is a mixture of normal distributions, what was known beforehand one of them: their quotient is a sum of bells.

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

// A probability density on a line, as its values at evenly spaced places.

class LineDensity {
 public:
  // Domain:     at least four values, none negative, not all 0; step > 0. They need not integrate to 1.
  LineDensity(double begin, double step, std::vector<double> values);

  std::size_t size() const { return density_.size(); }
  double place(std::size_t i) const { return begin_ + step_ * static_cast<double>(i); }
  double at(std::size_t i) const { return density_[i]; }  // [1/unit of the line]

  double mean() const;
  double deviation() const;
  // P(number < x), and x of a probability in (0, 1).
  // Max error:  1e-4 of the probability, and 1e-3 of the deviation within a 99 % interval, where the step is a quarter of the width of what is
  //             narrowest, or less.
  double probability_below(double x) const;
  double quantile(double probability) const;

 private:
  double begin_, step_;
  std::vector<double> density_, below_;
};

struct ProductDensity {
  LineDensity density;
  double log_integral;  // ln of that of the product
};

// The product of likelihoods as a density, all of it but 1e-8.
// Domain:     factors not empty, one of them of bells that are all curved; step, in the width of the narrowest bell that the product can hold,
//             in (0, 0.7]: with 0.7 the integral is good to 1e-7, with 0.25 the density as smooth as quantiles need.
//             std::invalid_argument otherwise.
// Max error:  that, where the narrowest bell is no less than a 5000th of what matters.
// Method:     the product is a sum of bells none narrower than the product of the narrowest, so that a coarse look bounds what may lie
//             between two places; what cannot matter is cut off, and the rest looked at again.
ProductDensity density_of_product(std::span<const Likelihood> factors, double step);

// One value of a parameter for several tests, each weighing as much as its own record says.

// What is known of a number beforehand: a normal distribution; infinitely wide if nothing is.
struct PriorKnowledge {
  double mean, deviation;  // unit of the number
};

// What the tests were told on average: it errs in all of them alike. Domain: tests not empty.
PriorKnowledge prior_told_to(std::span<const Marginal> tests);

// Whether a record says of a parameter more than next to nothing: a tenth of the weight of what was known beforehand, or more. None of a number that was
// not sought: without parts, or exact.
bool tells(const Marginal& test);

struct SharedValue {
  Estimate estimate;
  std::size_t telling;  // tests whose records tell it
  double chi_squared;   // [1] of the tests about one value, with telling - 1 freedoms
  double agreement;     // [1] probability that tests that do share it would differ as much
};

// Domain:     as likelihood_of; either a test or the prior bounds the parameter; std::invalid_argument otherwise.
// Max error:  1e-3 of the standard error.
// Method:     the product of what each record alone says (likelihood_of) and of the prior, which so counts once however many tests were
//             told it. chi_squared is twice how much ln of the product of the records' likelihoods lies below the sum of what each reaches
//             at its own best value: the weighted sum of squares where they are normal.
SharedValue share(std::span<const Marginal> tests, const PriorKnowledge& prior);

// The number plus a constant, as ln of a length in another unit.
Marginal shifted(Marginal marginal, double by);

// What a record says of the logarithm of a positive number, of which nothing was known beforehand: a normal distribution of its median and
// as wide as its 95 % interval.
// Domain:     0 < low < value < high; std::invalid_argument otherwise.
Marginal of_logarithm(const Estimate& estimate);

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
