// The paper's Algorithm 1 taken literally, for one (S, β0): quadrature of (4.23) and (4.18) over Jacobi's cd as in (4.14), in
// long double, and a search for the smallest root P_n of (4.27). Slow, and independent of src/fibre.
#pragma once

#include <cmath>

#include <boost/math/special_functions/jacobi_elliptic.hpp>

namespace flexslip {

struct LiteralState {
  double Pn, w, F;
};

class LiteralFibre {
 public:
  LiteralFibre(double S, double q) : S_(S), beta0_(std::atan2(1.0L, -static_cast<long double>(q))) {}  // cot β0 = -q

  // The smallest root of (4.27): a walk in ω, of which P_n is the square, up to the first change of sign, then bisection.
  LiteralState state() const {
    long double low = 0, high = 0;
    do {
      low = high;
      high += 0.125L;
    } while (closing(high) < 0);
    while (high - low > 1e-17L * high) {
      const long double middle = 0.5L * (low + high);
      if (middle <= low || middle >= high) break;
      (closing(middle) < 0 ? low : high) = middle;
    }
    const long double omega = high;
    const long double middle = beta(0.5L, omega);
    const long double w = S_ * integral(omega, [&](long double b) { return std::sin(b - middle); });  // (4.18)
    const long double half = integral(omega, [&](long double b) { return std::cos(b - middle); });
    const long double F = 8 * omega * omega * half * half * std::sin(middle);  // (4.22)
    const long double Pn = omega * omega * std::sin(beta0_) / (S_ * S_);       // (4.16b)
    return {static_cast<double>(Pn), static_cast<double>(w), static_cast<double>(F)};
  }

 private:
  // (4.14)
  long double beta(long double s, long double omega) const {
    const long double k = std::sin(0.5L * beta0_);
    return 2 * std::asin(k * boost::math::jacobi_cd(k, omega * s));
  }

  // (4.27)
  long double closing(long double omega) const {
    const long double middle = beta(0.5L, omega);
    return 1 - 2 * S_ * integral(omega, [&](long double b) { return std::cos(b - middle); });
  }

  // Over s from 0 to 1/2, by Simpson's rule and Richardson's extrapolation until two agree to 1e-15.
  template <class Function>
  long double integral(long double omega, Function f) const {
    const auto at = [&](long double s) { return f(beta(s, omega)); };
    const long double length = 0.5L;
    long double sum = 0.5L * (at(0) + at(length));
    long double trapezoid[12][12];
    trapezoid[0][0] = sum * length;
    for (int i = 1; i < 12; ++i) {
      const int pieces = 1 << i;
      for (int j = 1; j < pieces; j += 2) sum += at(length * j / pieces);
      trapezoid[i][0] = sum * length / pieces;
      long double power = 1;
      for (int j = 1; j <= i; ++j) {
        power *= 4;
        trapezoid[i][j] = trapezoid[i][j - 1] + (trapezoid[i][j - 1] - trapezoid[i - 1][j - 1]) / (power - 1);
      }
      if (i > 3 && std::abs(trapezoid[i][i] - trapezoid[i - 1][i - 1]) < 1e-15L) return trapezoid[i][i];
    }
    return trapezoid[11][11];
  }

  long double S_, beta0_;
};

}  // namespace flexslip
