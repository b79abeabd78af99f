#include "bending_test/design.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bending_test/history.h"
#include "bending_test/rig.h"
#include "bending_test/shallow.h"
#include "bending_test/sliding_piece.h"
#include "bending_test/snap.h"
#include "bending_test/trace.h"
#include "contact/over_rollers.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/minimum.h"
#include "numerics/polynomial.h"
#include "numerics/quadrature.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// The maximum of k(S) in a range of lengths.
double stiffness_of_cusp(const Friction& friction, const Fibre& fibre, const Bracket& S) {
  // of the range; near its maximum k(S) is known to the square of this
  constexpr double flat = 1e-8;
  // limited by the rounding of lengths
  const double tolerance = std::max(flat * S.width(), 0x1p-50 * S.high);
  const auto k_at = [&](double length) { return stiffness_of_fold(friction, length, fibre); };
  return std::max({greatest_within(k_at, S.low, S.high, tolerance).value, k_at(S.low), k_at(S.high)});
}

// The lengths of an unstable part of the curve whose cusp is probably the stiffest.
Bracket stiffest_pair(const SlidingCurve& curve) {
  Bracket stiffest{};
  double max_stiffness = -infinity;
  double from = curve.begin.S;
  for (std::size_t i = 0; i <= curve.folds.size(); ++i) {
    const bool is_end = i == curve.folds.size();
    const double to = is_end ? curve.end.S : curve.folds[i].point.S;
    const bool runs_back = is_end ? curve.folds.back().is_maximum : !curve.folds[i].is_maximum;
    const Bracket pair{from, to};
    from = to;
    if (!runs_back || !(pair.low < pair.high)) continue;
    const double k = stiffness_of_fold(curve.friction, pair.middle(), curve.rig.fibre);
    if (k > max_stiffness) stiffest = pair;
    max_stiffness = std::max(max_stiffness, k);
  }
  return stiffest;
}

}  // namespace

double stiffness_of_fold(const Friction& friction, double S, const Fibre& fibre) {
  const auto mu = friction.at(S);
  const auto [state, slopes] = fibre.state_slopes(S, mu.mu);
  return -(slopes.F_S + slopes.F_q * mu.slope) / (slopes.w_S + slopes.w_q * mu.slope);
}

double critical_stiffness(const Friction& friction, double w_max, const Fibre& fibre) {
  constexpr double softest = 1e-6;
  // relative to k: closer to a cusp, the tracer cannot separate the two folds
  constexpr double above = 1e-9;
  const Rig stiff{infinity, fibre};
  const auto controlled = trace_loading_curve(friction, stiff, longest_in_loading(friction, stiff, w_max));
  if (controlled.begin.stage >= w_max) return 0;  // a thick specimen has not begun to slide in
  const StablePart part = stable_part_from(controlled, controlled.begin);
  if (!controlled.folds.empty() && part.to.stage <= w_max) return infinity;
  const double S_end = part.to.stage > w_max ? point_at_stage(controlled, part, w_max).S : part.to.S;

  double critical = 0;
  double stiffness = softest;
  while (true) {
    const auto curve = trace_loading_curve(friction, {stiffness, fibre}, S_end);
    if (curve.folds.empty()) return critical;
    const double cusp = stiffness_of_cusp(curve.friction, fibre, stiffest_pair(curve));
    if (!(cusp > stiffness)) return critical;  // rounding in the trace
    critical = cusp;
    stiffness = (1 + above) * cusp;
  }
}

namespace {

constexpr double rounding_of_step = 1e-9;    // a shorter last step is ignored
constexpr double rounding_of_force = 1e-11;  // of forces from polynomials

}  // namespace

ReadingPositions::ReadingPositions(double travel, double step)
    : travel_(travel), step_(step), last_(std::ceil(travel / step - rounding_of_step)) {}

double ReadingPositions::first_beyond(double stage) const {
  double i = std::clamp(std::floor(stage / step_) + 1, 0.0, last_ + 1);
  while (i > 0 && position(i - 1) > stage) --i;
  while (i <= last_ && position(i) <= stage) ++i;
  return i;
}

void ForceFalls::read(double F) {
  if (F < last_ - rounding_of_force * last_) {
    if (!falling_) top_ = last_;
    falling_ = true;
  } else if (F > last_ + rounding_of_force * last_) {
    end();
  } else {
    return;
  }
  last_ = F;
}

