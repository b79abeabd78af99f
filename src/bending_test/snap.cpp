#include "bending_test/snap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "contact/over_rollers.h"
#include "numerics/polynomial.h"
#include "numerics/quadrature.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// A specimen that slides at a fixed stage position, from S towards another length.
class Slide {
 public:
  Slide(const Friction& friction, const Rig& rig, double stage, double S, double S_to)
      : friction_(friction),
        met_(met_without_knots(friction, rig.fibre, S_to >= S ? 1 : -1)),
        rig_(rig),
        stage_(stage),
        direction_(S_to >= S ? 1 : -1),
        q_(direction_ * friction.at(S).mu) {}

  // With respect to σ, in which Π is smooth at S = 1.
  SnapWork power_at(double sigma) {
    const double S = rig_.fibre.length_at(sigma);
    const auto [q, Pn, at_contacts, lost] = held_friction(S);
    const double resisting = direction_ * friction_.at(friction_.is_met() ? S : at_contacts).mu;
    return {(resisting * Pn + lost) * 2 * sigma, (q - resisting) * Pn * 2 * sigma};
  }

  SnapWork work(double S_from, double S_to) {
    return integral(gauss_6, rig_.fibre.sliding_coordinate(S_from), rig_.fibre.sliding_coordinate(S_to),
                    [this](double x) { return power_at(x); });
  }

  // Near the straight specimen q varies as a power of 1/σ, so segments are proportional to σ.
  double next(double S, double S_to) const {
    constexpr double part = 0.15;
    constexpr double min_distance = 1e-12;  // of S - 1: the rest is below its rounding
    const double end = end_of_stretch(met_ ? *met_ : friction_, rig_.fibre, S, S_to, 1),
                 before = rig_.fibre.least_length();
    if (S - before <= min_distance) return end;
    const double near = before + (S - before) * (1 + direction_ * part) * (1 + direction_ * part);
    return direction_ > 0 ? std::min(end, near) : std::max(end, near);
  }

  // Empty if some length has no equilibrium; see holding().
  std::optional<SnapWork> work_if_held(double S_from, double S_to) {
    holding_ = Holding::held;
    const SnapWork done = work(S_from, S_to);
    if (holding_ == Holding::held) return done;
    q_ = direction_ * friction_.at(S_from).mu;
    return std::nullopt;
  }

  Holding holding() const { return holding_; }

 private:
  struct Held {
    double q, Pn;
    double at_contacts;  // [L] argument of friction
    // [EI/L^2] bending energy of the axis that leaves the span, per sliding length
    double lost;
  };

  Held held(const FibreState& state, const FibreSlopes& slopes) const {
    const Fibre& fibre = rig_.fibre;
    const double lost = fibre.bending_energy_lost_at_contact(state);
    if (lost == 0) return {state.q, state.Pn, fibre.length_between_contacts(state), 0};
    const double c = 1 / rig_.stiffness;  // at a fixed stage position
    const double q_S = -(slopes.w_S + c * slopes.F_S) / (slopes.w_q + c * slopes.F_q);
    const double leaves = 1 - 2 * fibre.supports().radius * (slopes.theta0_S + slopes.theta0_q * q_S);
    return {state.q, state.Pn, fibre.length_between_contacts(state), lost * leaves};
  }

  // As held_at, starting from the q of the previous length.
  Held held_friction(double S) {
    const double c = 1 / rig_.stiffness;
    for (int iteration = 0; iteration < 10; ++iteration) {
      auto [state, slopes] = rig_.fibre.state_slopes(S, q_);
      if (state.status != FibreStatus::ok) break;
      const double step = (stage_ - state.w - c * state.F) / (slopes.w_q + c * slopes.F_q);
      if (!(std::abs(q_ + step) < largest_q)) break;
      q_ += step;
      if (std::abs(step) <= 1e-6) {  // accurate to the square of the step
        state.q = q_;
        state.Pn += slopes.Pn_q * step;
        state.theta0 += slopes.theta0_q * step;
        return held(state, slopes);
      }
    }
    const HeldState found = held_at(S, stage_, rig_, direction_ * friction_.at(S).mu);
    if (found.holding != Holding::held) holding_ = found.holding;
    q_ = found.state.q;
    return held(found.state, rig_.fibre.state_slopes(S, q_).slopes);
  }

