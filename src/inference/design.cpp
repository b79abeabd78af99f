#include "inference/design.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "bending_test/quadrature.h"
#include "bending_test/reach.h"
#include "bending_test/snap.h"
#include "fibre/elastica.h"
#include "inference/sliding_piece.h"

namespace flexslip {
namespace {

// Which reading stands where: at every whole step of the stage, and at the end of its travel.
class Readings {
 public:
  Readings(double travel, double step) : travel_(travel), step_(step), last_(std::ceil(travel / step - rounding)) {}

  double position(double i) const { return i < last_ ? i * step_ : travel_; }
  // The first reading beyond a stage position, and the last one that is not.
  double first_beyond(double stage) const {
    double i = std::clamp(std::floor(stage / step_) + 1, 0.0, last_ + 1);
    while (i > 0 && position(i - 1) > stage) --i;
    while (i <= last_ && position(i) <= stage) ++i;
    return i;
  }

 private:
  static constexpr double rounding = 1e-9;  // of a step: a last one as short as that is none
  double travel_, step_, last_;
};

// Forces in the order in which they are read, or as many of them as tell where they fall.
class Drops {
 public:
  void read(double F) {
    // What is read off a polynomial is rounded.
    constexpr double rounding = 1e-11;
    if (F < last_ - rounding * last_) {
      if (!falling_) top_ = last_;
      falling_ = true;
    } else if (F > last_ + rounding * last_) {
      end_fall();
    } else {
      return;
    }
    last_ = F;
  }

  void tell(DesignOutcome& outcome) {
    end_fall();
    outcome.drops = count_;
    outcome.largest_drop = largest_;
    outcome.mean_drop = count_ > 0 ? sum_ / static_cast<double>(count_) : 0;
  }

 private:
  void end_fall() {
    if (!falling_) return;
    falling_ = false;
    ++count_;
    sum_ += top_ - last_;
    largest_ = std::max(largest_, top_ - last_);
  }

  double last_ = 0;
  double top_ = 0;
  bool falling_ = false;
  std::size_t count_ = 0;
  double sum_ = 0;
  double largest_ = 0;
};

// A state with what holds the stage there, and how it changes as the fibre slides at that stage position.
struct Rest {
  FibreState state;
  double potential;  // [EI/L] U + F^2/2k
  double Pn_slope;   // [EI/L^3] dPn/dS
};

Rest rest_at(const Rig& rig, double S, double q) {
  const double c = 1 / rig.stiffness;
  const auto [state, slopes] = fibre_state_slopes(S, q);
  const double q_slope = -(slopes.w_S + c * slopes.F_S) / (slopes.w_q + c * slopes.F_q);
  return {state, state.U + 0.5 * c * state.F * state.F, slopes.Pn_S + slopes.Pn_q * q_slope};
}

// Walks along the curve of a loading, from one stable part to the next.
class Loading {
 public:
  explicit Loading(const Design& design)
      : design_(design),
        readings_(design.travel, design.step),
        curve_(trace_loading_curve(design.friction, design.rig,
                                   longest_in_loading(design.friction, design.rig, design.travel))) {}

  DesignOutcome outcome() {
    outcome_.status = walk();
    drops_.tell(outcome_);
    return outcome_;
  }

 private:
  DesignStatus walk() {
    RigPoint here = curve_.begin;
    Rest rest{fibre_state(here.S, here.q), 0, 0};
    for (std::size_t i = 0;; i += 2) {
      RigPoint to = point(i);
      const bool arrives = to.stage >= design_.travel;
      if (arrives) to = point_at_stage(curve_, {here, to}, design_.travel);
      const Rest end = rest_at(design_.rig, to.S, to.q);
      if (!slide(here, rest, to, end)) return DesignStatus::slipped_through;
      outcome_.end = arrives ? design_.travel : to.stage;
      if (arrives) {
        // The last reading, which may stand beyond the rounded end of its piece.
        if (design_.step > 0 && readings_.first_beyond(design_.travel) > next_) drops_.read(end.state.F);
        return DesignStatus::ok;
      }
      // The next rising part that comes up to this stage position.
      while (i + 2 <= curve_.folds.size() && point(i + 2).stage < to.stage) i += 2;
      if (i + 2 > curve_.folds.size()) return DesignStatus::slipped_through;
      here = landing(point(i + 1), point(i + 2), to.stage);
      here.stage = to.stage;
      rest = rest_at(design_.rig, here.S, here.q);
      const auto heat = friction_heat(to.stage, end, rest);
      if (!heat) return DesignStatus::slipped_through;
      snap(to.stage, end, rest, *heat);
    }
  }

  const RigPoint& point(std::size_t i) const { return i < curve_.folds.size() ? curve_.folds[i].point : curve_.end; }

  RigPoint landing(const RigPoint& low, const RigPoint& high, double stage) const {
    stage = std::clamp(stage, low.stage, high.stage);  // the folds of a snap may differ by less than rounding
    // G is level at both; of the cubic between them, the part that has risen.
    const double share = (stage - low.stage) / (high.stage - low.stage);
    const double t = 0.5 - std::sin(std::asin(1 - 2 * share) / 3);
    return point_at_stage(curve_, {low, high}, stage, low.S + t * (high.S - low.S));
  }

