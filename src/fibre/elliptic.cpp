#include "fibre/elliptic.h"

#include <cmath>
#include <numbers>

#include "fibre/elliptic-inl.h"

namespace flexslip {

using HWY_NAMESPACE::arc_by_doubling;
using HWY_NAMESPACE::doublings_for;

using HWY_NAMESPACE::series_limit;

namespace {

EllipticArc arc_of(double u, int doublings, const EllipticParameter& parameter) {
  const auto [m, m1] = parameter;
  const auto [cn, one_minus_cn, P, R] = arc_by_doubling<double>(u, doublings, m, m1);
  return {std::sqrt(one_minus_cn * (1 + cn)), cn, std::sqrt(m1 + m * cn * cn), one_minus_cn, P, R};
}

}  // namespace

EllipticArc elliptic_arc(double u, const EllipticParameter& parameter) {
  return arc_of(u, doublings_for(u), parameter);
}

EllipticArc nearby_arc(double u, const EllipticParameter& parameter) {
  int doublings = 0;
  for (double reach = series_limit; reach < u; reach *= 2) ++doublings;
  return arc_of(u, doublings, parameter);
}

CompleteElliptic complete_elliptic(const EllipticParameter& parameter) {
  double a = 1.0;
  double b = std::sqrt(parameter.m1);
  double power = 0.5;                // 2^(n-1)
  double sum = power * parameter.m;  // Σ 2^(n-1) c_n^2, with c_0^2 = m
  // Convergence is quadratic: if c_n is below 2^-27, the next one is below rounding.
  while (a - b > 0x1p-27 * a) {
    const double half_difference = 0.5 * (a - b);
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    power *= 2;
    sum += power * half_difference * half_difference;
  }
  const double K = std::numbers::pi / (a + b);
  return {.K = K, .E = K * (1.0 - sum)};
}

double jacobi_epsilon(double u, const EllipticArc& arc, const EllipticParameter& parameter) {
  const auto [m, m1] = parameter;
  const double V = 2.0 * arc.P + (m - m1) * arc.R;  // ∫ sd^2
  return m1 * u + m * (arc.sn * arc.cn / arc.dn + m1 * V);
}

}  // namespace flexslip
