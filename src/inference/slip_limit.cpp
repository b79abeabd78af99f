#include "inference/slip_limit.h"

#include <algorithm>

#include "numerics/elementary.h"

namespace flexslip {
namespace {

struct Range {
  double least, most;  // [EI/L^2]
};

// Of the force at a deflection, over all friction that there may be.
Range forces_at(double w, const Supports& supports) {
  constexpr int steps = 10;
  Range range{infinity, 0};
  for (int i = 0; i <= steps; ++i) {
    const auto state = state_on_supports(w, most_lost_friction * i / steps, supports);
    if (state.status != FibreStatus::ok) return {range.least, infinity};  // it can hold whatever comes
    range = {std::min(range.least, state.F), std::max(range.most, state.F)};
  }
  return range;
}

}  // namespace

std::vector<double> most_by_slips(const ReducedRecord& record, std::span<const Drop> drops, const Supports& supports) {
  std::vector<double> most;
  for (const Drop& drop : drops) {
    const double w = record.deflection[drop.before], after = record.deflection[drop.after];
    if (!(w > 0 && after > 0)) {
      most.push_back(0);
      continue;
    }
    const double left = forces_at(after, supports).least / forces_at(w, supports).most;
    most.push_back(record.force[drop.before] * std::max(1 - left, 0.0));
  }
  return most;
}

}  // namespace flexslip