  // Is there a force all the way? The tracer may have stepped over a stretch without.
  bool slide(const RigPoint& from, const Rest& rest_from, const RigPoint& to, const Rest& rest_to) {
    constexpr double scales = 3;  // three quarters of the shortest period
    double work = 0;
    for (double S = from.S; S < to.S;) {
      const double end = end_of_stretch(design_.friction, S, to.S, scales);
      const auto work_there = read_along(S, end, 0);
      if (!work_there) return false;
      work += *work_there;
      S = end;
    }
    outcome_.work += work;
    outcome_.friction += work - (rest_to.state.U - rest_from.state.U);
    see(rest_to.state.F);
    return true;
  }

  // Reads the forces along a stretch, and returns the work done on the fibre there; none if there are not states all the way.
  std::optional<double> read_along(double S_from, double S_to, int halvings) {
    constexpr double accuracy = 1e-6;  // of the last coefficients: of the polynomial, a hundredth
    constexpr int most_halvings = 12;  // only a friction that begins or ends to be held at zero needs them
    const SlidingPiece piece(design_.friction, design_.rig, S_from, S_to);
    if (!piece.exists()) return std::nullopt;
    if (piece.error() > accuracy && halvings < most_halvings) {
      const double middle = 0.5 * (S_from + S_to);
      const auto before = read_along(S_from, middle, halvings + 1);
      const auto after = before ? read_along(middle, S_to, halvings + 1) : before;
      return after ? std::optional(*before + *after) : std::nullopt;
    }
    const auto turns = piece.turns();
    for (const auto& turn : turns) see(turn.F);
    if (design_.step > 0)
      read_in_steps(piece, turns);
    else
      read_all(piece, turns);
    return piece.work();
  }

  void read_all(const SlidingPiece& piece, const std::vector<SlidingPiece::Turn>& turns) {
    drops_.read(piece.force_from());
    for (const auto& turn : turns) drops_.read(turn.F);
    drops_.read(piece.force_to());
  }

  // Between two turns the forces rise or fall: only the readings beside them tell the falls.
  void read_in_steps(const SlidingPiece& piece, const std::vector<SlidingPiece::Turn>& turns) {
    const double last = readings_.first_beyond(piece.stage_to()) - 1;
    const auto read = [&](double i) {
      if (i < next_ || i > last) return;
      drops_.read(piece.force_at(readings_.position(i)));
      next_ = i + 1;
    };
    read(next_);
    for (const auto& turn : turns) {
      const double beyond = readings_.first_beyond(turn.stage);
      read(beyond - 1);
      read(beyond);
    }
    read(last);
  }

  void see(double F) { outcome_.greatest_force = std::max(outcome_.greatest_force, F); }

  // ∫ μ Pn dS of a snap. At a fixed stage position the force at the supports is a smooth function of the length, whatever the
  // friction: a cubic between lengths that are near one another for the elastica. None if the fibre is not held all the way.
  std::optional<double> friction_heat(double stage, const Rest& from, const Rest& to) const {
    constexpr double near = 0.15;   // of S - 1
    constexpr double short_ = 0.1;  // [L]
    const double length = to.state.S - from.state.S;
    const int parts = static_cast<int>(std::ceil(std::max(length / (near * (from.state.S - 1)), length / short_)));
    double heat = 0;
    Rest a = from;
    for (int i = 1; i <= parts; ++i) {
      Rest b = to;
      if (i < parts) {
        const auto held = held_at(from.state.S + length * i / parts, stage, design_.rig, a.state.q);
        if (held.holding != Holding::held) return std::nullopt;
        b = rest_at(design_.rig, held.state.S, held.state.q);
      }
      heat += heat_between(a, b);
      a = b;
    }
    return heat;
  }

  double heat_between(const Rest& a, const Rest& b) const {
    const double length = b.state.S - a.state.S;
    const double rise = b.state.Pn - a.state.Pn;
    const auto power = [&](double S) {
      const double t = (S - a.state.S) / length;
      const double s = 1 - t;
      const double Pn = a.state.Pn + rise * t * t * (1 + 2 * s) + length * t * s * (a.Pn_slope * s - b.Pn_slope * t);
      return design_.friction.at(S).mu * Pn;
    };
    constexpr double scales = 2;  // half the shortest period
    double heat = 0;
    for (double S = a.state.S; S < b.state.S;) {
      const double end = end_of_stretch(design_.friction, S, b.state.S, scales);
      heat += integral(gauss_6, S, end, power);
      S = end;
    }
    return heat;
  }

  void snap(double stage, const Rest& from, const Rest& to, double heat) {
    const FibreState& before = from.state;
    const FibreState& after = to.state;
    if (outcome_.snaps++ == 0) outcome_.first_snap = FirstSnap{stage, before.w, before.F, after.F};
    outcome_.work += 0.5 * (before.F + after.F) * (after.w - before.w);
    outcome_.friction += heat;
    outcome_.released += from.potential - to.potential - heat;
  }

  const Design& design_;
  Readings readings_;
  SlidingCurve curve_;
  DesignOutcome outcome_{};
  Drops drops_;
  double next_ = 0;  // reading
};

void require_loading(const Design& design) {
  if (!(design.step >= 0 && std::isfinite(design.step)))
    throw std::invalid_argument("the step of the stage must be finite and not negative, not " +
                                std::to_string(design.step));
}

}  // namespace

DesignOutcome outcome_of(const Design& design) {
  require_loading(design);
  return Loading(design).outcome();
}

}  // namespace flexslip
