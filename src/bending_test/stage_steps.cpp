#include "bending_test/stage_steps.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace flexslip {

std::vector<double> stage_steps(std::span<const double> turns, double step) {
  constexpr double most_steps = 1e8;  // a gigabyte
  if (turns.empty()) throw std::invalid_argument("a programme of the stage without positions");
  if (!(step > 0)) throw std::invalid_argument("a step of the stage must be > 0, not " + std::to_string(step));
  std::vector<double> stages{turns.front()};
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double from = turns[i - 1];
    const double way = turns[i] - from;
    // A remainder of 1e-9 of a step is rounding.
    const double steps = std::ceil(std::abs(way) / step - 1e-9);
    if (!(static_cast<double>(stages.size()) + steps < most_steps))
      throw std::invalid_argument("a programme of the stage with 1e8 steps or more");
    for (double n = 1; n < steps; ++n) stages.push_back(from + std::copysign(n * step, way));
    stages.push_back(turns[i]);
  }
  return stages;
}

}  // namespace flexslip
