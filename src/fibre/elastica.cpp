#include "fibre/elastica.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fibre/elastica-inl.h"
#include "fibre/elliptic.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

using HWY_NAMESPACE::arc_by_doubling;
using HWY_NAMESPACE::Bend;
using HWY_NAMESPACE::common_state;
using HWY_NAMESPACE::doublings_for;
using HWY_NAMESPACE::force_line;
using HWY_NAMESPACE::ForceLine;
using HWY_NAMESPACE::half_fibre;
using HWY_NAMESPACE::HalfFibre;
using HWY_NAMESPACE::is_common;
using HWY_NAMESPACE::state_slopes;

double end_of_branch(const ForceLine<double>& line) { return complete_elliptic({line.m, line.m1}).K; }

HalfFibre<double> half_fibre_at(double u, const ForceLine<double>& line) {
  return half_fibre<double>(u, line.s0, line.c0, line.m, line.m1,
                            arc_by_doubling<double>(u, doublings_for(u), line.m, line.m1));
}

// 1 - 1/S, of order u^4, with its derivatives in u.
struct Shortening {
  static constexpr int order = 4;
  double value, slope, curvature;
  Shortening(double u, const ForceLine<double>& line, const HalfFibre<double>& half) {
    const double bend = line.s0 * half.sd;  // dθ0/du, whose derivative is sin b
    value = half.gap / u;
    slope = (bend * half.z - value) / u;
    curvature = (half.sin_b * half.z + bend * bend * (u - half.gap) - 2 * slope) / u;
  }
};

