// Elementary functions that give the same bits on every processor and with every compiler, and the
// constants NaN and infinity.
#pragma once

#include <limits>
#include <span>

namespace flexslip {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace flexslip

namespace flexslip::elementary {

// The C library chooses variants of its functions at run time, and variants with fused products
// round differently. These functions are compiled once, for the oldest supported processor, without
// fused products.

// Max error:  2 ulp. Below -708 the result is 0.
double exp(double x);

// Domain:     x > 0, normal.
// Max error:  4 ulp.
double log(double x);

// exp(x) - 1 and ln(1 + x), accurate for small x.
// Domain:     |x| < 700; x > -0.99.
// Max error:  8 ulp.
double exp_less_one(double x);
double log_of_one_and(double x);

// A sum of ln x over many numbers. It takes the logarithm of their product only now and then.
// Domain:     1e-100 < x < 1e100.
// Max error:  1 ulp of 1 for each number, plus the error of log.
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

// The same for many numbers, in about half the time. Each result equals the result of the
// scalar function.
// Domain:     as many results as numbers; a result may overwrite its number.
void exp(std::span<const double> x, std::span<double> results);
void sine_and_cosine(std::span<const double> x, std::span<double> sines, std::span<double> cosines);

// sqrt(a^2 + b^2).
// Domain:     the squares do not overflow.
double length(double a, double b);

// The polar angle of the point (x, y), from -π to π; 0 at the origin.
// Max error:  4 ulp of π.
double angle(double y, double x);

// An angle that differs by a multiple of 2π, from -π to π.
double wrapped_angle(double angle);

// The standard Gaussian below z: ln P(z' < z), and the density at z divided by that probability.
struct GaussianBelow {
  double log_probability;
  double hazard;  // phi(z)/Phi(z)
};

// Max error:  relative 1e-13 of the hazard, absolute 1e-13 of the logarithm, for z > -1e5.
GaussianBelow gaussian_below(double z);

// The quantile: z with Φ(z) = probability.
// Domain:     1e-12 < probability < 1 - 1e-12.
// Max error:  1e-12.
double gaussian_quantile(double probability);

}  // namespace flexslip::elementary
