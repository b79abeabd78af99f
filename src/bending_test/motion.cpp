#include "bending_test/motion.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "bending_test/rig.h"
#include "bending_test/sliding_table.h"
#include "bending_test/trace.h"
#include "contact/over_rollers.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/quadrature.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

Motion slip(Sliding sliding) { return sliding == Sliding::in ? Motion::slip_in : Motion::slip_out; }

PathPoint path_point(const RigPoint& point, Motion motion) {
  return {point.stage, point.w, point.F, point.S, point.q, motion};
}

// On a very soft rig the deflection is below a millionth of the span, and S - 1 loses its digits.
void require_bending(const Rig& rig, double farthest) {
  if (!(beam_deflection(farthest, rig.stiffness) >= 1e-6)) {
    std::ostringstream message;
    message << "the rig is too soft, or moved too little, to bend the fibre: its stiffness is " << rig.stiffness
            << " EI/L^3, and it moves to " << farthest << " spans";
    throw std::invalid_argument(message.str());
  }
}

// The length up to which sliding in is traced. On rollers or with a thickness, states far beyond
// the programme cost more.
double traced_length(const BendingTest& test, double farthest) {
  return test.rig.fibre.on_edges() ? longest_at_stage(farthest)
                                   : longest_in_loading(test.friction.kinetic, test.rig, farthest);
}

// At fixed S: rolling changes the bending energy of the axis that leaves the span, friction does no
// work.
SlidingWork work_of_stick(double S, double q_from, double q_to, const Rig& rig) {
  if (S == 1 && rig.fibre.slides_inward_only()) return {};  // no force bends the straight specimen
  constexpr double smooth = 0.5;                            // in q
  const double c = 1 / rig.stiffness;
  const double way = q_to - q_from;
  const auto power = [&](double q) {
    const auto [state, slopes] = rig.fibre.state_slopes(S, q);
    const double leaves = -2 * rig.fibre.supports().radius * slopes.theta0_q;
    return SlidingWork{state.F * (slopes.w_q + c * slopes.F_q),
                       rig.fibre.bending_energy_lost_at_contact(state) * leaves};
  };
  if (std::abs(way) <= 0.1 * smooth) return integral(gauss_3, q_from, q_to, power);
  const int pieces = static_cast<int>(std::ceil(std::abs(way) / smooth));
  SlidingWork work;
  for (int i = 0; i < pieces; ++i)
    work += integral(gauss_10, q_from + way * i / pieces, q_from + way * (i + 1) / pieces, power);
  return work;
}

bool begins_shallow(const Stretch& stretch) { return std::min(stretch.from.S, stretch.to.S) < 1; }

// The range of a segment in the variable of state_within.
std::pair<double, double> extent_of(const Fibre& fibre, const Stretch& stretch) {
  const auto& [from, to, jump] = stretch;
  if (begins_shallow(stretch)) return {from.w, to.w};
  if (to.motion == Motion::stick) return {from.q, to.q};
  return {fibre.sliding_coordinate(from.S), fibre.sliding_coordinate(to.S)};
}

}  // namespace

MovingFibre::MovingFibre(BendingTest test, double farthest)
    : test_(std::move(test)),
      farthest_(farthest),
      in_(trace_loading_curve(test_.friction.kinetic, test_.rig, traced_length(test_, farthest))),
      table_in_(test_.friction.kinetic, test_.rig, Sliding::in),
      table_out_(test_.friction.kinetic, test_.rig, Sliding::out) {
  require_bending(test_.rig, farthest);
  if (test_.friction.kinetic.is_path_dependent() &&
      (test_.rest == SnapRest::overshoot || test_.friction.static_excess.max_up_to(longest_at_stage(farthest)) > 0))
    throw std::invalid_argument("on two supports that are not alike there is neither static excess nor overshoot");
  const Fibre& fibre = test_.rig.fibre;
  if (fibre.supports().radius > 0 && test_.friction.static_excess.max_up_to(longest_at_stage(farthest)) > 0)
    throw std::invalid_argument("on rollers there is no static excess");
  state_ = fibre.slides_inward_only() ? path_point(in_.begin, Motion::stick) : shallow().straight();
}

