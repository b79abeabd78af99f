#include "fibre/supported_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "fibre/elliptic.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The angle between the force at a support and the tangent, as in elastica-inl.h: cot β0 = -q.
struct ForceAngle {
  double sine, cosine;
  double m, m1;  // sin²(β0/2), cos²(β0/2)
};

ForceAngle force_angle(double q) {
  const double sine = 1 / std::sqrt(1 + q * q);
  const double larger = 0.5 * (1 + std::abs(q) * sine), smaller = 0.25 * sine * sine / larger;
  return {sine, -q * sine, q < 0 ? smaller : larger, q < 0 ? larger : smaller};
}

// An angle by its sine, cosine and 1 - cosine, from the tangent y/x of its half.
struct Turn {
  double x, y;  // of any common length
  double sine, versine, cosine;

  Turn(double along, double across) : x(along), y(across) {
    const double per_square = 1 / (x * x + y * y);
    sine = 2 * x * y * per_square;
    versine = 2 * y * y * per_square;
    cosine = 1 - versine;
  }
  double angle() const { return 2 * elementary::angle(y, x); }
  Turn less(const Turn& other) const { return {x * other.x + y * other.y, y * other.x - x * other.y}; }
};

// Integrals over the phase from the inflection: of 1 - cos θ, sin θ and the squared curvature, with
// θ the angle to the span at the inflection.
struct Integrals {
  double gap, rise, squares;
};

// The pendulum: its parameter and the slope at its inflection.
struct Pendulum {
  double m, m1;
  double amplitude;  // 2 √(m m1): the curvature divided by sd, in units of the rate

  Turn turn(const EllipticArc& arc) const { return {m1 + m * arc.cn, 0.5 * amplitude * arc.one_minus_cn}; }
  double dn2(const EllipticArc& arc) const { return m1 + m * arc.cn * arc.cn; }
  double sd(const EllipticArc& arc) const { return arc.sn / arc.dn; }
  Integrals integrals(double phase, const EllipticArc& arc, const Turn& theta) const {
    const double p = amplitude * arc.P, r = 0.5 * amplitude * amplitude * arc.R;
    return {phase * theta.versine + theta.cosine * r - theta.sine * p, theta.sine * (phase - r) - theta.cosine * p,
            2 * arc.P - (m1 - m) * arc.R};
  }
};

struct ContactPhase {
  double v;
  EllipticArc arc;
};

// The phase in [0, K) at which sd = value.
ContactPhase phase_of(double value, const Pendulum& pendulum) {
  const EllipticParameter parameter{pendulum.m, pendulum.m1};
  // The inverse series of sd. For large values, fewer terms stay below K.
  const double square = value * value, c = pendulum.m1 - pendulum.m;
  const double fifth = square < 0.1 ? (3 * c * c + 4 * pendulum.m * pendulum.m1) / 40 : 0;
  double v = value * (1 + square * (c / 6 + square * fifth));
  EllipticArc arc = nearby_arc(v, parameter);
  for (int i = 0; i < 30; ++i) {
    const double step = (value - pendulum.sd(arc)) * pendulum.dn2(arc) / arc.cn;
    if (std::abs(step) <= epsilon * v) break;
    v = std::max(v + step, 0.5 * v);
    arc = nearby_arc(v, parameter);
    constexpr double small = 1e-8;  // of a step; the next is of the order of its square
    if (std::abs(step) <= small * v) break;
  }
  return {v, arc};
}

// The half specimen for a phase u between contact and midspan and a half span a, in units in which
// the arc length is u.
struct SupportedHalf {
  double gap, rise;    // u minus its projection on the span; deflection below the contact
  Turn theta0;         // slope at the contact
  double sin_b;        // of the force line at midspan
  double squares;      // ∫ (curvature/2a)²
  double curvature;    // [2a] at midspan
  double at_contact;   // [2a] curvature there
  double phase_slope;  // derivative of the contact phase in a
};

