// The kernel of elliptic.h for any number type of lanes-inl.h: series for small arguments, then
// doublings. Included once for each instruction set.
#if defined(FLEXSLIP_FIBRE_ELLIPTIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FLEXSLIP_FIBRE_ELLIPTIC_INL_H_
#undef FLEXSLIP_FIBRE_ELLIPTIC_INL_H_
#else
#define FLEXSLIP_FIBRE_ELLIPTIC_INL_H_
#endif

#include "fibre/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

// cn and 1 - cn are both stored, because each is accurate where the other loses digits. sn and dn
// follow from them.
template <class T>
struct Arc {
  T cn, one_minus_cn, P, R;
};

// Each series ends where the first neglected term at u = 1/8 is below 2^-54 of the sum: both after
// t^6. The radius of convergence in t = u^2 is at least 6.87, the pole at K + iK'.
constexpr double series_limit = 0.125;

// The argument may be a plain number where m is a Dual, because derivatives are not taken in u.
template <class T, class Argument>
HWY_INLINE Arc<T> series(Argument u, const T& m, const T& m1) {
  const Argument t = u * u;

  // ns^2 = ℘ + (1 + m)/3, with ℘ = 1/t + c2 t + c3 t^2 + ... (DLMF 23.9.2-5, 23.10)
  const T c2 = (1.0 / 15.0) * (1.0 - m * m1);
  const T c3 = (1.0 / 189.0) * (m - 2.0) * (m - m1) * (m + 1.0);
  const T c4 = (1.0 / 3.0) * c2 * c2;
  const T c5 = (3.0 / 11.0) * c2 * c3;
  const T c6 = (1.0 / 13.0) * (2.0 * c2 * c4 + c3 * c3);
  const T t_ns2 = 1.0 + t * ((1.0 / 3.0) * (1.0 + m) + t * (c2 + t * (c3 + t * (c4 + t * (c5 + t * c6)))));
  const T sn2 = t * reciprocal(t_ns2);

  // With ψ = β0 - β along the specimen, P = ∫ sin ψ / s0 and R = 2 ∫ (1 - cos ψ)/s0^2, where
  // ψ'' = s0 cos ψ - c0 sin ψ, s0 = sin β0 and c0 = cos β0. Their Taylor coefficients are polynomials
  // in c0 = m1 - m and g = s0^2 = 4 m m1.
  const T c = m1 - m;
  const T g = 4.0 * m * m1;
  const T p2 = (1.0 / 5040) * (1.0 - 19.0 * g);
  const T p3 = (1.0 / 362880) * c * (244.0 * g - 1.0);
  const T p4 = (1.0 / 39916800) * ((5536.0 * g - 2513.0) * g + 1.0);
  const T p5 = (-1.0 / 6227020800) * c * ((174736.0 * g - 23888.0) * g + 1.0);
  const T p6 = (-1.0 / 1307674368000) * (((7436584.0 * g - 5561058.0) * g + 220107.0) * g - 1.0);
  const T P = 1.0 / 6 + t * ((-1.0 / 120) * c + t * (p2 + t * (p3 + t * (p4 + t * (p5 + t * p6)))));
  const T r2 = (1.0 / 2880) * (1.0 - 4.0 * g);
  const T r3 = (1.0 / 1330560) * c * (368.0 * g - 17.0);
  const T r4 = (1.0 / 94348800) * ((5296.0 * g - 3248.0) * g + 31.0);
  const T r5 = (-1.0 / 159667200) * c * (4.0 * g - 1.0) * (454.0 * g - 1.0);
  const T r6 = (-1.0 / 59281238016000) * (((136631104.0 * g - 119508528.0) * g + 10519032.0) * g - 5461.0);
  const T R = 1.0 / 20 + t * ((-1.0 / 168) * c + t * (r2 + t * (r3 + t * (r4 + t * (r5 + t * r6)))));

  const T cn = sqrt(1.0 - sn2);
  return {.cn = cn, .one_minus_cn = sn2 * reciprocal(1.0 + cn), .P = u * t * P, .R = u * t * t * R};
}

// From u to 2u. For 2u <= K the terms of every sum have one sign, except for cn, which must vanish
// at K. The increments of P and R follow from the addition theorems of E and of sn, cn, dn
// (docs/theory.md, "Doubling").
template <class T>
HWY_INLINE Arc<T> doubled(const Arc<T>& arc, const T& m, const T& m1) {
  const T c = arc.cn, e = arc.one_minus_cn;
  const T c2 = c * c, c4 = c2 * c2;
  const T s2 = e * (1.0 + c);
  const T d2 = m1 + m * c2;
  const T N = m1 + m * c2 * (1.0 + s2);  // 1 - m sn^4
  const T Qd2 = (m1 + m * c4) * d2;
  const auto [inverse, per_Qd2] = reciprocals(N, Qd2);
  const T common = 2.0 * sqrt(s2 * d2) * e * per_Qd2;
  const T e_new = 2.0 * s2 * d2 * inverse;
  return {.cn = choose(e_new < 0.5, 1.0 - e_new, (m * c4 + m1 * (2.0 * c2 - 1.0)) * inverse),
          .one_minus_cn = e_new,
          .P = 2.0 * arc.P + common * (m1 * m1 + m * (m1 * (2.0 * c + 2.0 * c2 - 1.0 - c * c2) + m * (c * c2))),
          .R = 2.0 * arc.R + common * e * (m1 * (2.0 + c) + m * c * (1.0 + 2.0 * c))};
}

// The number of doublings that brings u within the series. Common arguments all use the same
// number, alone or in a vector.
constexpr int common_doublings = 4;
constexpr double common_limit = 16 * series_limit;
HWY_INLINE int doublings_for(double u) {
  int doublings = common_doublings;
  while (u > common_limit) {
    u *= 0.5;
    ++doublings;
  }
  return doublings;
}

// The arc at u, from the series at u/2^doublings <= series_limit.
template <class T, class Argument>
HWY_INLINE Arc<T> arc_by_doubling(Argument u, int doublings, const T& m, const T& m1) {
  Arc<T> arc = series(Argument(std::ldexp(1.0, -doublings)) * u, m, m1);
  for (int i = 0; i < doublings; ++i) arc = doubled(arc, m, m1);
  return arc;
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // FLEXSLIP_FIBRE_ELLIPTIC_INL_H_
