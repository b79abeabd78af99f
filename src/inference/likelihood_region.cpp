#include "inference/likelihood_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Searches along the profiles of parameters, and all that they meet.
class Walker {
 public:
  // The walks end where the deviance exceeds `limit`.
  Walker(const ConstrainedFit& fit, double limit) : fit_(fit), limit_(limit), met_{fit.best()} {}

  ParameterRange range(const ProfiledParameter& parameter) {
    const End low = end(parameter, -1);
    const End high = end(parameter, 1);
    return {low.value, high.value, low.open || high.open};
  }

  const std::vector<LikelihoodPoint>& met() const { return met_; }

 private:
  struct End {
    double value;
    bool open;
  };

  // Where the deviance has risen by rise95, between the last two steps by its root, which is straight for an ellipsoid.
  End end(const ProfiledParameter& parameter, double direction) {
    constexpr double stride = 1;      // standard errors
    constexpr int most_strides = 10;  // ten standard errors
    const double step = direction * stride * fit_.deviation(parameter);
    const double enough = std::sqrt(limit_ - fit_.best().deviance);
    double value = fit_.value(parameter);
    double before = 0;
    VectorXd p = fit_.centre().p;
    for (int i = 0; i < most_strides; ++i) {
      const auto next = fit_.at(parameter, value + step, p);
      if (next.deviance == std::numeric_limits<double>::infinity()) return {value, true};
      met_.push_back(next);
      const double rise = std::sqrt(std::max(next.deviance - fit_.best().deviance, 0.0));
      if (rise >= enough) return {value + step * std::clamp((enough - before) / (rise - before), 0.0, 1.0), false};
      value += step;
      before = rise;
      p = next.p;
    }
    return {value, true};
  }

  const ConstrainedFit& fit_;
  double limit_;
  std::vector<LikelihoodPoint> met_;
};

// The value of a polar parameter at a point; phases on the turn on which the centre has them.
double near_centre(const ConstrainedFit& fit, const ProfiledParameter& parameter, const VectorXd& p) {
  const auto& layout = fit.centre().layout;
  const auto& polar = parameter.polar;
  const VectorXd q = polar.from_cartesian(layout, p);
  const Index i = parameter.index;
  if (!layout.phase(i)) return q[i];
  const VectorXd q0 = polar.from_cartesian(layout, fit.centre().p);
  // The phase in the middle is known to less than a turn, and the wavelength carries it to where it is meant.
  const double turned = std::numbers::pi * (polar.S_middle - polar.S_phase);
  const double away = (q0[i] + turned / q0[i - 1]) - (q[i] + turned / q[i - 1]);
  return q[i] + 2 * std::numbers::pi * std::round(away / (2 * std::numbers::pi));
}

ParameterRange hull(const ParameterRange& range, double value) {
  return {std::min(range.low, value), std::max(range.high, value), range.open};
}

// All parameters with phases meant at the length 0, then the phases in the middle of the data.
std::vector<ProfiledParameter> profiled_parameters(const ForceModel& model, const ModelLayout& layout) {
  std::vector<ProfiledParameter> parameters;
  for (Index i = 0; i < layout.size(); ++i) parameters.push_back({{model.middle(), 0}, i});
  for (Index i = 0; i < layout.size(); ++i)
    if (layout.phase(i)) parameters.push_back({{model.middle(), model.middle()}, i});
  return parameters;
}

ParameterRange range_at(const ConstrainedFit& fit, const ProfiledParameter& parameter) {
  const double value = fit.value(parameter);
  return {value, value, false};
}

// The slope of the mean and the phases in the middle are met on the way of the others.
bool worth_a_walk(const ModelLayout& layout, const ProfiledParameter& parameter) {
  return !(layout.drift && parameter.index == 1) && !(layout.phase(parameter.index) && parameter.polar.S_phase != 0);
}

// The region of given ranges, none taken shorter than the Gauss-Newton interval.
LikelihoodRegion region_of(const ConstrainedFit& fit, const std::vector<ProfiledParameter>& parameters,
                           const std::vector<ParameterRange>& ranges) {
  const auto size = static_cast<std::size_t>(fit.centre().layout.size());
  LikelihoodRegion region{fit.centre(), fit.best().deviance, fit.rise95(), fit.covariance(), {}, {}};
  region.at_middle.resize(size);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const double value = fit.value(parameters[k]);
    const double reach = std::sqrt(fit.rise95()) * fit.deviation(parameters[k]);
    const auto range = hull(hull(ranges[k], value - reach), value + reach);
    if (k < size)
      region.ranges.push_back(range);
    else
      region.at_middle[static_cast<std::size_t>(parameters[k].index)] = range;
  }
  return region;
}

}  // namespace

LikelihoodRegion likelihood_region(const ForceModel& model, const FitPoint& fit) {
  const auto& layout = fit.layout;
  const Descent descent(model, layout, Freedom(layout));
  const auto parameters = profiled_parameters(model, layout);
  FitPoint centre = fit;
  centre.noise = restricted_noise(model, centre);
  constexpr int most_moves = 1;
  for (int move = 0;; ++move) {
    const auto step = descent.descend(centre.p, centre.noise, Descent::least_squares);
    centre.p = step.p;
    centre.converged = centre.converged || step.converged;
    const ConstrainedFit constrained(model, centre);
    const double limit = constrained.best().deviance + constrained.rise95();
    Walker walker(constrained, limit);
    std::vector<ParameterRange> ranges;
    const LikelihoodPoint* likelier = nullptr;
    for (const auto& parameter : parameters) {
      ranges.push_back(worth_a_walk(layout, parameter) ? walker.range(parameter) : range_at(constrained, parameter));
      likelier = constrained.likelier(walker.met());
      if (likelier && move < most_moves) break;
    }
    if (likelier && move < most_moves) {
      centre.p = likelier->p;
      continue;
    }
    for (std::size_t k = 0; k < parameters.size(); ++k)
      for (const auto& met : walker.met())
        if (met.deviance <= limit) ranges[k] = hull(ranges[k], near_centre(constrained, parameters[k], met.p));
    return region_of(constrained, parameters, ranges);
  }
}

LikelihoodRegion curvature_region(const ForceModel& model, const FitPoint& fit, const Freedom& freedom) {
  FitPoint centre = fit;
  centre.noise = restricted_noise(model, centre);
  const ConstrainedFit constrained(model, centre, freedom);
  const auto parameters = profiled_parameters(model, fit.layout);
  std::vector<ParameterRange> ranges;
  ranges.reserve(parameters.size());
  for (const auto& parameter : parameters) ranges.push_back(range_at(constrained, parameter));
  return region_of(constrained, parameters, ranges);
}

std::optional<ParameterRange> wavelength_range(const ForceModel& model, const FitPoint& other,
                                               const LikelihoodRegion& region) {
  FitPoint centre = other;
  centre.noise = region.best.noise;
  centre.p =
      Descent(model, other.layout, Freedom(other.layout)).descend(centre.p, centre.noise, Descent::least_squares).p;
  const ConstrainedFit constrained(model, centre);
  const double limit = region.deviance + region.rise95;
  if (constrained.best().deviance > limit) return std::nullopt;
  const ProfiledParameter wavelength{{model.middle(), model.middle()}, other.layout.stiffness() - 2};
  return Walker(constrained, limit).range(wavelength);
}

}  // namespace flexslip
