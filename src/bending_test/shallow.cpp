#include "bending_test/shallow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bending_test/sliding_table.h"
#include "numerics/quadrature.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// Bounds the search everywhere. The friction of a fit may exceed the limit slightly.
constexpr double max_friction_sought = 2 * largest_q_on_supports;

double direction_of(Motion motion) { return motion == Motion::slip_in ? 1 : motion == Motion::slip_out ? -1 : 0; }

}  // namespace

bool Shallow::holds(const Fibre& fibre, double S, double w) {
  return !fibre.slides_inward_only() && (S < 1 || w < 1.5 * fibre.supports().half_depth);
}

double Shallow::length_met(const FibreState& state) const {
  return friction_.is_met() ? state.S : rig_.fibre.length_between_contacts(state);
}

double Shallow::friction_at(const FibreState& state) const { return friction_.at(length_met(state)).mu; }

double Shallow::smooth_at(double length) const {
  constexpr double smooth = 0.5;
  const auto knots = friction_.knots();
  if (knots.size() < 2) return smooth * friction_.smooth_scale();
  const double between = (knots.back() - knots.front()) / static_cast<double>(knots.size());
  const double before = std::max({knots.front() - length, length - knots.back(), 0.0});
  return smooth * std::min(friction_.smooth_scale(), before + between);
}

PathPoint Shallow::straight() const { return {0, 0, 0, 1, -friction_.at(1).mu, Motion::stick}; }

Shallow::Place Shallow::place(const Way& way, double w, double q) const {
  const double rolled = 2 * rig_.fibre.supports().radius;
  Place found{};
  double low = -max_friction_sought, high = max_friction_sought;
  const bool rolls = rolled > 0;
  for (int i = 0; i < 100; ++i) {
    found.at = rolls ? rig_.fibre.at_deflection(w, q) : rig_.fibre.at_deflection_without_contacts(w, q);
    const Fibre::DeflectionState& at = found.at;
    const double length_q = rolls ? at.S_q - rolled * at.theta0_q : at.S_q;
    const double length_w = rolls ? at.S_w - rolled * at.theta0_w : at.S_w;
    double step = 0;
    if (way.direction == 0) {
      step = (way.S - 1 - at.slid) / at.S_q;
      found.q_w = -at.S_w / at.S_q;
    } else {
      const FrictionPoint there = friction_.at(length_met(at.state));
      const double slope = friction_.is_met() ? 0 : way.direction * there.slope, in_q = 1 - slope * length_q;
      step = (way.direction * there.mu - q) / in_q;
      found.q_w = slope * length_w / in_q;
      (step > 0 ? low : high) = q;  // the solution is unique: see steepest_followed
    }
    found.length_w = length_w + length_q * found.q_w;
    // While sticking, friction is undetermined at the smallest deflections.
    if (!std::isfinite(step)) break;
    // The square of the last step is below rounding, so the tangent gives the state.
    constexpr double last = 1e-8;
    if (std::abs(step) <= last * (1 + std::abs(q))) {
      found.at.move_by(step);
      break;
    }
    const double next = q + std::clamp(step, -0.5, 0.5);
    q = next > low && next < high ? next : 0.5 * (low + high);
  }
  return found;
}

double Shallow::Guess::at(double deflection) const {
  constexpr double farthest = 0.1;
  return q + std::clamp(q_w * (deflection - w), -farthest, farthest);
}

void Shallow::Guess::follow(const Place& found) {
  const FibreState& state = found.at.state;
  if (state.status == FibreStatus::ok && std::isfinite(found.q_w)) *this = {state.w, state.q, found.q_w};
}