  const Friction& friction_;
  std::optional<Friction> met_;  // on rollers
  const Rig& rig_;
  double stage_;
  double direction_;
  double q_;
  Holding holding_ = Holding::held;
};

// The length between two others at which the remaining energy is dissipated.
Overshoot end_between(Slide& slide, const Rig& rig, const SnapWork& left, double S, double next) {
  const auto energy_left = [&](double end) {
    const double sigma = rig.fibre.sliding_coordinate(end);
    return ValueAndSlope{left.released + slide.work(S, end).released, slide.power_at(sigma).released / (2 * sigma)};
  };
  constexpr double rounding = 0x1p-50;
  const double end = zero_between(energy_left, next, S, 0.5 * (S + next), 0, rounding);
  const SnapWork last = slide.work(S, end);
  return {Holding::held, end, left.friction + last.friction + left.released + last.released};
}

}  // namespace

HeldState held_at(double S, double stage, const Rig& rig, double q) {
  if (!(S >= 1 && stage >= 0 && std::abs(q) <= largest_q))
    throw std::invalid_argument("no fibre rests at S = " + std::to_string(S) + ", stage " + std::to_string(stage) +
                                ", q " + std::to_string(q));
  const double c = 1 / rig.stiffness;
  double low = -rig.fibre.max_friction();
  double high = rig.fibre.on_edges() ? largest_q : 2 * largest_q_on_supports;
  FibreState held{};
  bool is_below = false;   // a state below the stage was found
  bool is_beyond = false;  // a state above the stage was found
  for (int iteration = 0; iteration < 100; ++iteration) {
    const auto [state, slopes] = rig.fibre.state_slopes(S, q);
    double next = low;
    if (state.status == FibreStatus::ok) {
      const double error = state.w + c * state.F - stage;
      held = state;
      is_below = is_below || error <= 0;
      is_beyond = is_beyond || error >= 0;
      if (std::abs(error) <= 0x1p-50 * stage) return {Holding::held, state};
      (error < 0 ? low : high) = q;
      next = q - error / (slopes.w_q + c * slopes.F_q);
      if (is_below && is_beyond && std::abs(next - q) <= 0x1p-53 * (1 + std::abs(q))) return {Holding::held, state};
    } else {
      low = q;
    }
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (!(next > low && next < high)) break;
    q = next;
  }
  return {!is_below ? Holding::no_contact : !is_beyond ? Holding::beyond_friction : Holding::held, held};
}

std::optional<SnapWork> snap_work(const Friction& friction, const Rig& rig, double stage, double S_from, double S_to) {
  Slide slide(friction, rig, stage, S_from, S_to);
  SnapWork sum;
  for (double S = S_from; S != S_to;) {
    const double next = slide.next(S, S_to);
    const auto work = slide.work_if_held(S, next);
    if (!work) return std::nullopt;
    sum += *work;
    S = next;
  }
  if (held_at(S_to, stage, rig, 0).holding != Holding::held) return std::nullopt;
  return sum;
}

Overshoot overshoot_of(const Friction& friction, const Rig& rig, double stage, double S_from, double S_landing) {
  constexpr double farthest = 10;  // [L] no specimen returns from beyond
  const double S_end = S_landing > S_from ? farthest : 1;
  Slide slide(friction, rig, stage, S_from, S_landing);
  const auto first = snap_work(friction, rig, stage, S_from, S_landing);
  if (!first) return {Holding::no_contact, S_landing, 0};
  SnapWork sum = *first;
  double S = S_landing;
  double reach =
      // of the next segment, because the energy may be dissipated long before its end
      0.25 * std::abs(S_landing - S_from);
  while (sum.released > 0) {
    if (S == S_end) return {Holding::no_contact, S, 0};
    const double smooth = slide.next(S, S_end);
    const double next = std::abs(smooth - S) <= reach ? smooth : S + std::copysign(reach, S_end - S);
    const auto work = slide.work_if_held(S, next);
    if (!work && reach > 0x1p-40 * S) {
      reach *= 0.5;
      continue;
    }
    if (!work) return {slide.holding(), S, 0};
    if (sum.released + work->released <= 0) return end_between(slide, rig, sum, S, next);
    sum += *work;
    S = next;
    reach *= 2;
  }
  return {Holding::held, S_landing, sum.friction + sum.released};
}

}  // namespace flexslip