// The deflection w, of order u^2, with its derivatives; infinite from the pole of S, where the half
// span a is zero.
struct Deflection {
  static constexpr int order = 2;
  double value, slope, curvature;
  Deflection(double u, const ForceLine<double>& line, const HalfFibre<double>& half) {
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

// The u in (0, K] at which a quantity of order u^order, increasing, equals `target`. Halley's
// iteration uses its root of this order, which is nearly linear in u. If the quantity stays below
// the target, u is K, the end of the branch.
template <class Quantity>
Phase solve_phase(double target, double u, const ForceLine<double>& line) {
  effort_spent += effort_of_general_state;
  double K = infinity;  // computed only near it: K >= π/2
  const auto limited = [&](double candidate) {
    constexpr double min_K = 1.57;
    if (candidate > min_K && K == infinity) K = end_of_branch(line);
    return std::min(candidate, K);
  };
  double low = 0;
  double high = infinity;
  u = limited(u);
  HalfFibre<double> half = half_fibre_at(u, line);
  // The convergence is cubic, so a step below 2^-20 u leaves an error below rounding. Bisection,
  // needed only near the end of the branch, gains a bit a step; 60 steps suffice.
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Quantity quantity(u, line, half);
    if (quantity.value < target && u == K) break;
    (quantity.value < target ? low : high) = u;
    const double root = std::sqrt(target / quantity.value);
    constexpr int n = Quantity::order;
    // relative error of the root of order n
    const double miss = 1 - (n == 4 ? std::sqrt(root) : root);
    const double rate = quantity.slope / (n * quantity.value);
    const double bend = quantity.curvature / (n * quantity.value) + (1 - n) * rate * rate;
    const double next = u - miss * rate / (rate * rate - 0.5 * miss * bend);
    const bool last = std::abs(next - u) <= 0x1p-20 * u;
    u = last || (next > low && next < high) ? limited(next) : 0.5 * (low + std::min(high, K));
    half = half_fibre_at(u, line);
    if (last) break;
  }
  // At the end of the branch the quantity is known to its rounding, the target to the rounding of
  // S.
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return {.exists = u < K || target <= Quantity(u, line, half).value * (1 + 6 * epsilon) + 2 * epsilon,
          .u = u,
          .half = half};
}

// Expansion of u^2 in sqrt(1 - 1/S) to first order, continued by a fit: to 0.1 % (median) for q in
// [-1, 2], S < 1.55.
double guess_phase(double shortening, const ForceLine<double>& line) {
  const double t0 = std::sqrt(15 * shortening) / line.s0;
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

FibreState assemble(double S, double q, double u, const ForceLine<double>& line, const HalfFibre<double>& half) {
  const double a = u / S;
  return {.status = FibreStatus::ok,
          .S = S,
          .q = q,
          .w = half.z / (2 * a),  // (4.18)
          // (4.22); at u = K rounding may make F negative
          .F = 8 * a * a * std::max(half.sin_b, 0.0),
          .theta0 = 2 * elementary::angle(half.x, half.y),
          .Pn = 4 * a * a * line.s0,  // (4.15b)
          .U = 2 * a * line.s0 * line.s0 * half.V,
          .u = u};
}

// The general case, including the end of the branch.
FibreState general_state(double S, double q, const ForceLine<double>& line) {
  const double shortening = (S - 1) / S;
  const auto [exists, u, half] = solve_phase<Shortening>(shortening, guess_phase(shortening, line), line);
  if (!exists) return no_state(FibreStatus::beyond_branch, S, q, not_a_number, not_a_number);
  return assemble(S, q, u, line, half);
}

}  // namespace

FibreState fibre_state(double S, double q) {
  require_S(S);
  require_q(q);
  if (S == 1) return straight(q);
  const ForceLine<double> line = force_line(q);
  const auto state = common_state<double>(S, q, line);
  if (!is_common(S, state)) return general_state(S, q, line);
  const auto& [u, step, w, F, half] = state;
  const Bend<double> bend(line, half);
  const double half_span = u / S;
  const double V = half.V + step * half.sd * (half.sd + step * half.sin_b / line.s0);
  return {.status = FibreStatus::ok,
          .S = S,
          .q = q,
          .w = w,
          .F = F,
          .theta0 = 2 * elementary::angle(half.x, half.y) + step * (bend.along + 0.5 * step * half.sin_b),
          .Pn = 4 * half_span * half_span * line.s0,  // (4.15b)
          .U = 2 * half_span * line.s0 * line.s0 * V,
          .u = u};
}

namespace {

FibreSlopes slopes_at(double S, double q, double u) {
  const auto slopes = state_slopes<double>(S, u, force_line(q), doublings_for(u));
  return {slopes.w_S,  slopes.w_q, slopes.F_S, slopes.F_q,      slopes.Pn_S,
          slopes.Pn_q, slopes.U_S, slopes.U_q, slopes.theta0_S, slopes.theta0_q};
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
  constexpr double min_w = 1e-8;  // below, S rounds to 1
  if (w < min_w) return no_state(FibreStatus::no_friction, not_a_number, not_a_number, w, F);

  // At constant w the force increases strictly with q, because the Jacobian of Ψ is positive. A
  // bracketed Newton iteration in q carries u along. It starts from F = 48 w (1 + 2.1 q w - 7 w^2),
  // a fit up to w = 0.3. The bracket exceeds the domain slightly, so that states on its border are
  // found from either side.
  constexpr double border = 1e-6;
  double low = -largest_q * (1 + 2 * border);
  double high = -low;
  double q = std::clamp((F / (48 * w) - 1 + 7 * w * w) / (2.1 * w), -1.0, 2.0);
  double u = std::sqrt(6 * w / force_line(q).s0);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const ForceLine<double> line = force_line(q);
    const auto [exists, phase, half] = solve_phase<Deflection>(w, u, line);
    u = phase;
    const double a = u - half.gap;
    const double S = u / a;
    // the branch ends below w; a larger q is needed
    const double force = exists ? 8 * a * a * half.sin_b : -1;
    (force < F ? low : high) = q;
    double newton = 0.5 * (low + high);
    bool last = high - low <= 0x1p-52 * (1 + std::abs(q));
    if (exists) {
      const auto slopes = slopes_at(S, q, u);
      const double F_q = slopes.F_q - slopes.F_S * slopes.w_q / slopes.w_S;  // at constant w
      const double step = (F - force) / F_q;
      // the remaining error is of second order
      last = last || std::abs(step) <= 0x1p-26 * (1 + std::abs(q));
      if (last || (q + step > low && q + step < high)) newton = q + step;
    }
    q = newton;
    if (last) break;
  }
  if (std::abs(q) <= largest_q * (1 + border)) {
    q = std::clamp(q, -largest_q, largest_q);
    const ForceLine<double> line = force_line(q);
    const auto [exists, phase, half] = solve_phase<Deflection>(w, u, line);
    if (exists && phase > half.gap) return assemble(phase / (phase - half.gap), q, phase, line, half);
  }
  return no_state(FibreStatus::no_friction, not_a_number, not_a_number, w, F);
}

BranchEnd fibre_branch_end(double q) {
  require_q(q);
  const ForceLine<double> line = force_line(q);
  const double K = end_of_branch(line);
  const auto half = half_fibre_at(K, line);
  const double a = K - half.gap;
  if (a <= 0) return {.S = infinity, .w = infinity, .u = K};
  return {.S = K / a, .w = half.z / (2 * a), .u = K};
}

double curvature_at_midspan(const FibreState& state) {
  if (state.status != FibreStatus::ok) throw std::invalid_argument("no curvature: the state does not exist");
  const double half = elementary::sine_and_cosine(0.5 * state.theta0).sine;
  const double square = 2 * state.Pn * (elementary::sine_and_cosine(state.theta0).sine + 2 * state.q * half * half);
  return std::sqrt(std::max(square, 0.0));
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
  const ForceLine<double> line = force_line(state.q);
  const auto turned = [&](const EllipticArc& arc) {
    return 2 * elementary::angle(0.5 * line.s0 * arc.one_minus_cn, line.m1 + line.m * arc.cn);
  };
  const double v = 2 * state.u * s;
  const EllipticParameter parameter{line.m, line.m1};
  const auto arc = elliptic_arc(v, parameter);
  const double p = line.s0 * arc.P;
  const double r = 0.5 * line.s0 * line.s0 * arc.R;
  const auto [sine, cosine] = elementary::sine_and_cosine(state.theta0);
  const double scale = state.S / (2 * state.u);  // (4.17): arc length per unit of phase
  return {.x = scale * (cosine * (v - r) + sine * p),
          .y = scale * (sine * (v - r) - cosine * p),
          // none left at midspan
          .theta = state.theta0 * (1 - turned(arc) / turned(elliptic_arc(state.u, parameter)))};
}

}  // namespace flexslip
