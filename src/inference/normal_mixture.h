// What is known of a number, as a mixture of normal distributions.
#pragma once

#include <vector>

namespace flexslip {

struct NormalPart {
  double weight;           // [1] > 0
  double mean, deviation;  // in the unit of the number; deviation >= 0
};

// Domain of all: parts not empty; the weights need not add up to 1.
using NormalMixture = std::vector<NormalPart>;

double mean_of(const NormalMixture& mixture);
double deviation_of(const NormalMixture& mixture);

// P(number < x).
double probability_below(const NormalMixture& mixture, double x);

// x with P(number < x) = probability. Domain: 0 < probability < 1. Max error: 1e-9 of the deviation.
double quantile_of(const NormalMixture& mixture, double probability);

// The same with parts that are nearly one made one, mean and deviation of the mixture kept.
// Max error:  0.01 of a probability.
NormalMixture merged(const NormalMixture& mixture);

}  // namespace flexslip
