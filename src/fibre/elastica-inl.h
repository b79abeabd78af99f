// The state of elastica.h for any number type of lanes-inl.h. Included once for each instruction
// set.
#if defined(FLEXSLIP_FIBRE_ELASTICA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FLEXSLIP_FIBRE_ELASTICA_INL_H_
#undef FLEXSLIP_FIBRE_ELASTICA_INL_H_
#else
#define FLEXSLIP_FIBRE_ELASTICA_INL_H_
#endif

#include "fibre/elliptic-inl.h"

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

// The line of the support force, at the angle β0 to the tangent of the specimen: cot β0 = -q.
template <class T>
struct ForceLine {
  T s0, c0;  // sin β0, cos β0
  T m, m1;   // sin^2(β0/2), cos^2(β0/2)
};

template <class T>
HWY_INLINE ForceLine<T> force_line(T q) {
  const T s0 = reciprocal(sqrt(1.0 + q * q));
  const T larger = 0.5 * (1.0 + abs(q) * s0);
  const T smaller = 0.25 * s0 * s0 / larger;
  const auto negative = q < 0.0;
  return {s0, -(q * s0), choose(negative, smaller, larger), choose(negative, larger, smaller)};
}

// The half specimen from the support to midspan, in units in which its arc length is u. With a the
// half span, S = u/a. Everything else is a function of a, z, and the angle b of the force line at
// midspan.
template <class T>
struct HalfFibre {
  T gap;    // u - a: arc length minus half span, of order u^5 s0^2/15
  T z;      // deflection at midspan
  T V;      // ∫ sd^2: bending energy, U = 2 (u/S) s0^2 V
  T sin_b;  // F = 8 (u/S)^2 sin b
  T x, y;   // sine and cosine of θ0/2
  T sd;     // sn/dn
};

template <class T, class Argument>
HWY_INLINE HalfFibre<T> half_fibre(Argument u, const T& s0, const T& c0, const T& m, const T& m1, const Arc<T>& arc) {
  const T dn2 = m1 + m * (arc.cn * arc.cn);
  const T per_dn2 = reciprocal(dn2);
  const T per_dn = sqrt(dn2) * per_dn2;
  const T sn = sqrt(arc.one_minus_cn * (1.0 + arc.cn));
  const T p = s0 * arc.P;             // ∫ sin ψ, where ψ = θ0 - θ is the rotation since the support
  const T r = 0.5 * s0 * s0 * arc.R;  // ∫ (1 - cos ψ)
  const T x = 0.5 * s0 * arc.one_minus_cn * per_dn;
  const T y = (m1 + m * arc.cn) * per_dn;
  const T sin_theta0 = 2.0 * x * y;
  const T versine = 2.0 * x * x;  // 1 - cos θ0
  const T cos_theta0 = 1.0 - versine;
  return {.gap = u * versine + cos_theta0 * r - sin_theta0 * p,
          .z = sin_theta0 * (u - r) - cos_theta0 * p,
          .V = 2.0 * arc.P - c0 * arc.R,
          .sin_b = s0 * arc.cn * per_dn2,
          .x = x,
          .y = y,
          .sd = sn * per_dn};
}

// The half specimen after a small change of its phase, by a Taylor expansion: dθ/du = s0 sd, whose
// derivative is sin b.
template <class T>
struct Bend {
  T along;  // s0 sd
  T cos_b;  // cos b = cos β0 + along^2/2
  HWY_INLINE Bend(const ForceLine<T>& line, const HalfFibre<T>& half)
      : along(line.s0 * half.sd), cos_b(line.c0 + 0.5 * along * along) {}
};

// A state in the common range, by one evaluation of the kernel and no branch. The guess of the
// phase u is right to 1e-6. One step of Halley's iteration corrects it to rounding, and a Taylor
// expansion corrects what depends on it.
template <class T>
struct CommonState {
  T u;                // [1] half the phase of the pendulum
  T step;             // [1] from the guess
  T w, F;             // [L], [EI/L^2]
  HalfFibre<T> half;  // at the guess, u - step
};

template <class T>
HWY_INLINE T common_phase_guess(const T& root_shortening, const T& q, const ForceLine<T>& line) {
  // (b/s0)/u^2 is a function of b^2 = 15 (1 - 1/S) and a = -q b, analytic at 0. In u itself it is a
  // polynomial of weighted degree 10, fitted to 6.4e-7 for S <= 2.16, q in [-1.2, 3], u <= 2.05.
  const T b = 3.872983346207417 * root_shortening;
  const T a = -q * b;
  const T X = b * b;
  const T p0 =
      1.00000064 +
      a * (-0.04761914438 +
           a * (-0.003969961351 +
                a * (-0.0005960474752 +
                     a * (-0.0001088375848 +
                          a * (-2.347308168e-05 +
                               a * (-5.796106191e-06 +
                                    a * (-1.241137533e-06 +
                                         a * (-1.779729647e-07 + a * (-1.439023073e-08 + a * -4.938346039e-10)))))))));
  const T p1 = -0.008928973034 +
               a * (-0.0009062830352 +
                    a * (-0.0002149007278 +
                         a * (-5.238791186e-05 +
                              a * (-1.569267915e-05 +
                                   a * (-4.713949229e-06 +
                                        a * (-9.246485816e-07 + a * (-9.528996936e-08 + a * -3.931627576e-09)))))));
  const T p2 =
      -0.0001742328805 +
      a * (-3.873952775e-05 +
           a * (-1.201491974e-05 +
                a * (-5.596081877e-06 + a * (-1.785239027e-06 + a * (-2.615844876e-07 + a * -1.389125762e-08)))));
  const T p3 =
      -5.67385176e-06 + a * (-1.594264893e-06 + a * (-1.380587575e-06 + a * (-3.588644863e-07 + a * -2.732496153e-08)));
  const T p4 = -1.455664079e-07 + a * (-2.265500931e-07 + a * -3.037183699e-08);
  const T p5 = -2.232341503e-08;
  return sqrt(b / line.s0) / (p0 + X * (p1 + X * (p2 + X * (p3 + X * (p4 + X * p5)))));
}

