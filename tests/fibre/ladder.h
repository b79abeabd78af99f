// The oracle of the fibre tests: Gauss's arithmetic-geometric ladder (Abramowitz & Stegun 16.4, 17.6) gives sn, cn, dn and E
// together, and closed forms in them the rest. In 50 digits it is the truth; in double it shows what a ladder loses.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tests/fibre/accuracy.h"

namespace flexslip {

using Fifty = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

inline Digits digits(const Fifty& x) {
  const auto hi = static_cast<double>(x);
  return {hi, static_cast<double>(x - hi)};
}

template <class T>
struct Ladder {
  T sn, cn, dn;
  T E;        // E(am u)
  T V, P, R;  // as in fibre/elliptic.h; V = ∫ sd^2

  Ladder(T u, T m, T m1) {
    using std::abs, std::asin, std::cos, std::ldexp, std::sin, std::sqrt;
    std::array<T, 16> a, c;
    T b = sqrt(m1);
    T sum = m / 2;
    int n = 0;
    a[0] = 1;
    c[0] = sqrt(m);
    for (std::size_t i = 0; abs(c[i]) > std::numeric_limits<T>::epsilon() * a[i]; ++i) {
      a[i + 1] = (a[i] + b) / 2;
      c[i + 1] = (a[i] - b) / 2;
      b = sqrt(a[i] * b);
      sum += ldexp(c[i + 1] * c[i + 1], n);
      ++n;
    }
    T phi = ldexp(a[static_cast<std::size_t>(n)] * u, n);
    E = (1 - sum) * u;
    for (auto i = static_cast<std::size_t>(n); i > 0; --i) {
      const T sine = sin(phi);
      E += c[i] * sine;
      phi = (phi + asin(c[i] / a[i] * sine)) / 2;
    }
    sn = sin(phi);
    cn = cos(phi);
    dn = sqrt(m1 + m * cn * cn);
    const T nd2 = (E - m * sn * cn / dn) / m1;   // ∫ 1/dn^2
    V = (nd2 - u) / m;                           // ∫ sn^2/dn^2
    R = nd2 - 2 * sn / dn + (u - m1 * nd2) / m;  // ∫ (1 - 2 cn + cn^2)/dn^2
    P = (V - (m - m1) * R) / 2;
  }
};

}  // namespace flexslip
