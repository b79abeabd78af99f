#include "bending_test/shallow.h"

#include <algorithm>
#include <cmath>

#include "bending_test/quadrature.h"
#include "bending_test/sliding_table.h"

namespace flexslip {
namespace {

// Where something that is false at one end becomes true, towards the other; there if it never does.
template <class Predicate>
double first_where(double is_false, double end, const Predicate& is_true) {
  if (!is_true(end)) return end;
  double is_so = end;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (is_false + is_so);
    if (middle == is_false || middle == is_so) break;
    (is_true(middle) ? is_so : is_false) = middle;
  }
  return is_so;
}

double direction_of(Motion motion) { return motion == Motion::slip_in ? 1 : motion == Motion::slip_out ? -1 : 0; }

}  // namespace

bool Shallow::holds(const Fibre& fibre, double S, double w) {
  return !fibre.begins_straight() && (S < 1 || w < 1.5 * fibre.supports().half_depth);
}

double Shallow::friction_at(const FibreState& state) const {
  return friction_.at(friction_.is_met() ? state.S : rig_.fibre.length_between_contacts(state)).mu;
}

PathPoint Shallow::straight() const { return {0, 0, 0, 1, -friction_.at(1).mu, Motion::stick}; }

Shallow::Place Shallow::place(const Way& way, double w, double q) const {
  const double rolled = 2 * rig_.fibre.supports().radius;
  Place found{};
  for (int i = 0; i < 60; ++i) {
    found.at = rig_.fibre.bent(w, q);
    const Fibre::BentState& at = found.at;
    const double length_q = at.S_q - rolled * at.theta0_q, length_w = at.S_w - rolled * at.theta0_w;
    double step = 0;
    if (way.direction == 0) {
      step = (way.S - at.state.S) / at.S_q;
      found.q_w = -at.S_w / at.S_q;
    } else {
      const FrictionPoint there =
          friction_.at(friction_.is_met() ? at.state.S : rig_.fibre.length_between_contacts(at.state));
      const double slope = friction_.is_met() ? 0 : way.direction * there.slope, in_q = 1 - slope * length_q;
      step = (way.direction * there.mu - q) / in_q;
      found.q_w = slope * length_w / in_q;
    }
    found.length_w = length_w + length_q * found.q_w;
    constexpr double small = 1e-14;
    // At rest the least deflections have no friction that could be told.
    if (!std::isfinite(step) || std::abs(step) <= small * (1 + std::abs(q))) break;
    q += std::clamp(step, -0.5, 0.5);
    if (std::abs(q) > largest_q_on_supports) break;
  }
  return found;
}