// Domain:     any; valid if is_common() is true.
template <class T>
HWY_INLINE CommonState<T> common_state(const T& S, const T& q, const ForceLine<T>& line) {
  const T per_S = reciprocal(S);
  const T shortening = (S - 1.0) * per_S;
  const T guess = common_phase_guess<T>(sqrt(shortening), q, line);
  const auto arc = arc_by_doubling<T>(guess, common_doublings, line.m, line.m1);
  const auto half = half_fibre<T>(guess, line.s0, line.c0, line.m, line.m1, arc);
  const Bend<T> bend(line, half);
  const T z = half.z;
  const T a = guess - half.gap;
  const T B = bend.along;

  // The root of gap/u - shortening.
  const T per_guess = reciprocal(guess);
  const T value = half.gap * per_guess;
  const T slope = (B * z - value) * per_guess;
  const T curvature = (half.sin_b * z + B * B * a - 2.0 * slope) * per_guess;
  const T miss = (shortening - value) * slope;
  const T step = miss / (slope * slope + 0.5 * (shortening - value) * curvature);

  const T z_step = step * (B * a + 0.5 * step * (half.sin_b * a + B * (1.0 - B * z)));
  const T sin_b_step = -(step * (B * bend.cos_b + 0.5 * step * (half.sin_b * (bend.cos_b + B * B))));
  const T u = guess + step;
  const T half_span = u * per_S;
  return {.u = u,
          .step = step,
          .w = (z + z_step) / (2.0 * half_span),                         // (4.18)
          .F = 8.0 * half_span * half_span * (half.sin_b + sin_b_step),  // (4.22)
          .half = half};
}

// True if the state is valid: the guess suffices for Halley's iteration and the Taylor expansion,
// the series is within its limit, and the end of the branch (F = 0) is far away.
template <class T>
HWY_INLINE auto is_common(const T& S, const CommonState<T>& state) {
  constexpr double largest_step = 0x1p-18;
  return (T(1.0) < S) & (abs(state.step) < largest_step * state.u) & (state.u < T(common_limit)) &
         (T(0.05) < state.half.sin_b);
}

// Partial derivatives with respect to S at fixed q, and to q at fixed S.
template <class T>
struct StateSlopes {
  T w_S, w_q, F_S, F_q, Pn_S, Pn_q, U_S, U_q, theta0_S, theta0_q;
};

// Slopes at a state with phase u within the doublings; exact, by a dual number for β0.
template <class T>
HWY_INLINE StateSlopes<T> state_slopes(const T& S, const T& u, const ForceLine<T>& line, int doublings) {
  const auto [s0, c0, m, m1] = line;
  const T m_beta = 0.5 * s0;
  const Dual<T> dual_m{m, m_beta};
  const Dual<T> dual_m1{m1, -m_beta};
  const auto arc = arc_by_doubling<Dual<T>>(u, doublings, dual_m, dual_m1);
  const auto half = half_fibre<Dual<T>>(u, {s0, c0}, {c0, -s0}, dual_m, dual_m1, arc);
  const T a = u / S;
  const T sd = half.sd.v;
  const T z = half.z.v;
  const T sin_b = half.sin_b.v;

  // As dθ/du = s0 sd, midspan moves by da = (1 - s0 sd z) du and dz = s0 sd a du.
  const T bend = s0 * sd;
  const T z_u = bend * a;
  const T sin_b_u = -(bend * (c0 + 0.5 * bend * bend));  // cos b = cos β0 + (dβ/du)^2/2
  const T V_u = sd * sd;
  // Derivatives of u: from 1 - 1/S = D(u, β0) at fixed β0, and at fixed S.
  const T D_u = (bend * z - half.gap.v / u) / u;
  const T u_S = 1.0 / (S * S * D_u);
  const T u_beta = -(half.gap.d / u) / D_u;
  const T a_S = (u_S - a) / S;
  const T a_beta = u_beta / S;
  const T beta_q = s0 * s0;

  const T z_beta = half.z.d + z_u * u_beta;
  const T sin_b_beta = half.sin_b.d + sin_b_u * u_beta;
  const T V_beta = half.V.d + V_u * u_beta;
  // θ0 = 2 atan2(x, y)
  const T theta0_beta = 2.0 * (half.x.d * half.y.v - half.x.v * half.y.d) + bend * u_beta;
  return {.w_S = (z_u * u_S - z / a * a_S) / (2.0 * a),
          .w_q = beta_q * (z_beta - z / a * a_beta) / (2.0 * a),
          .F_S = 8.0 * a * (2.0 * a_S * sin_b + a * sin_b_u * u_S),
          .F_q = beta_q * 8.0 * a * (2.0 * a_beta * sin_b + a * sin_b_beta),
          .Pn_S = 8.0 * a * s0 * a_S,
          .Pn_q = beta_q * 4.0 * a * (2.0 * a_beta * s0 + a * c0),
          .U_S = 2.0 * s0 * s0 * (a_S * half.V.v + a * V_u * u_S),
          .U_q = beta_q * 2.0 * s0 * (a_beta * s0 * half.V.v + a * (2.0 * c0 * half.V.v + s0 * V_beta)),
          .theta0_S = bend * u_S,
          .theta0_q = beta_q * theta0_beta};
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // FLEXSLIP_FIBRE_ELASTICA_INL_H_
