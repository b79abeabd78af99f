#include "fibre/elastica.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fibre/dual.h"
#include "fibre/elliptic.h"

namespace flexslip {
namespace {

constexpr double largest_q = 20;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// The line of the support force, at the angle β0 to the fibre's tangent there: cot β0 = -q.
struct ForceLine {
  double s0, c0;                // sin β0, cos β0
  EllipticParameter parameter;  // m = sin^2(β0/2)
};

ForceLine force_line(double q) {
  const double h = std::sqrt(1 + q * q);
  const double s0 = 1 / h;
  const double larger = 0.5 * (1 + std::abs(q) / h);
  const double smaller = 0.25 * s0 * s0 / larger;
  return {s0, -q / h, q >= 0 ? EllipticParameter{larger, smaller} : EllipticParameter{smaller, larger}};
}

// The half fibre from the support to midspan, in units in which its arc length is u. With a the half span,
// S = u/a; everything else is a function of a, z, and the angle b of the force line at midspan.
template <class T>
struct HalfFibre {
  T gap;    // u - a: arc length less half span, of order u^5 s0^2/15
  T z;      // deflection at midspan
  T V;      // ∫ sd^2: bending energy, U = 2 (u/S) s0^2 V
  T sin_b;  // F = 8 (u/S)^2 sin b
  T x, y;   // sine and cosine of θ0/2
  T sd;     // sn/dn
};

template <class T>
struct Arc {
  T sn, cn, dn, one_minus_cn, P, R;
};

template <class T>
HalfFibre<T> half_fibre(double u, T s0, T c0, T m, T m1, const Arc<T>& arc) {
  const T p = s0 * arc.P;             // ∫ sin ψ, ψ = θ0 - θ being the angle turned since the support
  const T r = 0.5 * s0 * s0 * arc.R;  // ∫ (1 - cos ψ)
  const T x = 0.5 * s0 * arc.one_minus_cn / arc.dn;
  const T y = (m1 + m * arc.cn) / arc.dn;
  const T sin_theta0 = 2.0 * x * y;
  const T versine = 2.0 * x * x;  // 1 - cos θ0
  const T cos_theta0 = 1.0 - versine;
  return {.gap = u * versine + cos_theta0 * r - sin_theta0 * p,
          .z = sin_theta0 * (u - r) - cos_theta0 * p,
          .V = 2.0 * arc.P - c0 * arc.R,
          .sin_b = s0 * arc.cn / (arc.dn * arc.dn),
          .x = x,
          .y = y,
          .sd = arc.sn / arc.dn};
}

HalfFibre<double> half_fibre(double u, const ForceLine& line) {
  const auto arc = elliptic_arc(u, line.parameter);
  return half_fibre<double>(u, line.s0, line.c0, line.parameter.m, line.parameter.m1,
                            {arc.sn, arc.cn, arc.dn, arc.one_minus_cn, arc.P, arc.R});
}

// With derivatives with respect to β0 at fixed u: dm = (s0/2) dβ0.
HalfFibre<Dual> half_fibre_slopes(double u, const ForceLine& line) {
  const auto [value, d_m] = elliptic_arc_slope(u, line.parameter);
  const double m_beta = 0.5 * line.s0;
  const auto dual = [m_beta](double v, double d) { return Dual{v, m_beta * d}; };
  return half_fibre<Dual>(u, {line.s0, line.c0}, {line.c0, -line.s0}, {line.parameter.m, m_beta},
                          {line.parameter.m1, -m_beta},
                          {dual(value.sn, d_m.sn), dual(value.cn, d_m.cn), dual(value.dn, d_m.dn),
                           dual(value.one_minus_cn, d_m.one_minus_cn), dual(value.P, d_m.P), dual(value.R, d_m.R)});
}

// 1 - 1/S, of order u^4, with its derivatives in u.
struct Drawn {
  static constexpr int order = 4;
  double value, slope, curvature;
  Drawn(double u, const ForceLine& line, const HalfFibre<double>& half) {
    const double bend = line.s0 * half.sd;  // dθ0/du, whose own slope is sin b
    value = half.gap / u;
    slope = (bend * half.z - value) / u;
    curvature = (half.sin_b * half.z + bend * bend * (u - half.gap) - 2 * slope) / u;
  }
};

// The deflection w, of order u^2, likewise; infinite from the pole of S on, where the half span a is zero.
struct Deflection {
  static constexpr int order = 2;
  double value, slope, curvature;
  Deflection(double u, const ForceLine& line, const HalfFibre<double>& half) {
    const double bend = line.s0 * half.sd;
    const double a = u - half.gap;
    const double z = half.z;
    const double a_u = 1 - bend * z;
    const double numerator_u = half.sin_b * (a * a + z * z) + bend * a;
    value = a > 0 ? z / (2 * a) : infinity;
    slope = (bend * (a * a + z * z) - z) / (2 * a * a);
    curvature = numerator_u / (2 * a * a) - 2 * slope * a_u / a;
  }
};

struct Phase {
  bool exists;
  double u;
  HalfFibre<double> half;
};

// The u in (0, K] at which a quantity that rises as u^order takes the value `target`, by Halley's iteration on its root of
// that order, which is nearly linear in u. If the quantity stays below the target, u is K, the end of the branch.
template <class Quantity>
Phase solve_phase(double target, double u, const ForceLine& line) {
  double K = infinity;  // until an iterate comes near it: K >= π/2 always
  const auto limited = [&](double candidate) {
    constexpr double least_K = 1.57;
    if (candidate > least_K && K == infinity) K = complete_elliptic(line.parameter).K;
    return std::min(candidate, K);
  };
  double low = 0;
  double high = infinity;
  u = limited(u);
  HalfFibre<double> half = half_fibre(u, line);
  // A step below 2^-20 u leaves, by cubic convergence, an error below the rounding. Bisection between bounds, which only
  // states near the end of the branch ever need, gains a bit a step: 60 steps suffice for it.
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Quantity quantity(u, line, half);
    if (quantity.value < target && u == K) break;
    (quantity.value < target ? low : high) = u;
    const double root = std::sqrt(target / quantity.value);
    constexpr int n = Quantity::order;
    const double miss = 1 - (n == 4 ? std::sqrt(root) : root);  // of the root of order n, relative
    const double rate = quantity.slope / (n * quantity.value);
    const double bend = quantity.curvature / (n * quantity.value) + (1 - n) * rate * rate;
    const double next = u - miss * rate / (rate * rate - 0.5 * miss * bend);
    const bool last = std::abs(next - u) <= 0x1p-20 * u;
    u = last || (next > low && next < high) ? limited(next) : 0.5 * (low + std::min(high, K));
    half = half_fibre(u, line);
    if (last) break;
  }
  // At the end of the branch the quantity is known to its own rounding and the target to that of S.
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return {.exists = u < K || target <= Quantity(u, line, half).value * (1 + 6 * epsilon) + 2 * epsilon,
          .u = u,
          .half = half};
}

// Expansion of u^2 in sqrt(1 - 1/S) to first order, continued by a fit: within 0.1 % (median) for q in [-1, 2], S < 1.55.
double guess_phase(double drawn, const ForceLine& line) {
  const double t0 = std::sqrt(15 * drawn) / line.s0;
  const double a = line.c0 * t0;
  const double b = line.s0 * t0;
  return std::sqrt(t0 / std::max(1 - (2.0 / 21.0) * a - 0.0193 * b * b - 0.0032 * a * a, 0.5));
}

void require_q(double q) {
  if (!(std::abs(q) <= largest_q))
    throw std::invalid_argument("mobilised friction q = " + std::to_string(q) + " is outside [-20, 20]");
}

void require_S(double S) {
  if (!(S >= 1 && S < infinity))
    throw std::invalid_argument("length between the supports S = " + std::to_string(S) + " is not in [1, inf)");
}

FibreState straight(double q) {
  return {.status = FibreStatus::ok, .S = 1, .q = q, .w = 0, .F = 0, .theta0 = 0, .Pn = 0, .U = 0, .u = 0};
}

FibreState no_state(FibreStatus status, double S, double q, double w, double F) {
  constexpr double nan = not_a_number;
  return {.status = status, .S = S, .q = q, .w = w, .F = F, .theta0 = nan, .Pn = nan, .U = nan, .u = nan};
}

FibreState assemble(double S, double q, double u, const ForceLine& line, const HalfFibre<double>& half) {
  const double a = u / S;
  return {.status = FibreStatus::ok,
          .S = S,
          .q = q,
          .w = half.z / (2 * a),                       // (4.18)
          .F = 8 * a * a * std::max(half.sin_b, 0.0),  // (4.22); u = K rounds to either side of F = 0
          .theta0 = 2 * std::atan2(half.x, half.y),
          .Pn = 4 * a * a * line.s0,  // (4.15b)
          .U = 2 * a * line.s0 * line.s0 * half.V,
          .u = u};
}

}  // namespace

