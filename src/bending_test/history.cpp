#include "bending_test/history.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace flexslip {
namespace {

// The greatest stage position of a programme.
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

// Moves a fibre and keeps the books.
class Recorder {
 public:
  Recorder(const BendingTest& test, const std::vector<Crack>& cracks, double farthest)
      : rig_(test.rig), fibre_(test, cracks, farthest) {}

  // To a stage position; false if the fibre does not get there.
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

  // The same with n points on each stretch.
  bool move_along(double stage, int n) {
    if (stage == fibre_.state().stage) fibre_.halt();
    while (const auto stretch = fibre_.advance_towards(stage)) {
      const bool is_straight = stretch->from.S == 1 && stretch->to.S == 1 && rig_.fibre.begins_straight();
      if (is_straight) continue;  // without a force
      for (const Stretch& part : fibre_.parts_of(*stretch, n)) {
        account_for(part);
        record(part.to);
      }
    }
    return fibre_.end() == HistoryStatus::ok;
  }

  void record(const PathPoint& point) {
    history_.path.push_back(point);
    history_.energy_at.push_back(history_.energy);
    if (const Walk* walk = fibre_.friction().kinetic.walk())
      history_.contacts.push_back(walk->points_at(std::max(point.S, 1.0)));
  }

  PathPoint state() const { return fibre_.state(); }

  History finish() {
    history_.status = fibre_.end();
    return std::move(history_);
  }

 private:
  void account_for(const Stretch& stretch) {
    history_.energy = account_after(history_.energy, stretch, rig_);
    const auto& [from, to, work] = stretch;
    if (to.motion == Motion::snap) history_.snaps.push_back({to.stage, from, to, work.friction, work.released});
    if (to.motion == Motion::crack) history_.cracks.push_back({to.stage, from, to, work.cracked});
  }

  Rig rig_;
  CrackingFibre fibre_;
  History history_{};
};

}  // namespace

History follow_in_steps(const BendingTest& test, std::span<const double> stages, const std::vector<Crack>& cracks,
                        const HistoryProgress& progress) {
  Recorder recorder(test, cracks, farthest_of(stages));
  for (std::size_t i = 0; i < stages.size() && recorder.move_to(stages[i]); ++i)
    if (progress) progress(i + 1, stages.size());
  return recorder.finish();
}

History follow_continuously(const BendingTest& test, std::span<const double> turning_points, int n,
                            const std::vector<Crack>& cracks, const HistoryProgress& progress) {
  if (n < 2) throw std::invalid_argument("a stretch needs at least 2 points, not " + std::to_string(n));
  Recorder recorder(test, cracks, farthest_of(turning_points));
  recorder.record(recorder.state());
  for (std::size_t i = 0; i < turning_points.size() && recorder.move_along(turning_points[i], n); ++i)
    if (progress) progress(i + 1, turning_points.size());
  return recorder.finish();
}

}  // namespace flexslip