void ForceFalls::end() {
  if (!falling_) return;
  falling_ = false;
  ++count_;
  sum_ += top_ - last_;
  largest_ = std::max(largest_, top_ - last_);
}

std::vector<RecordedForce> record_of(const BendingTest& test, double travel, double step) {
  constexpr double max_readings = 20000;
  constexpr int points_of_stretch = 60;
  const auto path = [&] {
    if (step == 0 || travel / step > max_readings)
      return path_continuously(test, std::vector{travel}, points_of_stretch).path;
    return path_in_steps(test, stage_steps(std::vector{0.0, travel}, step)).path;
  }();
  std::vector<RecordedForce> record;
  record.reserve(path.size());
  for (const auto& point : path) record.push_back({point.stage, point.F});
  return record;
}

namespace {

// A state with the elastic energy, and its derivatives for sliding at constant stage position.
struct Rest {
  FibreState state;
  double potential = 0;  // [EI/L] U + F^2/2k
  double Pn_slope = 0;   // [EI/L^3] dPn/dS
  double contact = 0,
         // [L], [1] length between the contacts, the argument of friction, with its derivative
      contact_slope = 0;
};

Rest rest_at(const Rig& rig, double S, double q, double w) {
  const double c = 1 / rig.stiffness;
  const auto [state, slopes] = rig.fibre.state_slopes(S, q, w);
  const double q_slope = -(slopes.w_S + c * slopes.F_S) / (slopes.w_q + c * slopes.F_q);
  const double rolled = 2 * rig.fibre.supports().radius;
  return {state, state.U + 0.5 * c * state.F * state.F, slopes.Pn_S + slopes.Pn_q * q_slope,
          rig.fibre.length_between_contacts(state), 1 - rolled * (slopes.theta0_S + slopes.theta0_q * q_slope)};
}

// The maximum force of a loading. At tops of polynomials the state is computed, but only if the top
// may be the maximum.
class GreatestForce {
 public:
  void see(double F) { max_force_ = std::max(max_force_, F); }
  void see_top(double F, double S) {
    constexpr double error = 1e-6;  // upper bound for a polynomial
    if (!(F > (1 - error) * max_top_)) return;
    if (F > (1 + error) * max_top_) S_of_tops_.clear();
    max_top_ = std::max(max_top_, F);
    S_of_tops_.push_back(S);
  }
  template <class ForceAt>
  double value(const ForceAt& force_at) const {
    double highest = max_force_;
    for (const double S : S_of_tops_) highest = std::max(highest, force_at(S));
    return highest;
  }

 private:
  double max_force_ = 0, max_top_ = 0;
  std::vector<double> S_of_tops_;
};

// Follows the curve of a loading from one stable part to the next.
class Loading {
 public:
  explicit Loading(const Design& design)
      : design_(design),
        readings_(design.step > 0 ? std::optional<ReadingPositions>({design.travel, design.step}) : std::nullopt),
        curve_(trace_loading_curve(design.friction, design.rig,
                                   longest_in_loading(design.friction, design.rig, design.travel))) {}

  DesignOutcome outcome() {
    outcome_.status = walk();
    drops_.end();
    outcome_.drops = drops_.count();
    outcome_.largest_drop = drops_.largest();
    outcome_.mean_drop = drops_.mean();
    outcome_.greatest_force = greatest_.value([&](double S) { return fibre().state(S, curve_.friction.at(S).mu).F; });
    return outcome_;
  }

