#include "bending_test/history.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "bending_test/motion.h"
#include "bending_test/trace.h"
#include "contact/over_rollers.h"

namespace flexslip {
namespace {

std::vector<Crack> in_reverse(std::vector<Crack> cracks) {
  for (const Crack& crack : cracks)
    if (!(crack.w > 0 && std::isfinite(crack.w) && crack.loss > 0 && crack.loss < 1))
      throw std::invalid_argument("a crack at a deflection of " + std::to_string(crack.w) + " with a loss of " +
                                  std::to_string(crack.loss) + " is none");
  std::stable_sort(cracks.begin(), cracks.end(), [](const Crack& a, const Crack& b) { return a.w < b.w; });
  std::reverse(cracks.begin(), cracks.end());
  return cracks;
}

}  // namespace

CrackingFibre::CrackingFibre(BendingTest test, std::vector<Crack> cracks, double farthest)
    : test_(std::move(test)), farthest_(farthest), cracks_(in_reverse(std::move(cracks))), fibre_(test_, farthest) {
  if (!(test_.wear > 0 && test_.wear <= 1))
    throw std::invalid_argument("wear leaves a share of friction above 0 and at most 1, not " +
                                std::to_string(test_.wear));
}

PathPoint CrackingFibre::in_first_units(PathPoint point) const {
  point.F *= left_;
  point.left = left_;
  return point;
}

Stretch CrackingFibre::in_first_units(const Stretch& stretch) const {
  return {in_first_units(stretch.from), in_first_units(stretch.to), in_first_units(stretch.jump)};
}

StretchWork CrackingFibre::in_first_units(const StretchWork& work) const {
  return {work.stage * left_, work.friction * left_, work.released * left_};
}

std::optional<Stretch> CrackingFibre::advance_towards(double stage) {
  if (end() != HistoryStatus::ok) return std::nullopt;
  if (due_) return crack();
  wear_at_turn(stage);
  std::optional<Stretch> stretch;
  if (std::exchange(has_to_settle_, false)) stretch = fibre_.settle();
  if (!stretch) stretch = cracks_.empty() ? fibre_.advance_towards(stage) : advance_to_next(stage);
  if (!stretch) return due_ ? crack() : stretch;
  due_ = due_ || (!cracks_.empty() && stretch->to.w >= cracks_.back().w);
  return in_first_units(*stretch);
}

void CrackingFibre::wear_at_turn(double stage) {
  const double here = fibre_.state().stage;
  const Sliding onward = stage == here ? towards_ : stage > here ? Sliding::in : Sliding::out;
  if (std::exchange(towards_, onward) == onward || test_.wear == 1) return;
  fibre_.scale_friction(test_.wear);
  has_to_settle_ = true;
}

// Stops at the next crack.
std::optional<Stretch> CrackingFibre::advance_to_next(double stage) {
  const auto here = fibre_.position();
  const auto stretch = fibre_.advance_towards(stage);
  const double w = cracks_.back().w;
  const bool moves = stretch && stretch->from.stage != stretch->to.stage;
  const bool on_the_way = moves && stretch->from.w <= w && w < stretch->to.w;
  if (!on_the_way) return stretch;
  fibre_.return_to(here);
  due_ = true;
  return fibre_.advance_towards(fibre_.stage_at_deflection(*stretch, w));
}

Stretch CrackingFibre::crack() {
  const auto energy = [&](const PathPoint& point) { return account_after({}, {}, point, test_.rig); };
  Stretch stretch{state(), {}};
  left_ *= 1 - cracks_.back().loss;
  cracks_.pop_back();
  fibre_ = MovingFibre({fibre_.friction(), rig(), test_.rest}, farthest_, stretch.from);
  stretch.to = state();
  stretch.to.motion = Motion::crack;
  const EnergyAccount before = energy(stretch.from), after = energy(stretch.to);
  stretch.jump.cracked = before.bending + before.load_train - (after.bending + after.load_train);
  due_ = !cracks_.empty() && stretch.to.w >= cracks_.back().w;
  has_to_settle_ = true;
  return stretch;
}

StretchWork CrackingFibre::work_of(const Stretch& stretch) {
  if (stretch.is_jump()) return stretch.jump;
  // lengths and frictions have no unit of stiffness
  return in_first_units(fibre_.work_of(stretch));
}

std::vector<Stretch> CrackingFibre::parts_of(const Stretch& stretch, int n) {
  if (stretch.is_jump()) return {stretch};
  std::vector<Stretch> parts;
  for (const Stretch& part : fibre_.parts_of(stretch, n)) parts.push_back(in_first_units(part));
  parts.front().from = stretch.from;
  parts.back().to = stretch.to;
  return parts;
}

namespace {

// The maximum stage position of a programme.
double farthest_of(std::span<const double> stages) {
  double farthest = 0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (!(stages[i] >= 0 && std::isfinite(stages[i])))
      throw std::invalid_argument("stage position " + std::to_string(i) + " must be finite and not negative: it is " +
                                  std::to_string(stages[i]));
    farthest = std::max(farthest, stages[i]);
  }
  if (!(farthest > 0)) throw std::invalid_argument("the stage programme has no position above 0");
  return farthest;
}

// An account of a path that records nothing; the other one records energies.
class NoBooks {
 public:
  void account_for(CrackingFibre&, const Stretch&) {}
  void close_point() {}
};

class Books {
 public:
  explicit Books(const Rig& rig) : rig_(rig) {}