std::optional<SupportedHalf> half_of(double u, double a, const ForceAngle& angle, const Supports& supports) {
  const double e = -2 * a * supports.half_depth * angle.cosine;  // curvature at the contact [2a]
  const double m = angle.m + 0.25 * e * e, m1 = angle.m1 - 0.25 * e * e;
  if (!(m1 > 0)) return std::nullopt;
  const Pendulum pendulum{m, m1, 2 * std::sqrt(m * m1)};
  const double at_contact = std::abs(e) / pendulum.amplitude;
  if (!(at_contact * std::sqrt(m1) < 0.999)) return std::nullopt;  // of the maximum of sd
  const double side = e < 0 ? -1 : 1;
  const auto [v0, contact] = phase_of(at_contact, pendulum);
  const double v1 = side * v0 + u;
  // The force is positive up to K. The map is smooth there and extrapolated beyond.
  if (!(v1 > 0 && (v1 < 0.5 * std::numbers::pi || v1 <= 1.8 * complete_elliptic({m, m1}).K))) return std::nullopt;
  const EllipticArc middle = elliptic_arc(v1, {m, m1});
  const Turn theta = pendulum.turn(middle);  // at the inflection
  const Integrals whole = pendulum.integrals(v1, middle, theta), before = pendulum.integrals(v0, contact, theta);
  return SupportedHalf{.gap = whole.gap - side * before.gap,
                       .rise = whole.rise - side * before.rise,
                       .theta0 = theta.less(pendulum.turn(contact)),
                       .sin_b = pendulum.amplitude * middle.cn / pendulum.dn2(middle),
                       .squares = pendulum.amplitude * pendulum.amplitude * (whole.squares - side * before.squares),
                       .curvature = pendulum.amplitude * pendulum.sd(middle),
                       .at_contact = e,
                       .phase_slope = e * pendulum.dn2(contact) / (a * pendulum.amplitude * contact.cn)};
}

SupportedState state_of(const SupportedHalf& half, double u, double a, const ForceAngle& angle, double q,
                        const Supports& supports) {
  const double R = supports.radius + supports.half_depth;
  const Turn& slope = half.theta0;
  const double X = u - half.gap, theta0 = slope.angle();
  const double beyond = (half.gap - 2 * R * u * slope.sine) / X;  // S - 1
  const bool leans = theta0 < 0.5 * std::numbers::pi;
  const double imaged = R == 0 ? 1 + beyond : leans ? 1 + beyond + 2 * R * slope.sine / slope.cosine : not_a_number;
  return {.status = FibreStatus::ok,
          .length = 1 + beyond,
          .slid = beyond + 2 * supports.radius * theta0,
          .imaged = imaged,
          .q = q,
          .w = half.rise / (2 * a) + R * slope.versine,
          .F = 8 * a * a * half.sin_b,
          .theta0 = theta0,
          .Pn = 4 * a * a * angle.sine,
          .U = 2 * a * half.squares,
          .curvature = 2 * a * half.curvature};
}

// The guess of phase and half span at a deflection. On knife edges it is right to 0.1 % (median)
// for q in [-1, 2], w < 0.4, and to first order in radius and depth. At larger deflections it is
// small, so that Newton's iteration approaches from below.
PhaseAndSpan guess_of(double w, double q, const ForceAngle& angle, const Supports& supports) {
  const double R = supports.radius + supports.half_depth, theta0 = 3 * w;
  const double ell = 1 - 2 * R * theta0, lever = 1 - 3 * q * supports.half_depth;
  const double w1 = (w - 0.5 * R * theta0 * theta0) / ell;
  if (!(w < 0.4 && std::abs(q) <= 2 && ell > 0.5 && lever > 0.5 && w1 > 0.5 * w)) {
    const double u = std::sqrt(3 * w / angle.sine);
    return {u, u};
  }
  const double u = std::sqrt(6 * w1 * lever / angle.sine) * (1 - 0.29 * q * w1 + (0.166 * q * q - 0.395) * w1 * w1);
  return {u, u / (ell * (1 + 2.4 * w1 * (w1 - 2.5 * supports.half_depth * q)))};
}

