#include "bending_test/reach.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "contact/over_rollers.h"

namespace flexslip {

double longest_in_loading(const Friction& along, const Rig& rig, double stage) {
  if (!(rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(rig.stiffness));
  constexpr double close = 0.99;  // more halvings would cost what the shorter trace saves
  const double S_most = longest_at_stage(stage);
  const Friction friction = met(along, rig.fibre, 1, S_most);
  double low = rig.fibre.way(1);
  double high = rig.fibre.way(S_most);
  while (low < close * high) {
    const double middle = 0.5 * (low + high);
    const double S = rig.fibre.length_at(middle);
    const double mu = friction.at(S).mu;
    const auto state = rig.fibre.state(S, mu);
    const bool is_within = state.status == FibreStatus::ok && state.w + state.F / rig.stiffness < stage;
    (is_within ? low : high) = middle;
  }
  return rig.fibre.length_at(high);
}

}  // namespace flexslip