  void account_for(CrackingFibre& fibre, const Stretch& stretch) {
    now = account_after(now, fibre.work_of(stretch), stretch.to, rig_);
  }
  void close_point() { at_points.push_back(now); }

  EnergyAccount now{};
  std::vector<EnergyAccount> at_points;

 private:
  Rig rig_;
};

// Moves a specimen and records its path.
template <class Noted>
class Recorder {
 public:
  Recorder(const BendingTest& test, const std::vector<Crack>& cracks, double farthest, Noted books)
      : rig_(test.rig), fibre_(test, cracks, farthest), books_(std::move(books)) {}

  // Moves to a stage position; false if the specimen does not reach it.
  bool move_to(double stage) {
    if (stage == fibre_.state().stage) fibre_.halt();
    Motion motion = Motion::stick;
    bool snapped = false, cracked = false;
    while (const auto stretch = fibre_.advance_towards(stage)) {
      account_for(*stretch);
      motion = stretch->to.motion;
      snapped = snapped || motion == Motion::snap;
      cracked = cracked || motion == Motion::crack;
    }
    if (fibre_.end() != HistoryStatus::ok) return false;
    PathPoint point = fibre_.state();
    point.motion = cracked ? Motion::crack : snapped ? Motion::snap : motion;
    record(point);
    return true;
  }

  // The same with n points on each segment.
  bool move_along(double stage, int n) {
    if (stage == fibre_.state().stage) fibre_.halt();
    while (const auto stretch = fibre_.advance_towards(stage)) {
      const bool is_straight = stretch->from.S == 1 && stretch->to.S == 1 && rig_.fibre.slides_inward_only();
      if (is_straight) continue;  // no force
      for (const Stretch& part : fibre_.parts_of(*stretch, n)) {
        account_for(part);
        record(part.to);
      }
    }
    return fibre_.end() == HistoryStatus::ok;
  }

  void record(const PathPoint& point) {
    path_.path.push_back(point);
    books_.close_point();
    if (const TwoSupportPath* path = fibre_.friction().kinetic.two_supports())
      path_.contacts.push_back(path->points_at(std::max(point.S, 1.0)));
  }

  PathPoint state() const { return fibre_.state(); }

  TestPath path() && {
    path_.status = fibre_.end();
    return std::move(path_);
  }
  Noted books() && { return std::move(books_); }

 private:
  void account_for(const Stretch& stretch) {
    books_.account_for(fibre_, stretch);
    const auto& [from, to, jump] = stretch;
    if (to.motion == Motion::snap) path_.snaps.push_back({to.stage, from, to, jump.friction, jump.released});
    if (to.motion == Motion::crack) path_.cracks.push_back({to.stage, from, to, jump.cracked});
  }

  Rig rig_;
  CrackingFibre fibre_;
  Noted books_;
  TestPath path_{};
};

History history_of(Recorder<Books> recorder) {
  Books books = std::move(recorder).books();
  return {std::move(recorder).path(), std::move(books.at_points), books.now};
}

template <class Noted>
Recorder<Noted> in_steps(const BendingTest& test, std::span<const double> stages, const std::vector<Crack>& cracks,
                         Noted books, const HistoryProgress& progress = {}) {
  Recorder<Noted> recorder(test, cracks, farthest_of(stages), std::move(books));
  for (std::size_t i = 0; i < stages.size() && recorder.move_to(stages[i]); ++i)
    if (progress) progress(i + 1, stages.size());
  return recorder;
}

template <class Noted>
Recorder<Noted> continuously(const BendingTest& test, std::span<const double> turning_points, int n,
                             const std::vector<Crack>& cracks, Noted books, const HistoryProgress& progress = {}) {
  if (n < 2) throw std::invalid_argument("a stretch needs at least 2 points, not " + std::to_string(n));
  Recorder<Noted> recorder(test, cracks, farthest_of(turning_points), std::move(books));
  recorder.record(recorder.state());
  for (std::size_t i = 0; i < turning_points.size() && recorder.move_along(turning_points[i], n); ++i)
    if (progress) progress(i + 1, turning_points.size());
  return recorder;
}

}  // namespace

TestPath path_in_steps(const BendingTest& test, std::span<const double> stages) {
  return in_steps(test, stages, {}, NoBooks()).path();
}

TestPath path_continuously(const BendingTest& test, std::span<const double> turning_points, int n) {
  return continuously(test, turning_points, n, {}, NoBooks()).path();
}