PathPoint Shallow::next(const PathPoint& from, double stage) const {
  const double advance = stage > from.stage ? 1 : -1;
  const Fibre& fibre = rig_.fibre;
  const Fibre::BentState here = fibre.bent(from.w, from.q);
  const double inwards = here.S_w * advance >= 0 ? 1 : -1;  // which way the surface would slide
  const double mu = from.w == 0 ? friction_.at(1).mu : friction_at(here.state);
  constexpr double level = 1e-11;
  const bool slides = from.w == 0 || inwards * from.q >= mu - level;  // no force, no friction to overcome
  const Way way{slides ? inwards : 0, from.S};
  double far = advance > 0 ? 3 * fibre.supports().half_depth : 0;
  if (advance > 0)
    while (fibre.bent(far, mu).state.S < 1) far *= 1.2;
  const auto at = [&](double w) { return place(way, w, from.q); };
  const auto passed = [&](const Place& there) { return advance * (stage_of(there) - stage) >= 0; };
  const auto to_point = [&](double w, Motion motion) {
    const Place there = at(w);
    const FibreState& state = there.at.state;
    return PathPoint{stage_of(there), w, state.F, state.S, state.q, motion};
  };
  // Each stretch gets on by some of the way at least, so that none is lost between friction and what it does to itself on rollers.
  constexpr double least = 1e-7;  // of a half depth
  const double on = from.w + advance * std::min(least * fibre.supports().half_depth, std::abs(far - from.w));
  const double first = on == far || passed(at(on)) ? from.w : on;
  if (slides) {
    const bool leaves = advance > 0 && inwards > 0;
    const auto ends = [&](double w) {
      if (w == 0) return true;
      const Place there = at(w);
      return passed(there) || there.at.S_w * advance * inwards <= 0 || (leaves && there.at.state.S >= 1);
    };
    const double w = first_where(first, far, ends);
    PathPoint to =
        w > 0 ? to_point(w, Motion::stick) : PathPoint{0, 0, 0, 1, inwards * friction_.at(1).mu, Motion::stick};
    to.motion = inwards > 0 ? Motion::slip_in : Motion::slip_out;
    if (w > 0 && passed(at(w)))
      to.stage = stage;
    else if (leaves && to.S >= 1)
      to.S = 1;
    return to;
  }
  // Friction first falls or rises to where the length is the least of its friction, then the other way.
  const double turn = first_where(first, far, [&](double w) {
    const Place there = at(w);
    return !std::isfinite(there.at.state.q) || there.at.S_w * here.S_w <= 0;
  });
  double begin = first;
  for (const double end : {turn, far}) {
    const auto ends = [&](double w) {
      const Place there = at(w);
      const FibreState& state = there.at.state;
      const bool is_held = state.status == FibreStatus::ok && std::abs(state.S - way.S) <= 1e-11;
      return !is_held || passed(there) || std::abs(state.q) > friction_at(state);
    };
    const double w = first_where(begin, end, ends);
    if (w != end || end == far) {
      PathPoint to = to_point(w, Motion::stick);
      to.S = way.S;
      if (passed(at(w))) to.stage = stage;
      return to;
    }
    begin = end;
  }
  return from;
}

StretchWork Shallow::work(const PathPoint& from, const PathPoint& to) const {
  const Way way{direction_of(to.motion), from.S};
  const Fibre& fibre = rig_.fibre;
  const auto power = [&](double w) {
    const Place there = place(way, w, 0.5 * (from.q + to.q));
    const FibreState& state = there.at.state;
    const double F_w = there.at.F_w + there.at.F_q * there.q_w;
    return SlidingWork{state.F * (1 + F_w / rig_.stiffness),
                       state.q * state.Pn * (way.direction == 0 ? 0 : there.at.S_w + there.at.S_q * there.q_w) +
                           fibre.lost_bending(state) * there.length_w};
  };
  const double rolled = 2 * fibre.supports().radius * 3 * std::abs(to.w - from.w), slid = std::abs(to.S - from.S);
  const auto knots = friction_.knots();
  const double for_knots = knots.size() > 1 ? static_cast<double>(knots.size()) / (knots.back() - knots.front()) : 0;
  const double scales = (rolled + slid) * std::max(1 / friction_.smooth_scale(), for_knots);
  const int pieces = 2 + static_cast<int>(std::ceil(2 * scales));
  SlidingWork sum;
  for (int i = 0; i < pieces; ++i)
    sum +=
        integral(gauss_10, from.w + (to.w - from.w) * i / pieces, from.w + (to.w - from.w) * (i + 1) / pieces, power);
  return {sum.stage, sum.friction, 0};
}

PathPoint Shallow::point_at(const PathPoint& from, const PathPoint& to, double w) const {
  const Place there = place({direction_of(to.motion), from.S}, w, 0.5 * (from.q + to.q));
  const FibreState& state = there.at.state;
  return {stage_of(there), w, state.F, to.motion == Motion::stick ? from.S : state.S, state.q, to.motion};
}

PathPoint Shallow::held(double stage, double q) const {
  const auto point_of = [&](const auto& at) {
    const double w = first_where(0, stage, [&](double x) { return x > 0 && stage_of(at(x)) >= stage; });
    const FibreState state = at(w).at.state;
    return PathPoint{stage, w, state.F, state.S, state.q, Motion::stick};
  };
  const PathPoint point = point_of([&](double w) { return Place{rig_.fibre.bent(w, q), 0, 0}; });
  if (std::abs(q) <= friction_at(rig_.fibre.bent(point.w, q).state)) return point;
  return point_of([&](double w) { return place({q > 0 ? 1.0 : -1.0, 0}, w, q); });
}

}  // namespace flexslip
