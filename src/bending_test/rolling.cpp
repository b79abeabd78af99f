#include "bending_test/rolling.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace flexslip {

// The secant method within brackets, from the straight fibre's stiffness on.
std::optional<LooseState> state_at_stage(double stage, double stiffness, const Supports& supports) {
  if (!(stage >= 0 && stiffness > 0))
    throw std::invalid_argument("a stage at " + std::to_string(stage) + " on a stiffness of " +
                                std::to_string(stiffness) + " bends no specimen");
  if (stage == 0) {
    LooseState straight{{}, 1};
    straight.state.status = FibreStatus::ok;
    straight.state.length = straight.state.imaged = 1;
    return straight;
  }
  constexpr int most_steps = 100;
  constexpr double rounding = 1e-13, straight = 48;
  double low = 0, high = std::min(stage, deepest_on_supports), miss_low = -stage,
         w = stage / (1 + straight / stiffness);
  for (int i = 0; i < most_steps; ++i) {
    w = std::min(w, high);
    const LooseState found = state_on_loose_rollers(w, supports);
    if (found.state.status != FibreStatus::ok) {
      high = w;
      w = 0.5 * (low + high);
      if (high - low <= rounding * stage) return std::nullopt;
      continue;
    }
    const double miss = w + found.state.F / stiffness - stage;
    if (std::abs(miss) <= rounding * stage || high - low <= rounding * stage) return found;
    const double secant = w - miss * (w - low) / (miss - miss_low);
    if (miss < 0) {
      low = w;
      miss_low = miss;
    } else {
      high = w;
    }
    w = secant > low && secant < high ? secant : 0.5 * (low + high);
  }
  return std::nullopt;
}

}  // namespace flexslip