FibreState fibre_state(double S, double q) {
  require_S(S);
  require_q(q);
  if (S == 1) return straight(q);
  const ForceLine line = force_line(q);
  const double drawn = (S - 1) / S;
  const auto [exists, u, half] = solve_phase<Drawn>(drawn, guess_phase(drawn, line), line);
  if (!exists) return no_state(FibreStatus::beyond_branch, S, q, not_a_number, not_a_number);
  return assemble(S, q, u, line, half);
}

namespace {

// The slopes at a state with phase u.
FibreSlopes slopes_at(double S, double q, double u) {
  const ForceLine line = force_line(q);
  const auto half = half_fibre_slopes(u, line);
  const auto [s0, c0, parameter] = line;
  const double a = u / S;
  const double sd = half.sd.v;
  const double z = half.z.v;
  const double sin_b = half.sin_b.v;

  // Along the fibre dθ/du = s0 sd, so that midspan moves by da = (1 - s0 sd z) du and dz = s0 sd a du.
  const double bend = s0 * sd;
  const double z_u = bend * a;
  const double sin_b_u = -bend * (c0 + 0.5 * bend * bend);  // cos b = cos β0 + (dβ/du)^2/2
  const double V_u = sd * sd;
  // Motion of u: from 1 - 1/S = D(u, β0) at fixed β0, and at fixed S.
  const double D_u = (bend * z - half.gap.v / u) / u;
  const double u_S = 1 / (S * S * D_u);
  const double u_beta = -(half.gap.d / u) / D_u;
  const double a_S = (u_S - a) / S;
  const double a_beta = u_beta / S;
  const double beta_q = s0 * s0;

  const double z_beta = half.z.d + z_u * u_beta;
  const double sin_b_beta = half.sin_b.d + sin_b_u * u_beta;
  const double V_beta = half.V.d + V_u * u_beta;
  const double theta0_beta = 2 * (half.x.d * half.y.v - half.x.v * half.y.d) + bend * u_beta;  // θ0 = 2 atan2(x, y)
  return {.w_S = (z_u * u_S - z / a * a_S) / (2 * a),
          .w_q = beta_q * (z_beta - z / a * a_beta) / (2 * a),
          .F_S = 8 * a * (2 * a_S * sin_b + a * sin_b_u * u_S),
          .F_q = beta_q * 8 * a * (2 * a_beta * sin_b + a * sin_b_beta),
          .Pn_S = 8 * a * s0 * a_S,
          .Pn_q = beta_q * 4 * a * (2 * a_beta * s0 + a * c0),
          .U_S = 2 * s0 * s0 * (a_S * half.V.v + a * V_u * u_S),
          .U_q = beta_q * 2 * s0 * (a_beta * s0 * half.V.v + a * (2 * c0 * half.V.v + s0 * V_beta)),
          .theta0_S = bend * u_S,
          .theta0_q = beta_q * theta0_beta};
}

}  // namespace