MovingFibre::MovingFibre(BendingTest test, double farthest, const PathPoint& there)
    : MovingFibre({{test.friction.kinetic.from(there.S, there.q, 1), test.friction.static_excess}, test.rig, test.rest},
                  farthest) {
  const double S = there.S, stage = there.stage;
  if (Shallow::holds(test_.rig.fibre, S, there.w)) {
    state_ = shallow().held(stage, there.q);
    return;
  }
  const auto at = [&](double length) {
    return held_at(length, stage, test_.rig, test_.friction.kinetic.at(length).mu);
  };
  HeldState held = at(S);
  if (held.holding == Holding::beyond_friction) {
    const auto landing = landing_after(in_, S, stage);
    if (!landing || landing->S > longest_sliding) {
      end_ = HistoryStatus::slipped_through;
    } else {
      const auto holds = [&](double length) { return at(length).holding == Holding::held; };
      held = at(first_where(S, landing->S, holds));
    }
  }
  const FibreState& state = held.state;
  state_ = {stage, state.w, state.F, state.S, state.q, Motion::stick};
}

MovingFibre::Position MovingFibre::position() const { return {state_, here_, end_, glide_}; }

void MovingFibre::return_to(const Position& position) {
  state_ = position.state;
  here_ = position.here;
  end_ = position.end;
  glide_ = position.glide;
}

std::optional<Stretch> MovingFibre::settle() {
  const Fibre& fibre = test_.rig.fibre;
  const bool is_straight = fibre.slides_inward_only() ? state_.S == 1 : state_.w == 0;
  if (end_ != HistoryStatus::ok || is_straight) return std::nullopt;
  const Sliding sliding = state_.q > 0 ? Sliding::in : Sliding::out;
  if (!fibre.slides_inward_only()) {
    const PathPoint rest = shallow().held(state_.stage, state_.q);
    if (is_shallow(sliding) || Shallow::holds(fibre, rest.S, rest.w)) return settle_shallow(rest);
  }
  if (std::abs(state_.q) <= limit_at(sliding)) return std::nullopt;
  return snap(sliding);
}

std::optional<Stretch> MovingFibre::settle_shallow(PathPoint rest) {
  constexpr double level = 1e-11;  // in friction, as in shallow.cpp
  if (std::abs(rest.q - state_.q) <= level) return std::nullopt;
  rest.motion = Motion::snap;
  const auto stored = [&](const PathPoint& point) {
    const EnergyAccount energy = account_after({}, {}, point, test_.rig);
    return energy.bending + energy.load_train;
  };
  return jump_to(rest, {stored(state_) - stored(rest), 0});
}

void MovingFibre::scale_friction(double factor) {
  test_.friction = test_.friction.scaled(factor);
  halt();
  retrace();
}

// Starts a new friction path from here; what lies behind is another path.
void MovingFibre::start_path(Sliding sliding) {
  Friction& friction = test_.friction.kinetic;
  friction = friction.from(state_.S, state_.q, direction_of(sliding));
  retrace();
}

void MovingFibre::retrace() {
  const Friction& friction = test_.friction.kinetic;
  in_ = trace_loading_curve(friction, test_.rig, traced_length(test_, farthest_));
  out_.reset();
  table_in_ = SlidingTable(friction, test_.rig, Sliding::in);
  table_out_ = SlidingTable(friction, test_.rig, Sliding::out);
}

