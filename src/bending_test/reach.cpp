#include "bending_test/reach.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "fibre/elastica.h"

namespace flexslip {

double longest_in_loading(const Friction& friction, const Rig& rig, double stage) {
  if (!(rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(rig.stiffness));
  constexpr double close = 0.99;  // more halvings would cost what the shorter trace saves
  double low = 0;
  double high = std::sqrt(longest_at_stage(stage) - 1);
  while (low < close * high) {
    const double middle = 0.5 * (low + high);
    const double S = 1 + middle * middle;
    const double mu = friction.at(S).mu;
    const auto state = fibre_state(S, mu);
    const bool is_within = state.status == FibreStatus::ok && state.w + state.F / rig.stiffness < stage;
    (is_within ? low : high) = middle;
  }
  return 1 + high * high;
}

}  // namespace flexslip
