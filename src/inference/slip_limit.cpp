#include "inference/slip_limit.h"

#include <algorithm>

#include "numerics/elementary.h"

namespace flexslip {
namespace {

double frictionless(double w, const Supports& supports) { return state_on_supports(w, 0, supports).F; }

// [1] Of the force at a deflection, what friction along the specimen holds of it at most; 1 where it can hold whatever comes. The surface of a bar
// slides outwards first, and inwards when it is bent farther.
double held_by_friction(double w, const Supports& supports) {
  constexpr int steps = 10;
  double most = 0;
  for (int i = -steps; i <= steps; ++i) {
    const auto state = state_on_supports(w, most_lost_friction * i / steps, supports);
    if (state.status != FibreStatus::ok) return 1;
    most = std::max(most, state.F);
  }
  return 1 - frictionless(w, supports) / most;
}

}  // namespace

std::vector<double> most_by_slips(const ReducedRecord& record, std::span<const Drop> drops, const Supports& supports) {
  constexpr int places = 20;  // up to a drop
  std::vector<double> most;
  for (const Drop& drop : drops) {
    const double w = record.deflection[drop.before], after = record.deflection[drop.after];
    if (!(w > 0 && after > 0)) {
      most.push_back(0);
      continue;
    }
    if (std::max(w, after) > deepest_on_supports) {  // beyond any state
      most.push_back(record.force[drop.before]);
      continue;
    }
    double held = 0;
    for (int i = 1; i <= places; ++i) held = std::max(held, held_by_friction(w * i / places, supports));
    const double left = (1 - held) * frictionless(after, supports) / frictionless(w, supports);
    most.push_back(record.force[drop.before] * std::max(1 - left, 0.0));
  }
  return most;
}

bool is_beyond_slips(double fall, double most, double noise) {
  constexpr double surely = 4;  // of the noise
  return fall > most + surely * noise;
}

}  // namespace flexslip
