#include "inference/chi_squared.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fibre/elementary.h"

namespace flexslip {

double chi_squared_beyond(double x, std::size_t freedoms) {
  if (!(x > 0)) return 1;
  // Abramowitz and Stegun 26.4.4 and 26.4.5, term by term, logarithms taken lest a great x leave nothing.
  const double log_half = elementary::log(0.5 * x);
  const bool odd = freedoms % 2 == 1;
  double sum = odd ? 2 * elementary::exp(elementary::gaussian_below(-std::sqrt(x)).log_probability) : 0;
  double log_term = -0.5 * x;  // of (x/2)^k e^(-x/2)/Γ(k + 1)
  double k = 0;
  if (odd) {
    k = 0.5;
    log_term += 0.5 * log_half - elementary::log(0.5 * std::sqrt(std::numbers::pi));
  }
  for (; 2 * k < static_cast<double>(freedoms); ++k) {
    sum += elementary::exp(log_term);
    log_term += log_half - elementary::log(k + 1);
  }
  return std::min(sum, 1.0);
}

}  // namespace flexslip