// Phase and half span by Newton's iteration from small deflection. The slopes neglect how the
// parameter depends on the couple.
SupportedState state_nearby(double w, double q, const Supports& supports, PhaseAndSpan& from) {
  const ForceAngle angle = force_angle(q);
  const double R = supports.radius + supports.half_depth;
  if (!(from.phase > 0 && from.half_span > 0)) from = guess_of(w, q, angle, supports);
  auto& [u, a] = from;
  double last_u = 0, last_a = 0;
  for (int i = 0; i < 40; ++i) {
    const auto half = half_of(u, a, angle, supports);
    if (!half) {  // the step was too large
      if (i == 0) last_u = last_a = 0.5 * u;
      u -= 0.6 * last_u, a -= 0.6 * last_a;
      last_u *= 0.4, last_a *= 0.4;
      continue;
    }
    const auto& [along, across, sine, versine, cosine] = half->theta0;
    const double X = u - half->gap, Z = half->rise;
    const double ell = 1 - 2 * R * sine, lever = 2 * a * R * cosine, k = half->curvature;
    const double miss_a = X - a * ell, miss_w = Z / (2 * a) + R * versine - w;
    const double theta_a = (k - half->at_contact) * half->phase_slope;
    const double a_u = 1 - k * Z + lever * k, a_a = (1 - k * Z - cosine) * half->phase_slope - ell + lever * theta_a;
    const double w_u = k * X / (2 * a) + R * sine * k;
    const double w_a = ((k * X - sine) * half->phase_slope - Z / a) / (2 * a) + R * sine * theta_a;
    const double determinant = a_u * w_a - a_a * w_u;
    const double du = (a_a * miss_w - w_a * miss_a) / determinant, da = (w_u * miss_a - a_u * miss_w) / determinant;
    const double rounding = (i < 10 ? 4 : 64) * epsilon;
    const bool solved = std::abs(miss_a) <= rounding * a && std::abs(miss_w) <= rounding * w;
    const bool stands = std::abs(du) <= rounding * u && std::abs(da) <= rounding * a;
    if (solved || stands) return state_of(*half, u, a, angle, q, supports);
    if (!std::isfinite(du) || !std::isfinite(da)) break;
    constexpr double longest = 0.3;  // relative change in a step
    last_u = std::clamp(du, -longest * u, longest * u), last_a = std::clamp(da, -longest * a, longest * a);
    u += last_u, a += last_a;
  }
  from = {};
  return no_state_on_supports(q);
}

// The state at a phase. The half span is solved for, because the curvature at the contact depends
// on it.
SupportedState state_at_phase(double u, double q, const Supports& supports) {
  const ForceAngle angle = force_angle(q);
  const double R = supports.radius + supports.half_depth;
  std::optional<SupportedHalf> half;
  const auto next = [&](double a) {
    half = half_of(u, a, angle, supports);
    return half ? (u - half->gap) / (1 - 2 * R * half->theta0.sine) : not_a_number;
  };
  double a = u, image = next(a);
  double before = a, miss_before = image - a;
  a = image;
  for (int i = 0; i < 40 && supports.half_depth > 0; ++i) {
    image = next(a);
    const double miss = image - a;
    if (!(std::abs(miss) > epsilon * a)) break;
    const double slope = (miss - miss_before) / (a - before);
    before = a, miss_before = miss;
    a = slope < -0.1 ? a - miss / slope : image;
  }
  if (!half || !(a > 0) || !(half->sin_b >= 0)) return no_state_on_supports(q);
  return state_of(*half, u, a, angle, q, supports);
}

}  // namespace

