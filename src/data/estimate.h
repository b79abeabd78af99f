// A number that was estimated: its value, how uncertain it is, and between what it lies.
#pragma once

namespace flexslip {

struct Estimate {
  double value = 0;           // median of what is known
  double standard_error = 0;  // standard deviation
  double low = 0, high = 0;   // 95 % interval
};

// One whose errors are normal; and one whose standard error is itself told by `freedom` degrees of freedom only (Student).
inline Estimate normal_estimate(double value, double standard_error) {
  constexpr double two_sided = 1.96;  // standard errors to the ends of a 95 % interval
  return {value, standard_error, value - two_sided * standard_error, value + two_sided * standard_error};
}
// Of the same number in another unit, and of one whose logarithm is estimated: its interval is symmetric in the logarithm.
Estimate scaled(const Estimate& estimate, double factor);
Estimate exponential(const Estimate& logarithm);
Estimate student_estimate(double value, double standard_error, double freedom);

}  // namespace flexslip
