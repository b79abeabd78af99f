#include "data/estimate.h"

#include "data/distributions.h"
#include "fibre/elementary.h"

namespace flexslip {

Estimate student_estimate(double value, double standard_error, double freedom) {
  constexpr double two_sided = 1.96;
  const double reach = student_quantile(two_sided, freedom) * standard_error;
  return {value, standard_error, value - reach, value + reach};
}

Estimate scaled(const Estimate& estimate, double factor) {
  return {estimate.value * factor, estimate.standard_error * factor, estimate.low * factor, estimate.high * factor};
}

Estimate exponential(const Estimate& logarithm) {
  const double value = elementary::exp(logarithm.value);
  return {value, value * logarithm.standard_error, elementary::exp(logarithm.low), elementary::exp(logarithm.high)};
}

}  // namespace flexslip
