#include "inference/constrained_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace flexslip {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ConstrainedFit::ConstrainedFit(const ForceModel& model, const FitPoint& centre)
    : ConstrainedFit(model, centre, Freedom(centre.layout)) {}

ConstrainedFit::ConstrainedFit(const ForceModel& model, const FitPoint& centre, const Freedom& freedom)
    : model_(model), centre_(centre), likelihood_(model, centre, centre.noise) {
  best_ = {centre_.p, likelihood_.deviance(centre_.p)};
  information_ = information(model, centre_);
  const MatrixXd T = freedom.directions(centre_.p);
  covariance_ = T * MatrixXd(T.transpose() * information_ * T).inverse() * T.transpose();
}

MatrixXd ConstrainedFit::covariance(const PolarParameters& polar) const {
  const MatrixXd inverse = polar.directions(centre_.layout, centre_.p).inverse();
  return inverse * covariance_ * inverse.transpose();
}

double ConstrainedFit::value(const ProfiledParameter& parameter) const {
  return parameter.polar.from_cartesian(centre_.layout, centre_.p)[parameter.index];
}

double ConstrainedFit::deviation(const ProfiledParameter& parameter) const {
  return std::sqrt(std::max(covariance(parameter.polar)(parameter.index, parameter.index), 0.0));
}

LikelihoodPoint ConstrainedFit::at(const ProfiledParameter& parameter, double value, const VectorXd& neighbour) const {
  const auto& [polar, index] = parameter;
  const auto& layout = centre_.layout;
  const MatrixXd errors = covariance(polar);
  const double variance = std::max(errors(index, index), 1e-300);
  VectorXd q = polar.from_cartesian(layout, neighbour);
  // Phases are known but for whole turns: the step to the value is the shortest.
  double step = value - q[index];
  if (layout.phase(index)) step = std::remainder(step, 2 * std::numbers::pi);
  q += step / variance * errors.col(index);
  q[index] = value;
  const VectorXd start = polar.to_cartesian(layout, q);
  if (!model_.permits(layout, start)) return {start, std::numeric_limits<double>::infinity()};

  const Descent descent(model_, layout, Freedom(layout, polar, {{index, value}}));
  constexpr int few = 6;         // evaluations: the start is near
  constexpr double cap = 4;      // standard deviations
  constexpr double worse = 0.5;  // than the ellipsoid says, in the deviance: a jump is in the way
  constexpr double hopeless = 400;
  auto step_to =
      descent.descend(descent.descend(start, centre_.noise, cap, few).p, centre_.noise, Descent::least_squares, few);
  LikelihoodPoint point{step_to.p, likelihood_.deviance(step_to.p)};
  double away = value - this->value(parameter);
  if (layout.phase(index)) away = std::remainder(away, 2 * std::numbers::pi);
  const double expected = best_.deviance + away * away / variance;
  if (point.deviance > expected + worse && point.deviance < expected + hopeless) {
    const MatrixXd T = Freedom(layout, polar, {{index, value}}).directions(point.p);
    constexpr std::array scales{1.5, 0.5};
    step_to = descent.searched(step_to, centre_.noise, MatrixXd(T.transpose() * information_ * T).inverse(), scales);
    step_to = descent.descend(step_to.p, centre_.noise, Descent::least_squares, few);
    const double deviance = likelihood_.deviance(step_to.p);
    if (deviance < point.deviance) point = {step_to.p, deviance};
  }
  return point;
}

const LikelihoodPoint* ConstrainedFit::likelier(const std::vector<LikelihoodPoint>& points) const {
  constexpr double worthwhile = 0.1;  // of twice the log likelihood: a third of a standard error
  constexpr double near = 20;  // likewise, by the ellipsoid: beyond it another explanation lies, not a better fit
  const LikelihoodPoint* best = nullptr;
  double least = best_.deviance - worthwhile;
  for (const auto& point : points) {
    const VectorXd away = point.p - centre_.p;
    if (!(point.deviance < least) || away.dot(information_ * away) > near) continue;
    best = &point;
    least = point.deviance;
  }
  return best;
}

}  // namespace flexslip