PathPoint Shallow::next(const PathPoint& from, double stage) const {
  const double advance = stage > from.stage ? 1 : -1;
  const Fibre& fibre = rig_.fibre;
  const double half_depth = fibre.supports().half_depth;
  const Fibre::DeflectionState here = fibre.at_deflection(from.w, from.q);
  const double mu = from.w == 0 ? friction_.at(1).mu : friction_at(here.state);
  constexpr double level = 1e-11;
  Guess guess{from.w, from.q, 0};  // from the last result
  const auto at = [&](const Way& way, double w) {
    const Place there = place(way, w, guess.at(w));
    guess.follow(there);
    return there;
  };
  // A specimen slides if friction is exhausted and increases along the specimen by less than
  // sticking requires.
  Way way{from.w == 0 || mu < level ? (here.S_w * advance >= 0 ? 1.0 : -1.0) : from.q > 0 ? 1.0 : -1.0, from.S};
  bool slides =
      from.w == 0 || (std::abs(from.q) >= mu - level && at(way, from.w).slides() * advance * way.direction > 0);
  if (!slides) way.direction = 0, guess = {from.w, from.q, 0};

  double far = advance > 0 ? 3 * half_depth : 0;
  if (advance > 0)
    while (fibre.at_deflection(far, mu).state.S < 1) far *= 1.2;
  const auto travel_left = [&](const Place& there) { return advance * (stage - stage_of(there)); };
  const auto leaves = [&] { return advance > 0 && way.direction > 0; };
  // Three distances to the end of the segment, positive until one is exhausted: to the stage
  // position; to the end of sliding or sticking; to the length 1.
  using Left = std::array<double, 3>;
  const auto left_at = [&](const Place& there) -> Left {
    const FibreState& state = there.at.state;
    if (slides)
      return {travel_left(there), there.slides() * advance * way.direction, leaves() ? -there.at.slid : infinity};
    const bool is_held = state.status == FibreStatus::ok && std::abs(state.S - way.S) <= 1e-11;
    return {travel_left(there), is_held ? friction_at(state) + level - std::abs(state.q) : -infinity, infinity};
  };
  const auto continues = [](const Left& left) { return left[0] > 0 && left[1] > 0 && left[2] > 0; };
  // Small steps, limited by the smooth scale of friction as the contacts move. While sticking, q
  // may change by at most half of friction in a step, because q may return within the friction
  // limit beyond the smallest length.
  constexpr double min_step = 1e-7, of_friction = 0.5, of_half_depth = 0.1;
  double w = from.w, next = from.w + advance * std::min(min_step * half_depth, std::abs(far - from.w));
  Place there = at(way, next);
  Left left = left_at(there);
  if (continues(left) && next != far) {
    Left left_before{};
    do {
      w = next, left_before = left;
      const double q_w = there.q_w;
      double step = std::min(smooth_at(length_met(there.at.state)), 0.5 * (far + from.w)) /
                    std::max(std::abs(there.length_w), 0.1);
      if (!slides) {
        const double by_friction = of_friction * friction_at(there.at.state) / std::abs(q_w);
        step = std::min({step, std::max(by_friction, min_step * half_depth), of_half_depth * half_depth});
      }
      next = advance > 0 ? std::min(next + step, far) : std::max(next - step, far);
      there = at(way, next);
      left = left_at(there);
      if (!slides && continues(left) && there.q_w * q_w <= 0) {
        const auto turns_back = [&](double deflection) { return at(way, deflection).q_w * q_w <= 0; };
        const double turn = first_where(w, next, turns_back);
        if (const Left at_turn = left_at(at(way, turn)); !continues(at_turn)) next = turn, left = at_turn;
      }
    } while (continues(left) && next != far);
    // Each separately: their minimum has corners where two reach zero together.
    for (std::size_t i = 0; i < left.size(); ++i)
      if (!(left[i] > 0))
        next = first_not_positive([&](double x) { return left_at(at(way, x))[i]; }, {w, left_before[i]}, next);
    w = next;
  } else {
    w = first_where(w, next, [&](double x) { return !continues(left_at(at(way, x))); });
  }
  // If the sliding length hardly depends on friction, neither sticking nor sliding advances the
  // state by more than rounding error. The state then follows q = ±μ for a thousandth of half the
  // depth.
  if (std::abs(w - from.w) <= 2 * min_step * half_depth && w > 0 && travel_left(at(way, w)) > 0) {
    slides = true;
    way.direction = from.q > 0 ? 1 : -1;
    constexpr double follows = 1e-3;
    const double follow = from.w + advance * std::min(follows * half_depth, std::abs(far - from.w));
    w = first_where(from.w, follow, [&](double deflection) {
      if (deflection == 0) return true;
      const Place reached = at(way, deflection);
      return !(travel_left(reached) > 0) || (leaves() && reached.at.slid >= 0);
    });
  }

  PathPoint to{0, 0, 0, 1, way.direction * friction_.at(1).mu, Motion::stick};
  if (w > 0) {
    const Place end = at(way, w);
    const FibreState& state = end.at.state;
    to = {stage_of(end), w, state.F, slides ? state.S : from.S, state.q, Motion::stick};
    if (!(travel_left(end) > 0))
      to.stage = stage;
    else if (leaves() && end.at.slid >= 0)
      to.S = 1;
  }
  to.motion = !slides ? Motion::stick : way.direction > 0 ? Motion::slip_in : Motion::slip_out;
  return to;
}

