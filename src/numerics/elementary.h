// Elementary functions that give the same bits on every processor and with every compiler, and what is no number or beyond all numbers.
#pragma once

#include <limits>
#include <span>

namespace flexslip {

// What is no number, and what is beyond all numbers.

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace flexslip

namespace flexslip::elementary {

// Elementary functions that give the same bits on every processor.
//
// The C library chooses variants of its functions when the program runs, and those with fused products round differently. These are
// compiled once, for the least processor, and fuse nothing.

// Max error:  2 ulp. Below -708 the result is 0.
double exp(double x);

// Domain:     x > 0, normal.
// Max error:  4 ulp.
double log(double x);

// exp(x) - 1 and ln(1 + x), also for small x.
// Domain:     |x| < 700; x > -0.99.
// Max error:  8 ulp.
double exp_less_one(double x);
double log_of_one_and(double x);

// Σ ln x over many numbers, of whose product a logarithm is taken now and then.
// Domain:     1e-100 < x < 1e100.
// Max error:  1 ulp of 1 a number, and that of log.
class LogProduct {
 public:
  void multiply(double x) {
    product_ *= x;
    if (product_ > 1e-200 && product_ < 1e200) return;
    sum_ += log(product_);
    product_ = 1;
  }
  double value() const { return sum_ + log(product_); }

 private:
  double sum_ = 0, product_ = 1;
};

struct SineAndCosine {
  double sine, cosine;
};

// Domain:     |x| < 39000 rad.
// Max error:  4 ulp of 1.
SineAndCosine sine_and_cosine(double x);

// The same of many numbers, in about half the time: each as it is alone.
// Domain:     as many results as numbers; a result may take the place of its number.
void exp(std::span<const double> x, std::span<double> results);
void sine_and_cosine(std::span<const double> x, std::span<double> sines, std::span<double> cosines);

// sqrt(a^2 + b^2). Domain: no overflow of the squares.
double length(double a, double b);

// Of the point (x, y), from -π to π; 0 at the origin.
// Max error:  4 ulp of π.
double angle(double y, double x);

// The same direction, from -π to π.
double wrapped_angle(double angle);

// The standard Gaussian where a bound cuts it: ln P(z' < z), and the density at z over that probability.
struct GaussianBelow {
  double log_probability;
  double hazard;  // phi(z)/Phi(z)
};

// Max error:  relative 1e-13 of the hazard and, absolute, of the logarithm, for z > -1e5.
GaussianBelow gaussian_below(double z);

// z with Φ(z) = probability.
// Domain:     1e-12 < probability < 1 - 1e-12.
// Max error:  1e-12.
double gaussian_quantile(double probability);

}  // namespace flexslip::elementary
