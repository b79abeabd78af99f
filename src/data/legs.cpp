#include "data/legs.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace flexslip {

std::vector<Leg> find_legs(std::span<const double> stage, const LegOptions& options) {
  if (!(options.least_travel > 0 && options.least_travel < 1))
    throw std::invalid_argument("the least travel of a leg must lie between 0 and 1 of the range of the stage: " +
                                std::to_string(options.least_travel));
  for (std::size_t i = 0; i < stage.size(); ++i)
    if (!std::isfinite(stage[i]))
      throw std::invalid_argument("stage position " + std::to_string(i) +
                                  " is not finite: " + std::to_string(stage[i]));
  if (stage.empty()) return {};
  const auto [least, greatest] = std::minmax_element(stage.begin(), stage.end());
  const double travel = options.least_travel * (*greatest - *least);
  if (!(travel > 0)) return {};

  std::vector<Leg> legs;
  std::size_t first = 0;
  std::size_t lowest = 0;   // since the last turning point
  std::size_t highest = 0;  // likewise
  const auto turn = [&](std::size_t at, Direction ended) {
    legs.push_back({first, at + 1, ended});
    first = at + 1;
  };
  bool started = false;
  auto direction = Direction::loading;
  for (std::size_t i = 1; i < stage.size(); ++i) {
    if (stage[i] < stage[lowest]) lowest = i;
    if (stage[i] > stage[highest]) highest = i;
    const bool rose = stage[i] - stage[lowest] > travel;
    const bool fell = stage[highest] - stage[i] > travel;
    if (!started) {
      if (!rose && !fell) continue;
      started = true;
      direction = rose ? Direction::loading : Direction::unloading;
      lowest = highest = i;
    } else if (direction == Direction::loading && fell) {
      turn(highest, direction);
      direction = Direction::unloading;
      lowest = highest = i;
    } else if (direction == Direction::unloading && rose) {
      turn(lowest, direction);
      direction = Direction::loading;
      lowest = highest = i;
    }
  }
  legs.push_back({first, stage.size(), direction});
  return legs;
}

}  // namespace flexslip
