#include "inference/rig_shifts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "fibre/supported_state.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t places = 8;        // at which a slow deviation is known
constexpr std::size_t deflections = 16;  // of a force that the supports change
constexpr double force_of_a_beam = 48;   // [EI/L^3] over a small deflection
constexpr double length_of_slow = 0.5;   // of the greatest deflection

double matern_5_2(double distance) {
  const double r = std::sqrt(5.0) * std::abs(distance) / length_of_slow;
  return (1 + r + r * r / 3) * elementary::exp(-r);
}

using SlowMatrix = Eigen::Matrix<double, places, places>;

double place_of(std::size_t j) { return static_cast<double>(j) / (places - 1); }

// Values at the places are L z, z independent with variance 1.
SlowMatrix whitening_of_slow() {
  SlowMatrix K;
  for (std::size_t i = 0; i < places; ++i)
    for (std::size_t j = 0; j < places; ++j)
      K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matern_5_2(place_of(i) - place_of(j));
  return Eigen::LLT<SlowMatrix>(K).matrixL().solve(SlowMatrix::Identity());
}

double at_part(const std::vector<double>& values, double part) {
  const double where = std::clamp(part, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(where), values.size() - 2);
  return values[i] + (where - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

}  // namespace

RigShifts::RigShifts(const FitProblem& problem, double friction)
    : compliance_(1 / problem.rig.stiffness),
      deepest_(*std::max_element(problem.record.deflection.begin(), problem.record.deflection.end())),
      greatest_force_(*std::max_element(problem.record.force.begin(), problem.record.force.end())),
      contact_error_(problem.errors.contact),
      errors_(problem.rig_errors),
      supports_(problem.rig.fibre.supports()) {
  thicker_ = of_supports({.radius = 0, .half_depth = 0.5}, friction);
  rounder_ = of_supports({.radius = 1, .half_depth = 0}, friction);
}

std::vector<double> RigShifts::of_supports(const Supports& by, double friction) const {
  constexpr double step = 0.002;  // [L] forces are nearly linear in either
  std::vector<double> change{0};
  for (std::size_t i = 1; i < deflections; ++i) {
    const double w = deepest_ * static_cast<double>(i) / (deflections - 1);
    const Supports more{supports_.radius + step * by.radius, supports_.half_depth + step * by.half_depth};
    const auto stated = state_on_supports(w, friction, supports_), changed = state_on_supports(w, friction, more);
    const bool there = stated.status == FibreStatus::ok && changed.status == FibreStatus::ok;
    change.push_back(there ? (changed.F - stated.F) / step : change.back());
  }
  return change;
}

Shift RigShifts::by(RigQuantity quantity, double w, double F) const {
  switch (quantity) {
    case RigQuantity::contact:
      return {-1, 0};
    case RigQuantity::preload:
      return {1, force_of_a_beam};
    case RigQuantity::load_train:
      return {F * compliance_, 0};
    case RigQuantity::span:
      return {-w, 2 * F};
    case RigQuantity::force_gain:
      return {-F * compliance_, F};
    case RigQuantity::thickness:
      return {0, -at_part(thicker_, w / deepest_)};
    case RigQuantity::support_radius:
      return {0, -at_part(rounder_, w / deepest_)};
  }
  return {0, 0};
}

std::vector<Shift> RigShifts::deviations(double w, double F) const {
  static const SlowMatrix whitening = whitening_of_slow();
  const std::array deviation{std::pair{RigQuantity::contact, contact_error_},
                             std::pair{RigQuantity::preload, errors_.preload},
                             std::pair{RigQuantity::load_train, errors_.load_train},
                             std::pair{RigQuantity::span, errors_.span},
                             std::pair{RigQuantity::force_gain, errors_.force_gain},
                             std::pair{RigQuantity::thickness, errors_.thickness * 2 * supports_.half_depth},
                             std::pair{RigQuantity::support_radius, errors_.support_radius * supports_.radius}};
  std::vector<Shift> shifts;
  for (const auto& [quantity, size] : deviation) {
    const Shift one = by(quantity, w, F);
    shifts.push_back({size * one.deflection, size * one.force});
  }
  Eigen::Matrix<double, places, 1> from_places;
  for (std::size_t j = 0; j < places; ++j)
    from_places[static_cast<Eigen::Index>(j)] = matern_5_2(w / deepest_ - place_of(j));
  const Eigen::Matrix<double, places, 1> slow = whitening * from_places;
  for (const double part : slow) {
    const double force = errors_.slow_force * greatest_force_ * part;
    shifts.push_back({0, force});  // of the specimen more than of the cell: the load train knows the true force
  }
  return shifts;
}

}  // namespace flexslip