History follow_in_steps(const BendingTest& test, std::span<const double> stages, const std::vector<Crack>& cracks,
                        const HistoryProgress& progress) {
  return history_of(in_steps(test, stages, cracks, Books(test.rig), progress));
}

History follow_continuously(const BendingTest& test, std::span<const double> turning_points, int n,
                            const std::vector<Crack>& cracks, const HistoryProgress& progress) {
  return history_of(continuously(test, turning_points, n, cracks, Books(test.rig), progress));
}

std::vector<double> stage_steps(std::span<const double> turns, double step) {
  constexpr double max_steps = 1e8;  // 800 MB
  if (turns.empty()) throw std::invalid_argument("a programme of the stage without positions");
  if (!(step > 0)) throw std::invalid_argument("a step of the stage must be > 0, not " + std::to_string(step));
  std::vector<double> stages{turns.front()};
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double from = turns[i - 1];
    const double way = turns[i] - from;
    // A remainder of 1e-9 of a step is rounding.
    const double steps = std::ceil(std::abs(way) / step - 1e-9);
    if (!(static_cast<double>(stages.size()) + steps < max_steps))
      throw std::invalid_argument("a programme of the stage with 1e8 steps or more");
    for (double n = 1; n < steps; ++n) stages.push_back(from + std::copysign(n * step, way));
    stages.push_back(turns[i]);
  }
  return stages;
}

namespace {

int points_drawn_for(const Friction& friction, double S_max) {
  constexpr double max_points = 20000;
  const double waves = 16 * (S_max - 1) / friction.smooth_scale();
  return static_cast<int>(
      std::clamp(std::max(waves, 8.0 * static_cast<double>(friction.knots().size())), 300.0, max_points));
}

// Adds the straight specimen, which a thick one leaves at once.
std::vector<EquilibriumPoint> from_straight(std::vector<EquilibriumPoint> curve) {
  if (curve.front().w > 0) curve.insert(curve.begin(), {1, 0, 0, 0});
  return curve;
}

std::vector<EquilibriumPoint> sliding_curve(const Friction& friction, Sliding sliding, double S_max,
                                            const Fibre& fibre) {
  return from_straight(equilibrium_curve(friction, sliding, S_max, points_drawn_for(friction, S_max), fibre).points);
}

constexpr double shortest = 1.01;  // [L] smallest range of a figure

}  // namespace

EquilibriumPortrait portrait_of(const Friction& friction, const Fibre& fibre, double S_max) {
  EquilibriumPortrait portrait{
      sliding_curve(friction, Sliding::in, S_max, fibre), sliding_curve(friction, Sliding::out, S_max, fibre), {}, {}};
  portrait.frictionless = sliding_curve(Friction::constant(0), Sliding::in, S_max, fibre);
  const double S = 1 + 0.7 * (portrait.in.back().S - 1);
  const double max_q = met(friction, fibre, 1, S_max).at(S).mu, min_q = -met(friction, fibre, -1, S_max).at(S).mu;
  constexpr int levels = 60;
  for (int i = 0; i <= levels; ++i) {
    const double q = min_q + (max_q - min_q) * i / levels;
    const FibreState state = fibre.state(S, q);
    if (state.status == FibreStatus::ok) portrait.at_one_length.push_back({S, q, state.w, state.F});
  }
  return portrait;
}

SlidingLimits limits_of(const BendingTest& test, const History& history) {
  double S_max = shortest;
  for (const auto& point : history.path) S_max = std::max(S_max, point.S);
  for (const auto& snap : history.snaps) S_max = std::max({S_max, snap.before.S, snap.after.S});
  const Friction& friction = test.friction.kinetic;
  SlidingLimits limits{sliding_curve(friction, Sliding::in, S_max, test.rig.fibre), {}};
  if (!friction.is_path_dependent())
    limits.out = sliding_curve(friction.scaled(test.wear), Sliding::out, S_max, test.rig.fibre);
  return limits;
}

OverallPortrait overall_portrait(const Friction& friction, const Rig& rig, std::span<const double> stages) {
  const double farthest = *std::max_element(stages.begin(), stages.end());
  const SlidingCurve traced = trace_loading_curve(friction, rig, longest_at_stage(farthest));
  OverallPortrait portrait;
  double S_max = shortest;
  for (const double stage : stages) {
    portrait.at_stage.push_back(overall_equilibria(traced, stage));
    for (const auto& equilibrium : portrait.at_stage.back()) S_max = std::max(S_max, equilibrium.point.S);
  }
  S_max = std::min(1 + 1.1 * (S_max - 1), traced.end.S);
  portrait.in = sliding_curve(friction, Sliding::in, S_max, rig.fibre);
  return portrait;
}

std::vector<EquilibriumPoint> frictionless_up_to(double deflection, int n, const Fibre& fibre) {
  return from_straight(sliding_up_to(deflection, 0, n, fibre));
}

}  // namespace flexslip