namespace {

void require_domain(double w, double q, const Supports& supports) {
  const auto& [radius, half_depth] = supports;
  if (!(w > 0 && w <= deepest_on_supports))
    throw std::invalid_argument("no deflection of " + std::to_string(w) + " spans");
  if (!(std::abs(q) <= largest_q)) throw std::invalid_argument("no mobilised friction of " + std::to_string(q));
  if (!(radius >= 0 && half_depth >= 0 && radius + half_depth < widest_supports))
    throw std::invalid_argument("rollers of " + std::to_string(radius) + " spans under a half depth of " +
                                std::to_string(half_depth) + " leave no span");
}

SupportedState solved_state(double w, double q, const Supports& supports) {
  // The deflection increases with the phase, at first as its square.
  const double s0 = force_angle(q).sine;
  double low = 0, high = infinity;
  double u = std::sqrt(3 * w / s0), before = 0, w_before = 0;
  SupportedState state = no_state_on_supports(q);
  for (int i = 0; i < 200; ++i) {
    state = state_at_phase(u, q, supports);
    const bool exists = state.status == FibreStatus::ok;
    if (exists && std::abs(state.w - w) <= 2 * epsilon * w) return state;
    (exists && state.w < w ? low : high) = u;
    if (high - low <= epsilon * u) break;
    double next = std::isinf(high) ? 1.3 * u : 0.5 * (low + high);
    if (exists) {  // in the square root of the deflection
      const double root = std::sqrt(state.w), slope = before > 0 ? (root - w_before) / (u - before) : root / u;
      const double secant = u + (std::sqrt(w) - root) / slope;
      if (secant > low && secant < high) next = secant;
      before = u, w_before = root;
    }
    u = next;
  }
  constexpr double good = 1e-12;  // error of w, if neighbouring phases differ by as much
  return state.status == FibreStatus::ok && std::abs(state.w - w) <= good * w ? state : no_state_on_supports(q);
}

}  // namespace

SupportedState no_state_on_supports(double q) {
  SupportedState none{};
  none.status = FibreStatus::beyond_branch;
  none.q = q;
  return none;
}

SupportedState state_on_supports(double w, double q, const Supports& supports) {
  const SupportedState found = extrapolated_state(w, q, supports);
  if (found.status == FibreStatus::ok) return found.F >= 0 ? found : no_state_on_supports(q);
  return solved_state(w, q, supports);
}

SupportedState extrapolated_state(double w, double q, const Supports& supports, PhaseAndSpan& from) {
  require_domain(w, q, supports);
  effort_spent += effort_of_supported_state;
  return state_nearby(w, q, supports, from);
}

SupportedState extrapolated_state(double w, double q, const Supports& supports) {
  PhaseAndSpan from;
  return extrapolated_state(w, q, supports, from);
}

SupportedState state_on_supports_from_force(double w, double F, const Supports& supports) {
  if (!(F >= 0 && std::isfinite(F))) throw std::invalid_argument("no force of " + std::to_string(F));
  const auto at = [&](double q) { return state_on_supports(w, q, supports); };
  SupportedState no_friction = no_state_on_supports(0);
  no_friction.status = FibreStatus::no_friction;
  no_friction.w = w;
  no_friction.F = F;
  if (w < least_half_depths * supports.half_depth) return no_friction;
  // The force increases with friction. Without a state the force has reached zero, or friction
  // exceeds the range searched.
  double low = -largest_q_on_supports, high = largest_q_on_supports;
  double q = 0, before = 0, F_before = 0;
  bool has_before = false;
  const double good = 1e-12 * std::max(F, w);
  for (int i = 0; i < 100 && high - low > 4 * epsilon; ++i) {
    const SupportedState state = at(q);
    const bool exists = state.status == FibreStatus::ok;
    if (exists && std::abs(state.F - F) <= good) return state;
    const bool is_less = exists ? state.F < F : q < 0;
    (is_less ? low : high) = q;
    double next = 0.5 * (low + high);
    if (exists) {
      const double slope = has_before ? (state.F - F_before) / (q - before) : 48 * w * 2.4 * w;
      const double secant = q + (F - state.F) / slope;
      if (secant > low && secant < high) next = secant;
      before = q, F_before = state.F, has_before = true;
    }
    q = next;
  }
  return no_friction;
}

}  // namespace flexslip
