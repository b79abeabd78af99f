// A sweep whose rows take no time, for the tests of what is done with them.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "design/sweep_plan.h"
#include "design/sweep_run.h"

namespace flexslip {

inline SweepPlan some_sweep(std::uint64_t samples, std::uint64_t seed = 1) {
  return read_sweep(
      "reduced = true\n[rig]\nstiffness = 50\n[friction]\nmodel = \"constant\"\nmu0 = 0.4\n[stage]\nprogram = [0, "
      "0.3]\n"
      "[sweep]\nmethod = \"latin hypercube\"\nsamples = " +
          std::to_string(samples) + "\nseed = " + std::to_string(seed) +
          "\n[sweep.axes]\nmu0 = { from = 0.1, to = 1 }\nstiffness = { from = 1, to = 100, spacing = \"log\" }\n",
      "some.toml");
}

// Outcomes without mechanics, in the number that there are.
inline std::vector<double> some_outcomes(std::span<const double> inputs) {
  std::vector<double> outcomes(14, inputs[0] * inputs[1]);
  outcomes[0] = inputs[0] < 0.5 ? 0 : 2;     // status
  outcomes[2] = std::floor(10 * inputs[0]);  // snaps
  outcomes[7] = std::floor(inputs[1]);       // drops
  return outcomes;
}

}  // namespace flexslip
