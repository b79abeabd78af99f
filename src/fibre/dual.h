// A number with one derivative. Writing the kernel once for double and for Dual makes its derivatives exact by construction.
#pragma once

#include <cmath>

namespace flexslip {

struct Dual {
  double v;  // value
  double d;  // derivative with respect to the one variable of the caller
  constexpr Dual(double value = 0, double derivative = 0) : v(value), d(derivative) {}
};

constexpr Dual operator+(Dual a, Dual b) { return {a.v + b.v, a.d + b.d}; }
constexpr Dual operator-(Dual a, Dual b) { return {a.v - b.v, a.d - b.d}; }
constexpr Dual operator*(Dual a, Dual b) { return {a.v * b.v, a.d * b.v + a.v * b.d}; }
constexpr Dual operator/(Dual a, Dual b) {
  const double value = a.v / b.v;
  return {value, (a.d - value * b.d) / b.v};
}
inline Dual sqrt(Dual a) {
  const double root = std::sqrt(a.v);
  return {root, 0.5 * a.d / root};
}

}  // namespace flexslip