const SlidingCurve& MovingFibre::curve_of(Sliding sliding, double S) {
  const Friction& friction = test_.friction.kinetic;
  if (!friction.continues(S, direction_of(sliding))) start_path(sliding);
  if (sliding == Sliding::in) {
    if (S > in_.end.S && in_.end_reason == CurveEnd::reached)  // only after an overshoot
      in_ = trace_loading_curve(friction, test_.rig, 1 + 1.5 * (S - 1));
    return in_;
  }
  const auto covers = [&] { return out_ && out_->end.S <= S && S <= out_->begin.S; };
  if (!out_ && !friction.is_path_dependent()) {
    // Starting at the last stage position, this segment serves every reversal unless the force
    // reaches zero during unloading.
    const auto last = landing_after(in_, 1, farthest_);
    if (last && last->S > S && test_.rig.fibre.state(last->S, -last->q).status == FibreStatus::ok)
      out_ = trace_unloading_curve(friction, test_.rig, last->S);
  }
  if (!covers()) out_ = trace_unloading_curve(friction, test_.rig, S);
  return *out_;
}

std::optional<Stretch> MovingFibre::advance_towards(double stage) {
  if (!(stage >= 0 && stage <= farthest_))
    throw std::invalid_argument("stage position " + std::to_string(stage) + " is not between 0 and " +
                                std::to_string(farthest_));
  if (end_ != HistoryStatus::ok || stage == state_.stage) return std::nullopt;
  const Sliding sliding = stage > state_.stage ? Sliding::in : Sliding::out;
  if (is_free() && (sliding == Sliding::out || state_.stage < state_.w)) return move_apart(stage);
  if (is_shallow(sliding)) {
    glide_.reset();
    return move_to(shallow().next(state_, stage));
  }
  if (glide_ && glide_->sliding != sliding) glide_.reset();
  if (glide_) return slide(sliding, stage);
  const double limit = direction_of(sliding) * limit_at(sliding);
  if (direction_of(sliding) * (limit - state_.q) > 0) return stick(sliding, limit, stage);
  return test_.friction.static_excess.at(state_.S).mu > 0 ? snap(sliding) : slide(sliding, stage);
}

// The friction that limits sticking.
double MovingFibre::limit_at(Sliding sliding) const {
  const Friction& kinetic = test_.friction.kinetic;
  if (const auto over = met_without_knots(kinetic, test_.rig.fibre, direction_of(sliding)))
    return over->at(state_.S).mu;
  return static_friction(test_.friction, state_.S);
}

// True in the shallow beginning of a specimen with a thickness.
bool MovingFibre::is_shallow(Sliding sliding) const {
  const Fibre& fibre = test_.rig.fibre;
  if (fibre.slides_inward_only()) return false;
  constexpr double level = 1e-11, rounding = 1e-14;
  const bool slides_out = sliding == Sliding::out && state_.S - 1 <= rounding && state_.q <= -limit_at(sliding) + level;
  return slides_out || Shallow::holds(fibre, state_.S, state_.w);
}

// At fixed S, until friction or the force is exhausted.
std::optional<Stretch> MovingFibre::stick(Sliding sliding, double limit, double stage) {
  const double S = state_.S;
  const FibreState last = test_.rig.fibre.state(S, limit);
  const double last_stage = last.w + last.F / test_.rig.stiffness;
  if (last.status == FibreStatus::ok && direction_of(sliding) * (stage - last_stage) >= 0)
    return move_to({last_stage, last.w, last.F, S, limit, Motion::stick});
  const auto [holding, held] = held_at(S, stage, test_.rig, state_.q);
  if (holding == Holding::no_contact) return move_to({held.w, held.w, 0, S, held.q, Motion::stick});
  return move_to({stage, held.w, held.F, S, held.q, Motion::stick});
}

// Moves the nose without contact, at most to the specimen.
Stretch MovingFibre::move_apart(double stage) {
  PathPoint point = state_;
  point.stage = std::min(stage, state_.w);
  point.motion = Motion::apart;
  return move_to(point);
}

