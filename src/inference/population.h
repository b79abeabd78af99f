// Specimens of one kind: the typical value of a parameter, and how far specimens differ, from estimates with different errors.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "inference/fit.h"
#include "numerics/statistics.h"

namespace flexslip {

// The estimate of a parameter from one record alone.
struct Measured {
  double value;           // unit of the parameter
  double standard_error;  // > 0
};

// The estimate of the record without the prior: the normal distribution that, times the prior, has the posterior's mean and deviation.
// None unless the record says at least as much as the prior: less would be divided out of a posterior that is mostly prior.
std::optional<Measured> measured_by_record(const Marginal& marginal);

struct Population {
  std::size_t tests;
  Estimate typical;  // mean over specimens
  double spread;     // standard deviation between specimens, without the errors of the records
  double least_spread = 0,
         most_spread = 0;  // 95 % interval; 0 to most_spread where the records do not distinguish the specimens
};

inline constexpr std::size_t min_tests_of_population = 3;  // two differ once, which shows no spread

// Random-effects mean: each specimen's value is N(typical, spread²), each estimate N(its value, standard_error²).
// Domain:     at least min_tests_of_population tests; std::invalid_argument otherwise.
// Max error:  of the spread 1e-6 of the range of the estimates.
// Method:     the spread maximises the restricted likelihood (REML; Viechtbauer, J. Educ. Behav. Stat. 30, 2005); its interval holds the spreads whose log
//             likelihood lies less than 1.92 below. The standard error of the mean is Hartung's and Knapp's (Stat. Med. 20, 2001), but never below 1/√Σw
//             (Röver et al., BMC Med. Res. Methodol. 15, 2015), with Student's t: with 1/√Σw alone, 95 % intervals of 3 to 6 tests held the true mean in
//             83 to 88 % of simulated campaigns.
Population population_of(std::span<const Measured> tests);

}  // namespace flexslip