FibreStateSlopes fibre_state_slopes(double S, double q) {
  const FibreState state = fibre_state(S, q);
  if (state.status != FibreStatus::ok || S == 1) {
    constexpr double nan = not_a_number;
    return {state, {nan, nan, nan, nan, nan, nan, nan, nan, nan, nan}};
  }
  return {state, slopes_at(S, q, state.u)};
}

FibreState fibre_state_from_force(double w, double F) {
  if (!(w >= 0 && w < infinity))
    throw std::invalid_argument("deflection w = " + std::to_string(w) + " is not in [0, inf)");
  if (!(F >= 0 && F < infinity)) throw std::invalid_argument("force F = " + std::to_string(F) + " is not in [0, inf)");
  if (w == 0 && F == 0) return straight(0);
  constexpr double least_w = 1e-8;  // below it S rounds to 1
  if (w < least_w) return no_state(FibreStatus::no_friction, not_a_number, not_a_number, w, F);

  // Along w = const the force rises strictly with q (the Jacobian of Ψ is positive): a bracketed Newton iteration in q,
  // carrying u along. To begin with, F = 48 w (1 + 2.1 q w - 7 w^2), a fit up to w = 0.3. The bracket is a little wider than the domain, so
  // that states on its border are found from either side.
  constexpr double border = 1e-6;
  double low = -largest_q * (1 + 2 * border);
  double high = -low;
  double q = std::clamp((F / (48 * w) - 1 + 7 * w * w) / (2.1 * w), -1.0, 2.0);
  double u = std::sqrt(6 * w / force_line(q).s0);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const ForceLine line = force_line(q);
    const auto [exists, phase, half] = solve_phase<Deflection>(w, u, line);
    u = phase;
    const double a = u - half.gap;
    const double S = u / a;
    const double force =
        exists ? 8 * a * a * half.sin_b : -1;  // the branch ends short of w: only a larger q reaches it
    (force < F ? low : high) = q;
    double newton = 0.5 * (low + high);
    bool last = high - low <= 0x1p-52 * (1 + std::abs(q));
    if (exists) {
      const auto slopes = slopes_at(S, q, u);
      const double F_q = slopes.F_q - slopes.F_S * slopes.w_q / slopes.w_S;  // along w = const
      const double step = (F - force) / F_q;
      last = last || std::abs(step) <= 0x1p-26 * (1 + std::abs(q));  // what remains is of the order of its square
      if (last || (q + step > low && q + step < high)) newton = q + step;
    }
    q = newton;
    if (last) break;
  }
  if (std::abs(q) <= largest_q * (1 + border)) {
    q = std::clamp(q, -largest_q, largest_q);
    const ForceLine line = force_line(q);
    const auto [exists, phase, half] = solve_phase<Deflection>(w, u, line);
    if (exists && phase > half.gap) return assemble(phase / (phase - half.gap), q, phase, line, half);
  }
  return no_state(FibreStatus::no_friction, not_a_number, not_a_number, w, F);
}