 private:
  DesignStatus walk() {
    StablePart part = stable_part_from(curve_, curve_.begin);
    if (!fibre().slides_inward_only() && !bend_shallow(part.from))
      return breaks_ ? DesignStatus::breaks : DesignStatus::ok;
    Rest rest{fibre().state(part.from.S, part.from.q)};
    while (true) {
      const bool arrives = part.to.stage >= design_.travel;
      if (arrives) part.to = point_at_stage(curve_, part, design_.travel);
      const Rest end = rest_at(design_.rig, part.to.S, part.to.q, part.to.w);
      if (!slide(part, rest, end)) return breaks_ ? DesignStatus::breaks : DesignStatus::slipped_through;
      if (arrives) {
        outcome_.stage_reached = design_.travel;
        // The last reading, which rounding may place beyond the end of its piece.
        if (readings_ && readings_->first_beyond(design_.travel) > next_) drops_.read(end.state.F);
        return DesignStatus::ok;
      }
      const double stage = part.to.stage;
      const auto landing = landing_after(curve_, part.to.S, stage);
      if (!landing) return DesignStatus::slipped_through;
      rest = rest_at(design_.rig, landing->S, landing->q, landing->w);
      const auto heat = heat_of_snap(stage, end, rest);
      if (!heat) return DesignStatus::slipped_through;
      part = stable_part_from(curve_, *landing);
      part.from.stage = stage;
      snap(stage, end, rest, *heat);
      if (sees(rest.state)) {  // as it comes to rest
        outcome_.stage_reached = stage;
        outcome_.w_reached = rest.state.w;
        return DesignStatus::breaks;
      }
    }
  }

  // Follows the shallow beginning (bending_test/shallow.h); false if the loading ends there.
  bool bend_shallow(const RigPoint& begin) {
    const Friction friction = design_.friction;
    const Shallow shallow(friction, design_.rig);
    const double stage = std::min(begin.stage, design_.travel);
    PathPoint here = shallow.straight();
    while (here.stage < stage && here.S <= 1 && !(here.S == 1 && here.w > 0)) {
      const PathPoint to = shallow.next(here, stage);
      const StretchWork work = shallow.work(here, to);
      const double c = 1 / design_.rig.stiffness;
      outcome_.work += work.stage - 0.5 * c * (to.F * to.F - here.F * here.F);
      outcome_.friction_heat += work.friction;
      here = to;
    }
    breaks_ = sees(fibre().at_deflection(here.w, here.q).state);
    outcome_.stage_reached = here.stage;
    outcome_.w_reached = here.w;
    greatest_.see(here.F);
    if (readings_) next_ = readings_->first_beyond(here.stage);
    drops_.read(here.F);
    return !breaks_ && here.stage < design_.travel && begin.stage < design_.travel;
  }

  const Fibre& fibre() const { return design_.rig.fibre; }

  // True if the specimen breaks at the curvature of a state.
  bool sees(const FibreState& state) {
    return state.status == FibreStatus::ok && breaks_at(fibre().curvature_at_midspan(state));
  }
  bool breaks_at(double curvature) {
    if (std::isnan(curvature)) return false;  // no state
    outcome_.greatest_curvature =
        std::max(outcome_.greatest_curvature, std::min(curvature, design_.breaking_curvature));
    return curvature >= design_.breaking_curvature;
  }

  bool breaks_on(double way) {
    const double S = fibre().length_at(way);
    return sees(fibre().state(S, curve_.friction.at(S).mu));
  }

  // The point of a piece at which the specimen breaks, from some of its nodes; otherwise the end.
  double unbroken_until(const CurvePiece& piece, double from, double to) {
    constexpr std::size_t nodes = 4, between = CurvePiece::degree / nodes;
    std::array<double, nodes> way, S, q, w;
    std::size_t n = 0;
    for (std::size_t node = between; node <= CurvePiece::degree; node += between) {
      way[n] = piece.coordinate_of(node);
      if (!(from < way[n] && way[n] <= to) || std::isnan(piece.F[node])) continue;
      S[n] = fibre().length_at(way[n]);
      q[n] = piece.q[node];
      w[n] = piece.stage[node] - piece.F[node] / design_.rig.stiffness;
      ++n;
    }
    const auto curvatures =
        fibre().curvatures_at_midspan({std::span(S).first(n), std::span(q).first(n)}, std::span(w).first(n));
    double low = from;
    for (std::size_t i = 0; i < n; low = way[i++])
      if (breaks_at(curvatures[i])) return broken_between(low, way[i]);
    return to;
  }
  double broken_between(double sound, double broken) {
    breaks_ = true;
    return first_where(sound, broken, [&](double way) { return breaks_on(way); });
  }

