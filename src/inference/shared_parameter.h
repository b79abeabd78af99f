// One value of a parameter for several tests, each weighing as much as its own record says.
#pragma once

#include <cstddef>
#include <span>

#include "inference/fit.h"

namespace flexslip {

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

}  // namespace flexslip
