#include "data/estimate.h"

#include "data/distributions.h"

namespace flexslip {

Estimate student_estimate(double value, double standard_error, double freedom) {
  constexpr double two_sided = 1.96;
  const double reach = student_quantile(two_sided, freedom) * standard_error;
  return {value, standard_error, value - reach, value + reach};
}

}  // namespace flexslip