  // Follows a stable part; false if the force vanishes or the specimen breaks. The tracer may have
  // passed an interval without a force; the loading then ends there.
  bool slide(const StablePart& part, const Rest& rest_from, const Rest& rest_to) {
    const auto& [from, to] = part;
    const double work_before = outcome_.work, last = fibre().sliding_coordinate(to.S);
    slid_to_ = from.S;
    bool is_held = true;
    for (double way = fibre().sliding_coordinate(from.S); is_held && !breaks_ && way < last;) {
      const CurvePiece piece = piece_beyond(way, last);
      double end = unbroken_until(piece, way, std::min(piece.to, last));
      if (!breaks_ && end == last && sees(rest_to.state)) end = broken_between(way, last);
      is_held = end == way || read_along(piece, way, end, 0);
      way = end;
    }
    is_held = is_held && !breaks_;
    const FibreState reached = is_held ? rest_to.state : fibre().state(slid_to_, curve_.friction.at(slid_to_).mu);
    outcome_.friction_heat += outcome_.work - work_before - (reached.U - rest_from.state.U);
    outcome_.stage_reached = is_held ? to.stage : reached.w + reached.F / design_.rig.stiffness;
    outcome_.w_reached = reached.w;
    greatest_.see(reached.F);
    return is_held;
  }

  // The stored segment that continues from this position, or a new one if none is stored.
  CurvePiece piece_beyond(double way, double last) {
    while (next_piece_ < curve_.pieces.size() && !(way < curve_.pieces[next_piece_].to)) ++next_piece_;
    if (next_piece_ < curve_.pieces.size()) return curve_.pieces[next_piece_];
    const double S = fibre().length_at(way), S_last = fibre().length_at(last);
    const double end =
        S < S_last
            ? fibre().sliding_coordinate(end_of_stretch(curve_.friction, fibre(), S, S_last, CurvePiece::longest))
            : last;
    // what rounding of lengths cannot separate is one piece
    return piece_between(way, end > way ? end : last);
  }
  CurvePiece piece_between(double from, double to) const {
    return pieces_between(curve_.friction, design_.rig, Sliding::in, std::array{from, to}).front();
  }

  // Reads the forces along a part of a piece; false if a state is missing.
  bool read_along(const CurvePiece& nodes, double from, double to, int halvings) {
    // of the last coefficients; the polynomial is a hundred times better
    constexpr double accuracy = 1e-6;
    // needed only where friction begins or ceases to be limited at zero
    constexpr int max_halvings = 12;
    const SlidingPiece piece(nodes, design_.rig, from, to);
    const double middle = 0.5 * (from + to);
    const bool can_halve = halvings < max_halvings && from < middle && middle < to;
    if (can_halve && (!piece.exists() || piece.error() > accuracy))
      return read_along(piece_between(from, middle), from, middle, halvings + 1) &&
             read_along(piece_between(middle, to), middle, to, halvings + 1);
    if (!piece.exists()) return false;
    read(piece, to);
    return true;
  }

  void read(const SlidingPiece& piece, double to) {
    const auto turns = piece.turns();
    greatest_.see(piece.force_from());  // friction may have a corner there
    greatest_.see(piece.force_to());
    for (const auto& turn : turns) greatest_.see_top(turn.F, fibre().length_at(turn.way));
    if (readings_)
      read_in_steps(piece, turns);
    else
      read_all(piece, turns);
    outcome_.work += piece.work();
    slid_to_ = fibre().length_at(to);
  }

  void read_all(const SlidingPiece& piece, const SlidingPiece::Turns& turns) {
    drops_.read(piece.force_from());
    for (const auto& turn : turns) drops_.read(turn.F);
    drops_.read(piece.force_to());
  }

  // Between two turns the force is monotone, so only the readings next to a turn matter.
  void read_in_steps(const SlidingPiece& piece, const SlidingPiece::Turns& turns) {
    const double last = readings_->first_beyond(piece.stage_to()) - 1;
    const auto read = [&](double i) {
      if (i < next_ || i > last) return;
      drops_.read(piece.force_at(readings_->position(i)));
      next_ = i + 1;
    };
    read(next_);
    for (const auto& turn : turns) {
      const double beyond = readings_->first_beyond(turn.stage);
      read(beyond - 1);
      read(beyond);
    }
    read(last);
  }