std::optional<Stretch> MovingFibre::slide(Sliding sliding, double stage) {
  const SlidingCurve& curve = curve_of(sliding, state_.S);
  const double direction = direction_of(sliding);
  if (!is_on(curve, state_.S)) return lose(sliding);  // after wear it ends earlier
  const bool is_known = here_.S == state_.S && here_.q == state_.q;
  StablePart part = stable_part_from(curve, is_known ? here_ : point_at_length(curve, state_.S));
  if (part.to.S > longest_sliding) {
    if (state_.S >= longest_sliding) return lose(sliding);
    part.to = point_at_length(curve, longest_sliding);
  }
  if (part.to.S == part.from.S) return snap(sliding);
  const bool arrives = direction * (part.to.stage - stage) >= 0;
  const bool moves = direction * (stage - part.from.stage) > 0;  // by more than the rounding of G
  RigPoint to = !arrives ? part.to : moves ? point_at_stage(curve, part, stage) : part.from;
  if (arrives) to.stage = stage;
  if (!glide_) glide_ = Glide{sliding, direction * infinity};
  if (direction * (to.S - glide_->to_S) >= 0) {
    to = point_at_length(curve, glide_->to_S);
    glide_.reset();
  }
  here_ = to;
  PathPoint point = path_point(to, slip(sliding));
  const bool is_without_force = curve.end_reason == CurveEnd::branch_ended && to.S == curve.end.S;
  if (is_without_force && sliding == Sliding::out) {
    point.F = 0;
    point.stage = point.w;
  }
  return move_to(point);
}

std::optional<Stretch> MovingFibre::snap(Sliding sliding) {
  const SlidingCurve& curve = curve_of(sliding, state_.S);
  const double direction = direction_of(sliding);
  const double S = state_.S;
  glide_.reset();
  if (!is_on(curve, S)) return lose(sliding);
  auto landing = landing_after(curve, S, state_.stage);
  if (landing && landing->S > longest_sliding) return lose(sliding);
  const auto work =
      landing ? snap_work(test_.friction.kinetic, test_.rig, state_.stage, S, landing->S) : std::optional<SnapWork>();
  if (!work) return lose(sliding);
  landing->stage = state_.stage;
  const double next_stop = std::max(S + direction * min_slip, 1.0);
  const bool slides_on = test_.friction.static_excess.at(S).mu > 0 && direction * (next_stop - landing->S) > 0;
  if (slides_on) glide_ = Glide{sliding, next_stop};
  if (!slides_on && test_.rest == SnapRest::overshoot) return overshoot(sliding, *landing, *work);
  here_ = *landing;
  return jump_to(path_point(*landing, slides_on ? slip(sliding) : Motion::snap), *work);
}

std::optional<Stretch> MovingFibre::overshoot(Sliding sliding, const RigPoint& nearest, const SnapWork& nearest_work) {
  constexpr int max_oscillations = 1000;  // exceeded only if friction is nearly zero
  const Friction& kinetic = test_.friction.kinetic;
  SnapWork work{0, 0};
  double S = state_.S;
  double S_landing = nearest.S;
  for (int i = 0; i < max_oscillations; ++i) {
    const Overshoot oscillation = overshoot_of(kinetic, test_.rig, state_.stage, S, S_landing);
    if (oscillation.end == Holding::no_contact) return lose(sliding);
    if (oscillation.end == Holding::beyond_friction) break;
    // The energy decreases as the square of the amplitude, the loss per oscillation in proportion
    // to it. Half of the remaining oscillations would lose as much as the first.
    if (i == 0 && nearest_work.released > 0.5 * max_oscillations * oscillation.friction) break;
    S = oscillation.S;
    work.friction += oscillation.friction;
    const FibreState rest = held_at(S, state_.stage, test_.rig, direction_of(sliding) * kinetic.at(S).mu).state;
    if (std::abs(rest.q) <= static_friction(test_.friction, S))
      return jump_to({state_.stage, rest.w, rest.F, S, rest.q, Motion::snap}, work);
    sliding = rest.q > 0 ? Sliding::in : Sliding::out;
    if (test_.rig.fibre.state(S, direction_of(sliding) * kinetic.at(S).mu).status != FibreStatus::ok)
      return lose(sliding);
    const auto landing = landing_after(curve_of(sliding, S), S, state_.stage);
    if (!landing) return lose(sliding);
    S_landing = landing->S;
  }
  return jump_to(path_point(nearest, Motion::snap), nearest_work);
}

