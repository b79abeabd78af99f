#include "bending_test/cracking_fibre.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "bending_test/energy.h"

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
    : test_(std::move(test)), farthest_(farthest), cracks_(in_reverse(std::move(cracks))), fibre_(test_, farthest) {}

PathPoint CrackingFibre::in_first_units(PathPoint point) const {
  point.F *= left_;
  point.left = left_;
  return point;
}

Stretch CrackingFibre::in_first_units(Stretch stretch) const {
  auto& [from, to, work] = stretch;
  return {in_first_units(from), in_first_units(to), {work.stage * left_, work.friction * left_, work.released * left_}};
}

std::optional<Stretch> CrackingFibre::advance_towards(double stage) {
  if (end() != HistoryStatus::ok) return std::nullopt;
  if (due_) return crack();
  std::optional<Stretch> stretch;
  if (std::exchange(cracked_, false)) stretch = fibre_.settle();
  if (!stretch) stretch = cracks_.empty() ? fibre_.advance_towards(stage) : advance_to_next(stage);
  if (!stretch) return due_ ? crack() : stretch;
  due_ = due_ || (!cracks_.empty() && stretch->to.w >= cracks_.back().w);
  return in_first_units(*stretch);
}

// No farther than to the next crack.
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
  const auto energy = [&](const PathPoint& point) { return account_after({}, {point, point, {}}, test_.rig); };
  Stretch stretch{state(), {}, {}};
  left_ *= 1 - cracks_.back().loss;
  cracks_.pop_back();
  fibre_ = MovingFibre({fibre_.friction(), rig(), test_.rest}, farthest_, stretch.from);
  stretch.to = state();
  stretch.to.motion = Motion::crack;
  const EnergyAccount before = energy(stretch.from), after = energy(stretch.to);
  stretch.work.cracked = before.bending + before.load_train - (after.bending + after.load_train);
  due_ = !cracks_.empty() && stretch.to.w >= cracks_.back().w;
  cracked_ = true;
  return stretch;
}

std::vector<Stretch> CrackingFibre::parts_of(const Stretch& stretch, int n) {
  if (stretch.from.stage == stretch.to.stage) return {stretch};
  std::vector<Stretch> parts;
  for (const Stretch& part : fibre_.parts_of(stretch, n)) parts.push_back(in_first_units(part));
  parts.front().from = stretch.from;
  parts.back().to = stretch.to;
  return parts;
}

}  // namespace flexslip