StretchWork Shallow::work(const PathPoint& from, const PathPoint& to) const {
  const Way way{direction_of(to.motion), from.S};
  const Fibre& fibre = rig_.fibre;
  Guess guess{from.w, from.q, to.w == from.w ? 0 : (to.q - from.q) / (to.w - from.w)};
  const auto place_at = [&](double w) {
    const Place there = place(way, w, guess.at(w));
    guess.follow(there);
    return there;
  };
  const auto power = [&](double w) {
    const Place there = place_at(w);
    const FibreState state = fibre.add_contacts(there.at).state;
    const double F_w = there.at.F_w + there.at.F_q * there.q_w;
    return SlidingWork{state.F * (1 + F_w / rig_.stiffness),
                       state.q * state.Pn * (way.direction == 0 ? 0 : there.at.S_w + there.at.S_q * there.q_w) +
                           fibre.bending_energy_lost_at_contact(state) * there.length_w};
  };
  const double rolled = 2 * fibre.supports().radius * 3 * std::abs(to.w - from.w), slid = std::abs(to.S - from.S);
  const auto knots = friction_.knots();
  const auto length_at = [&](double w) { return fibre.length_between_contacts(place_at(w).at.state); };
  const double way_met = rolled + slid, length_from = length_at(from.w);
  const auto met = std::lower_bound(knots.begin(), knots.end(), length_from + way_met) -
                   std::lower_bound(knots.begin(), knots.end(), length_from - way_met);
  const double per_length = knots.size() > 1 ? static_cast<double>(knots.size()) / (knots.back() - knots.front()) : 0;
  const double scales =
      std::max(way_met / friction_.smooth_scale(), std::min(way_met * per_length, static_cast<double>(met)));
  const int pieces = std::max(1, static_cast<int>(std::ceil(scales)));
  SlidingWork sum;
  double begin = from.w, length = length_from;
  for (int i = 1; i <= pieces; ++i) {
    const double end = i < pieces ? from.w + (to.w - from.w) * i / pieces : to.w, length_there = length_at(end);
    const auto [shorter, longer] = std::minmax(length, length_there);
    std::vector<double> corners;
    if (friction_.has_corners())
      corners.assign(std::upper_bound(knots.begin(), knots.end(), shorter),
                     std::lower_bound(knots.begin(), knots.end(), std::max(shorter, longer)));
    if (length_there < length) std::reverse(corners.begin(), corners.end());
    for (const double knot : corners) {
      const double corner = first_where(
          begin, end, [&](double w) { return length_there > length ? length_at(w) >= knot : length_at(w) <= knot; });
      sum += integral(gauss_6, begin, corner, power);
      begin = corner;
    }
    sum += integral(gauss_6, begin, end, power);
    begin = end, length = length_there;
  }
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
  const PathPoint point = point_of([&](double w) { return Place{rig_.fibre.at_deflection(w, q), 0, 0}; });
  if (std::abs(q) <= friction_at(rig_.fibre.at_deflection(point.w, q).state)) return point;
  return point_of([&](double w) { return place({q > 0 ? 1.0 : -1.0, 0}, w, q); });
}

}  // namespace flexslip
