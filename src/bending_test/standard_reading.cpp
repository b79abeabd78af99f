#include "bending_test/standard_reading.h"

#include <array>
#include <stdexcept>
#include <string>

#include "bending_test/history.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"

namespace flexslip {

std::optional<StandardReading> standard_reading(const Fibre& fibre, double friction, const LoadingRead& read) {
  const auto [from, to, greatest] = read;
  if (!(friction >= 0 && friction <= fibre.max_friction()))
    throw std::invalid_argument("friction is " + std::to_string(friction));
  if (!(from >= 0 && from < to && to <= greatest))
    throw std::invalid_argument("deflections do not rise: " + std::to_string(from) + ", " + std::to_string(to) + ", " +
                                std::to_string(greatest));
  if (greatest > deepest_on_supports) return std::nullopt;
  const BendingTest test{.friction = Friction::constant(friction), .rig = {.stiffness = infinity, .fibre = fibre}};
  const History way = follow_in_steps(test, std::array{from, to, greatest});
  if (way.status != HistoryStatus::ok || way.path.size() < 3) return std::nullopt;
  const auto& end = way.path[2];
  const double curvature = fibre.curvature_at_midspan(state_at(fibre, end));
  return StandardReading{.modulus = (way.path[1].F - way.path[0].F) / (beam_stiffness * (to - from)),
                         .stress = end.F / (4 * curvature),  // a beam's curvature is F/4
                         .work = way.energy.friction / way.energy.stage_work};
}

}  // namespace flexslip
