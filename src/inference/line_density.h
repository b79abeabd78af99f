// A probability density on a line, as its values at evenly spaced places.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "inference/likelihood.h"

namespace flexslip {

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

}  // namespace flexslip