  // ∫ μ Pn dS of a snap; empty if some length has no equilibrium. At a fixed stage position the
  // support force and the contact point are smooth functions of the length for any friction. They
  // are interpolated by cubics between close lengths.
  std::optional<double> heat_of_snap(double stage, const Rest& from, const Rest& to) const {
    constexpr double near = 0.15;         // of S - 1
    constexpr double longest_part = 0.1;  // [L]
    const double length = to.state.S - from.state.S;
    const int parts = static_cast<int>(
        std::ceil(std::max(length / (near * (from.state.S - fibre().least_length())), length / longest_part)));
    double heat = 0;
    Rest a = from;
    for (int i = 1; i <= parts; ++i) {
      Rest b = to;
      if (i < parts) {
        const auto held = held_at(from.state.S + length * i / parts, stage, design_.rig, a.state.q);
        if (held.holding != Holding::held) return std::nullopt;
        b = rest_at(design_.rig, held.state.S, held.state.q, held.state.w);
      }
      heat += heat_between(a, b);
      a = b;
    }
    return heat;
  }

  double heat_between(const Rest& a, const Rest& b) const {
    const double length = b.state.S - a.state.S;
    const bool rolls = fibre().supports().radius > 0;
    const Cubic Pn(a.state.Pn, b.state.Pn, length * a.Pn_slope, length * b.Pn_slope);
    const Cubic contacts(a.contact, b.contact, length * a.contact_slope, length * b.contact_slope);
    const auto power = [&](double S) {
      const double t = (S - a.state.S) / length;
      FibreState held{};
      held.q = a.state.q + (b.state.q - a.state.q) * t;
      held.Pn = Pn.at(t).value;
      const double contact = rolls ? contacts.at(t).value : S;
      return design_.friction.at(contact).mu * held.Pn + fibre().bending_energy_lost_at_contact(held);
    };
    constexpr double scales = 2;  // smooth scales of friction: half the shortest period
    double heat = 0;
    for (double S = a.state.S; S < b.state.S;) {
      const double end = end_of_stretch(curve_.friction, fibre(), S, b.state.S, scales);
      heat += integral(gauss_6, S, end, power);
      S = end;
    }
    return heat;
  }

  void snap(double stage, const Rest& from, const Rest& to, double heat) {
    const FibreState& before = from.state;
    const FibreState& after = to.state;
    if (outcome_.snaps++ == 0) outcome_.first_snap = FirstSnap{stage, before.w, before.F, after.F};
    outcome_.largest_snap = std::max(outcome_.largest_snap, before.F - after.F);
    outcome_.work += 0.5 * (before.F + after.F) * (after.w - before.w);
    outcome_.friction_heat += heat;
    outcome_.released += from.potential - to.potential - heat;
  }

  const Design& design_;
  std::optional<ReadingPositions> readings_;  // empty for a continuous record
  SlidingCurve curve_;
  DesignOutcome outcome_{};
  ForceFalls drops_;
  GreatestForce greatest_;
  double next_ = 0;     // index of the next reading
  double slid_to_ = 1;  // [L]
  std::size_t next_piece_ = 0;
  bool breaks_ = false;
};

// The deflection at which the specimen breaks; infinite if it does not break on some rig within the
// travel.
double breaking_deflection(const Design& design, const Rig& rig) {
  if (std::isinf(design.breaking_curvature)) return design.breaking_curvature;
  constexpr double scales = 0.75;
  const double S_max = longest_in_loading(design.friction, rig, design.travel);
  const Fibre& fibre = rig.fibre;
  const Friction friction = met(design.friction, fibre, 1, S_max);
  const auto state_at = [&](double S) { return fibre.state(S, friction.at(S).mu); };
  const auto breaks = [&](double S) {
    const FibreState state = state_at(S);
    return state.status == FibreStatus::ok && fibre.curvature_at_midspan(state) >= design.breaking_curvature;
  };
  for (double S = 1; S < S_max;) {
    const double next = end_of_stretch(friction, fibre, S, S_max, scales);
    if (breaks(next)) return state_at(first_where(S, next, breaks)).w;
    S = next;
  }
  return infinity;
}

void require_loading(const Design& design) {
  constexpr double min_deflection = 1e-6;  // below, S - 1 loses its digits
  const double deflection = beam_deflection(design.travel, design.rig.stiffness);
  if (!(deflection >= min_deflection))
    throw std::invalid_argument("a loading must bend the fibre by at least 1e-6 spans, not " +
                                std::to_string(1e6 * deflection) + "e-6");
  constexpr double max_readings = 1e9;  // counts of readings are doubles
  if (!(design.step >= 0 && std::isfinite(design.step)))
    throw std::invalid_argument("the step of the stage must be finite and not negative, not " +
                                std::to_string(design.step));
  if (design.step > 0 && design.travel / design.step > max_readings)
    throw std::invalid_argument("a loading has at most 1e9 readings, not " +
                                std::to_string(design.travel / design.step));
}

}  // namespace

