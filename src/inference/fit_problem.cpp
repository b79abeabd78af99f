#include "inference/fit_problem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace flexslip {
namespace {

void require_faultless(const FitProblem& problem) {
  if (!(problem.rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(problem.rig.stiffness));
  const auto& [stage, deflection, force] = problem.record;
  if (stage.size() != force.size() || deflection.size() != force.size())
    throw std::invalid_argument("the columns of the record are not of one length: " + std::to_string(stage.size()) +
                                ", " + std::to_string(deflection.size()) + ", " + std::to_string(force.size()));
  for (std::size_t i = 0; i < force.size(); ++i)
    if (!std::isfinite(stage[i] + deflection[i] + force[i]) || (i > 0 && stage[i] < stage[i - 1]))
      throw std::invalid_argument("point " + std::to_string(i) + " of the record is not finite or runs back");
  const auto& errors = problem.errors;
  if (!(errors.force >= 0 && errors.bending_stiffness >= 0 && errors.contact >= 0))
    throw std::invalid_argument("measurement errors must not be negative");
  constexpr double most_error = 0.3;  // of EI: beyond it the fit would be that of another specimen
  if (errors.bending_stiffness > most_error)
    throw std::invalid_argument("the bending stiffness must be known to 30 %, not " +
                                std::to_string(errors.bending_stiffness));
}

ReducedRecord every(std::size_t step, std::size_t size, const ReducedRecord& record) {
  ReducedRecord part;
  for (std::size_t i = 0; i < size; i += step) {
    part.stage.push_back(record.stage[i]);
    part.deflection.push_back(record.deflection[i]);
    part.force.push_back(record.force[i]);
  }
  return part;
}

}  // namespace

FitProblem usable_part(const FitProblem& whole) {
  require_faultless(whole);
  constexpr double most_deflection = 0.8;  // [L]
  std::size_t size = 0;
  while (size < whole.record.stage.size() && whole.record.deflection[size] <= most_deflection) ++size;
  return {every(1, size, whole.record), whole.rig, whole.errors};
}

std::size_t thinning_of(std::size_t points) {
  constexpr std::size_t most_points = 1200;
  return std::max<std::size_t>((points + most_points - 1) / most_points, 1);
}

FitProblem thinned(const FitProblem& problem) {
  const std::size_t size = problem.record.stage.size();
  return {every(thinning_of(size), size, problem.record), problem.rig, problem.errors};
}

}  // namespace flexslip
