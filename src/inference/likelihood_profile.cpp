#include "inference/likelihood_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "inference/constrained_fit.h"
#include "inference/fitted_point.h"
#include "inference/wave_search.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

ProfiledParameter profiled(FitParameter parameter, const ForceModel& model, const ModelLayout& layout) {
  const PolarParameters origin{model.middle(), 0};
  const PolarParameters middle{model.middle(), model.middle()};
  switch (parameter) {
    case FitParameter::mu0:
      return {middle, 0};
    case FitParameter::amplitude:
      return {middle, layout.wave(0)};
    case FitParameter::wavelength:
      return {middle, layout.wave(0) + 1};
    case FitParameter::phase:
      return {origin, layout.wave(0) + 2};
    case FitParameter::bending_stiffness:
      return {middle, layout.stiffness()};
  }
  throw std::invalid_argument("no such parameter");
}

}  // namespace

std::vector<double> likelihood_along(const FitProblem& problem, const ModelFit& fit, FitParameter parameter,
                                     std::span<const double> values) {
  if (fit.status == FitStatus::not_found) throw std::invalid_argument("no likelihood of a model that was not found");
  const bool of_wave =
      parameter == FitParameter::amplitude || parameter == FitParameter::wavelength || parameter == FitParameter::phase;
  if (of_wave && fit.waves.empty()) throw std::invalid_argument("the model has no wave");
  const ForceModel model = model_of(problem);
  const FitPoint point = fitted_point(model, fit);
  const ConstrainedFit constrained(model, point);
  const auto along = profiled(parameter, model, point.layout);
  const double offset = parameter == FitParameter::bending_stiffness ? -1 : 0;
  // Phases as the fit states them, not on the turn on which they are calculated.
  const double start = parameter == FitParameter::phase ? fit.waves.front().phase.value : constrained.value(along);
  const double deviation = std::max(constrained.deviation(along), 1e-9);

  std::vector<double> result(values.size(), -std::numeric_limits<double>::infinity());
  for (const double direction : {-1.0, 1.0}) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < values.size(); ++i)
      if ((values[i] + offset >= start) == (direction > 0)) order.push_back(i);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return direction * values[a] < direction * values[b]; });
    double at = start;
    VectorXd p = point.p;
    for (const auto i : order) {
      const double value = values[i] + offset;
      constexpr double most_strides = 20;
      const double strides = std::clamp(std::ceil(std::abs(value - at) / deviation), 1.0, most_strides);
      const double from = at;
      LikelihoodPoint best{p, std::numeric_limits<double>::infinity()};
      for (int k = 1; k <= static_cast<int>(strides); ++k) {
        const auto next = constrained.at(along, from + (value - from) * k / strides, p);
        if (!std::isfinite(next.deviance)) break;
        at = from + (value - from) * k / strides;
        p = next.p;
        if (k == static_cast<int>(strides)) best = next;
      }
      if (parameter == FitParameter::wavelength && point.layout.waves == 1) {
        const auto fresh = constrained.at(along, value, wave_of_profile(model, point, value));
        if (fresh.deviance < best.deviance) best = fresh;
      }
      if (std::isfinite(best.deviance)) result[i] = -0.5 * best.deviance;
    }
  }
  return result;
}

}  // namespace flexslip
