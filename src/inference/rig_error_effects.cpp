#include "inference/rig_error_effects.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Core>

#include "fibre/supported_state.h"
#include "numerics/beam.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t places = 8;        // nodes of a slow deviation
constexpr std::size_t deflections = 16;  // at which effects of the supports are tabulated
constexpr double length_of_slow = 0.5;   // [maximum deflection]

double matern_5_2(double distance) {
  const double r = std::sqrt(5.0) * std::abs(distance) / length_of_slow;
  return (1 + r + r * r / 3) * elementary::exp(-r);
}

using SlowMatrix = Eigen::Matrix<double, places, places>;

double place_of(std::size_t j) { return static_cast<double>(j) / (places - 1); }

// The values at the nodes are L z, with z independent and of variance 1.
SlowMatrix whitening_of_slow() {
  SlowMatrix K;
  for (std::size_t i = 0; i < places; ++i)
    for (std::size_t j = 0; j < places; ++j)
      K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matern_5_2(place_of(i) - place_of(j));
  const Eigen::MatrixXd L = cholesky_root(K);
  SlowMatrix inverse = SlowMatrix::Identity();
  for (Eigen::Index i = 0; i < L.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) inverse.row(i) -= L(i, j) * inverse.row(j);
    inverse.row(i) /= L(i, i);
  }
  return inverse;
}

double at_part(const std::vector<double>& values, double part) {
  const double where = std::clamp(part, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(where), values.size() - 2);
  return values[i] + (where - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

}  // namespace

RigErrorEffects::RigErrorEffects(const FitProblem& problem, double friction)
    : compliance_(1 / problem.rig.stiffness),
      deepest_(*std::max_element(problem.record.deflection.begin(), problem.record.deflection.end())),
      greatest_force_(*std::max_element(problem.record.force.begin(), problem.record.force.end())),
      slow_force_(problem.rig_errors.slow_force * greatest_force_),
      supports_(problem.rig.fibre.supports()),
      deviations_(prior_deviations(problem.errors, problem.rig_errors, supports_)) {
  thicker_ = of_supports({.radius = 0, .half_depth = 0.5}, friction);
  rounder_ = of_supports({.radius = 1, .half_depth = 0}, friction);
}

RigErrorEffects::OfSupports RigErrorEffects::of_supports(const Supports& by, double friction) const {
  constexpr double step = 0.002;  // [L] forces are nearly linear in both
  OfSupports change{{0}, {0}};
  for (std::size_t i = 1; i < deflections; ++i) {
    const double w = deepest_ * static_cast<double>(i) / (deflections - 1);
    const Supports more{supports_.radius + step * by.radius, supports_.half_depth + step * by.half_depth};
    const auto stated = state_on_supports(w, friction, supports_), changed = state_on_supports(w, friction, more);
    const double rolled = more.radius * changed.theta0 - supports_.radius * stated.theta0;  // at each support
    const bool there = stated.status == FibreStatus::ok && changed.status == FibreStatus::ok;
    change.force.push_back(there ? (changed.F - stated.F) / step : change.force.back());
    change.length.push_back(there ? (changed.slid - stated.slid - 2 * rolled) / step : change.length.back());
  }
  return change;
}

Shift RigErrorEffects::by(const OfSupports& supports, double w) const {
  return {0, -at_part(supports.force, w / deepest_), at_part(supports.length, w / deepest_)};
}

Shift RigErrorEffects::by(StatedQuantity quantity, double w, double F) const {
  switch (quantity) {
    case StatedQuantity::bending_stiffness:
      return {0, -F};
    case StatedQuantity::contact:
      return {-1, 0};
    case StatedQuantity::preload:
      return {1, beam_stiffness};
    case StatedQuantity::load_train:
      return {F * compliance_, 0};
    case StatedQuantity::span:
      return {-w, 2 * F};
    case StatedQuantity::force_gain:
      return {-F * compliance_, F};
    case StatedQuantity::thickness:
      return by(thicker_, w);
    case StatedQuantity::support_radius:
      return by(rounder_, w);
  }
  return {0, 0};
}

std::vector<Shift> RigErrorEffects::deviations(double w, double F) const {
  static const SlowMatrix whitening = whitening_of_slow();
  std::vector<Shift> shifts;
  for (const StatedQuantity quantity : stated_quantities) {
    if (quantity == StatedQuantity::bending_stiffness) continue;  // fitted separately
    const Shift one = by(quantity, w, F);
    const double by = deviations_[quantity];
    shifts.push_back({by * one.deflection, by * one.force, by * one.length});
  }
  Eigen::Matrix<double, places, 1> from_places;
  for (std::size_t j = 0; j < places; ++j)
    from_places[static_cast<Eigen::Index>(j)] = matern_5_2(w / deepest_ - place_of(j));
  const Eigen::Matrix<double, places, 1> slow = whitening * from_places;
  for (const double part : slow) {
    const double force = slow_force_ * part;
    shifts.push_back({0, force});  // mainly a deviation of the specimen, so the load train is unaffected
  }
  return shifts;
}

PerQuantity<double> prior_deviations(const MeasurementErrors& errors, const RigErrors& rig_errors,
                                     const Supports& supports) {
  PerQuantity<double> deviations;
  deviations[StatedQuantity::bending_stiffness] = errors.bending_stiffness;
  deviations[StatedQuantity::contact] = errors.contact;
  deviations[StatedQuantity::preload] = rig_errors.preload;
  deviations[StatedQuantity::load_train] = rig_errors.load_train;
  deviations[StatedQuantity::span] = rig_errors.span;
  deviations[StatedQuantity::force_gain] = rig_errors.force_gain;
  deviations[StatedQuantity::thickness] = rig_errors.thickness * 2 * supports.half_depth;
  deviations[StatedQuantity::support_radius] = rig_errors.support_radius * supports.radius;
  return deviations;
}

FitProblem restated(FitProblem problem, StatedQuantity quantity, double more) {
  const double times = 1 + more;
  if (!(times > 0)) throw std::invalid_argument("what is stated, " + std::to_string(times) + " times as large");
  auto& [stage, deflection, force] = problem.record;
  Rig& rig = problem.rig;
  const auto scale = [](std::vector<double>& column, double by) {
    for (double& each : column) each *= by;
  };
  const auto supports_with = [&](double radius, double half_depth) {
    const Supports& stated = rig.fibre.supports();
    rig.fibre = Fibre({.radius = stated.radius + radius, .half_depth = stated.half_depth + half_depth});
  };
  switch (quantity) {
    case StatedQuantity::bending_stiffness:
      scale(force, 1 / times);
      rig.stiffness /= times;
      break;
    case StatedQuantity::load_train:
      rig.stiffness *= times;
      break;
    case StatedQuantity::span:
      scale(stage, 1 / times);
      scale(force, times * times);
      rig.stiffness *= times * times * times;
      break;
    case StatedQuantity::force_gain:
      scale(force, times);
      break;
    case StatedQuantity::contact:
      for (double& each : stage) each -= more;
      break;
    case StatedQuantity::preload:
      for (double& each : force) each += beam_stiffness * more;
      for (double& each : stage) each += more * (1 + beam_stiffness / rig.stiffness);
      break;
    case StatedQuantity::thickness:
      supports_with(0, 0.5 * more);
      break;
    case StatedQuantity::support_radius:
      supports_with(more, 0);
      break;
  }
  // The stage was measured: the deflection is the stage minus the compression of the load train.
  for (std::size_t i = 0; i < stage.size(); ++i) deflection[i] = stage[i] - force[i] / rig.stiffness;
  return problem;
}

}  // namespace flexslip