std::optional<Stretch> MovingFibre::lose(Sliding sliding) {
  end_ = sliding == Sliding::in ? HistoryStatus::slipped_through : HistoryStatus::contact_lost;
  return std::nullopt;
}

StretchWork MovingFibre::work_of(const Stretch& stretch) {
  const auto& [from, to, jump] = stretch;
  if (stretch.is_jump()) return jump;
  if (to.motion == Motion::apart) return {};
  if (std::min(from.S, to.S) < 1) return shallow().work(from, to);
  if (to.motion == Motion::stick) {
    const SlidingWork work = work_of_stick(from.S, from.q, to.q, test_.rig);
    return {work.stage, work.friction, 0};
  }
  const SlidingWork work = (to.motion == Motion::slip_in ? table_in_ : table_out_).work(from.S, to.S);
  return {work.stage, work.friction, 0};
}

Stretch MovingFibre::move_to(const PathPoint& point) {
  const Stretch stretch{state_, point};
  state_ = point;
  return stretch;
}

Stretch MovingFibre::jump_to(const PathPoint& point, const SnapWork& work) {
  const Stretch stretch{state_, point, {0, work.friction, work.released}};
  state_ = point;
  return stretch;
}

// `along` is q for sticking, √(S - 1) for sliding, and w if shallow.
PathPoint MovingFibre::point_within(const Stretch& stretch, double along) const {
  const auto& [from, to, jump] = stretch;
  if (begins_shallow(stretch)) return shallow().point_at(from, to, along);
  const Fibre& fibre = test_.rig.fibre;
  FibreState state;
  if (to.motion == Motion::stick) {
    state = fibre.state(from.S, along);
  } else {
    const double S = fibre.length_at(along), direction = to.motion == Motion::slip_in ? 1 : -1;
    const auto over = met_without_knots(test_.friction.kinetic, fibre, direction);
    state = fibre.state(S, direction * (over ? *over : test_.friction.kinetic).at(S).mu);
  }
  return {state.w + state.F / test_.rig.stiffness, state.w, state.F, state.S, state.q, to.motion};
}

double MovingFibre::stage_at_deflection(const Stretch& stretch, double w) const {
  const auto [from, to] = extent_of(test_.rig.fibre, stretch);
  const auto at = [&](double along) { return point_within(stretch, along); };
  const double reached = first_where(from, to, [&](double along) { return !(at(along).w < w); });
  return std::clamp(at(reached).stage, stretch.from.stage, stretch.to.stage);
}

std::vector<Stretch> MovingFibre::parts_of(const Stretch& stretch, int n) {
  if (n < 2) throw std::invalid_argument("a stretch has at least 2 points, not " + std::to_string(n));
  const auto& [from, to, jump] = stretch;
  if (stretch.is_jump()) return {stretch};
  const Motion motion = to.motion;
  const auto [low, high] = extent_of(test_.rig.fibre, stretch);
  std::vector<Stretch> parts;
  parts.reserve(static_cast<std::size_t>(n - 1));
  PathPoint last = from;
  for (int i = 1; i < n; ++i) {
    PathPoint next = to;
    if (motion == Motion::apart) {
      next.stage = i < n - 1 ? from.stage + (to.stage - from.stage) * i / (n - 1) : to.stage;
    } else if (i < n - 1) {
      next = point_within(stretch, low + (high - low) * i / (n - 1));
    }
    parts.push_back({last, next});
    last = next;
  }
  return parts;
}

EnergyAccount account_after(const EnergyAccount& account, const StretchWork& work, const PathPoint& end,
                            const Rig& rig) {
  EnergyAccount next = account;
  next.stage_work += work.stage;
  next.friction += work.friction;
  next.snaps += work.released;
  next.cracks += work.cracked;
  next.bending = end.left * state_at(rig.fibre, end).U;
  next.load_train = 0.5 * end.F * end.F / rig.stiffness;
  next.imbalance = next.stage_work - (next.bending + next.load_train + next.friction + next.snaps + next.cracks);
  return next;
}

double work_of_fracture(const EnergyAccount& account) { return account.stage_work - account.load_train; }

}  // namespace flexslip