DesignOutcome outcome_of(const Design& design) {
  require_loading(design);
  return Loading(design).outcome();
}

bool snaps(const Design& design) {
  require_loading(design);
  const double longest = longest_in_loading(design.friction, design.rig, design.travel);
  const double breaks = breaking_deflection(design, design.rig);
  for (const double part : {1.0 / 64, 1.0 / 16, 0.25, 1.0}) {
    const auto curve = trace_loading_curve(design.friction, design.rig, 1 + part * (longest - 1));
    if (curve.folds.empty()) continue;
    const auto& fold = curve.folds.front().point;
    if (fold.stage >= design.travel || fold.w >= breaks) return false;
    if (const auto landing = landing_after(curve, fold.S, fold.stage))
      return snap_work(design.friction, design.rig, fold.stage, fold.S, landing->S).has_value();
  }
  return false;
}

double critical_stiffness(const Design& design) {
  constexpr double above = 1e-7;
  constexpr double settled = 1e-9;
  constexpr double min_deflection_traced = 1e-6;  // [L] smallest deflection that can be traced
  double stiffness = infinity;
  const double breaks = breaking_deflection(design, {stiffness, design.rig.fibre});
  double deflection = std::min(design.travel, breaks);
  while (true) {
    const double critical = (1 + above) * critical_stiffness(design.friction, deflection, design.rig.fibre);
    if (!(critical < (1 - settled) * stiffness)) return critical;
    // A rig this soft bends the specimen too little for sliding.
    if (!(beam_deflection(design.travel, critical) > min_deflection_traced)) return 0;
    stiffness = critical;
    const Rig rig{stiffness, design.rig.fibre};
    const auto curve =
        trace_loading_curve(design.friction, rig, longest_in_loading(design.friction, rig, design.travel));
    // a thick specimen has not begun to slide in
    if (curve.begin.stage >= design.travel) return 0;
    const StablePart part = stable_part_from(curve, curve.begin);
    const double reached = part.to.stage > design.travel ? point_at_stage(curve, part, design.travel).w : part.to.w;
    deflection = std::max(std::min(reached, breaks), min_deflection_traced);
  }
}

double stiffness_margin(const Design& design, const DesignOutcome& outcome) {
  constexpr double max_margin = 3;
  constexpr double min_deflection = 1e-6;
  const double w = outcome.status == DesignStatus::slipped_through ? design.travel : outcome.w_reached;
  const double critical = critical_stiffness(design.friction, std::max(w, min_deflection), design.rig.fibre);
  if (std::isinf(critical)) return -max_margin;
  return std::clamp(elementary::log(design.rig.stiffness / critical), -max_margin, max_margin);
}

std::vector<FoldPoint> folds_up_to(const Friction& along, double w_max, const Fibre& fibre) {
  constexpr double per_period = 96;
  constexpr double per_knot = 8;
  const double S_max = longest_in_loading(along, {infinity, fibre}, w_max);
  const Friction friction = met(along, fibre, 1, S_max);
  const double for_waves = per_period * (S_max - 1) / (4 * friction.smooth_scale());
  const double for_knots = per_knot * static_cast<double>(friction.knots().size());
  const int n = static_cast<int>(std::clamp(std::max(for_waves, for_knots), 400.0, 20000.0));
  std::vector<FoldPoint> points;
  points.reserve(static_cast<std::size_t>(n));
  for (int i = 1; i <= n; ++i) {
    const double S = fibre.length_at(fibre.sliding_coordinate(1) +
                                     (fibre.sliding_coordinate(S_max) - fibre.sliding_coordinate(1)) * i / n);
    const auto state = fibre.state(S, friction.at(S).mu);
    if (state.status != FibreStatus::ok || state.w > w_max) break;
    points.push_back({state.w, state.F, stiffness_of_fold(friction, S, fibre)});
  }
  return points;
}

}  // namespace flexslip