BranchEnd fibre_branch_end(double q) {
  require_q(q);
  const ForceLine line = force_line(q);
  const double K = complete_elliptic(line.parameter).K;
  const auto half = half_fibre(K, line);
  const double a = K - half.gap;
  if (a <= 0) return {.S = infinity, .w = infinity, .u = K};
  return {.S = K / a, .w = half.z / (2 * a), .u = K};
}

ShapePoint fibre_shape(const FibreState& state, double s) {
  if (state.status != FibreStatus::ok) throw std::invalid_argument("no shape: the state does not exist");
  if (!(s >= 0 && s <= 1))
    throw std::invalid_argument("fraction of the arc length s = " + std::to_string(s) + " is not in [0, 1]");
  if (s > 0.5) {
    const auto mirrored = fibre_shape(state, 1 - s);
    return {1 - mirrored.x, mirrored.y, -mirrored.theta};
  }
  if (state.u == 0) return {s, 0, 0};
  const ForceLine line = force_line(state.q);
  const double v = 2 * state.u * s;
  const auto arc = elliptic_arc(v, line.parameter);
  const double p = line.s0 * arc.P;
  const double r = 0.5 * line.s0 * line.s0 * arc.R;
  const double psi = 2 * std::atan2(0.5 * line.s0 * arc.one_minus_cn, line.parameter.m1 + line.parameter.m * arc.cn);
  const double sine = std::sin(state.theta0);
  const double cosine = std::cos(state.theta0);
  const double scale = state.S / (2 * state.u);  // (4.17): arc length per unit of phase
  return {.x = scale * (cosine * (v - r) + sine * p),
          .y = scale * (sine * (v - r) - cosine * p),
          .theta = state.theta0 - psi};
}

}  // namespace flexslip
