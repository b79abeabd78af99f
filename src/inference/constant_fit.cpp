#include "inference/constant_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

#include "bending_test/sliding_ladder.h"
#include "fibre/elementary.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double greatest_friction = 3;

struct ConstantFriction {
  double mu;
  double from_residuals;  // standard error
};

ConstantFriction estimate_at(const ReducedRecord& record, double stiffening, const SlidingLadder& ladder) {
  std::vector<std::size_t> order(record.deflection.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return record.deflection[a] < record.deflection[b]; });
  std::vector<double> w;
  w.reserve(order.size());
  for (const auto i : order) w.push_back(record.deflection[i]);
  const auto n = static_cast<Index>(w.size());
  const auto force_at = [&](double mu) {
    const auto curve = ladder.curve(std::vector<double>(ladder.lengths().size(), mu));
    const auto at_deflection = measured_curve(curve.w, curve.F, 0, w);
    VectorXd force(n);
    for (std::size_t i = 0; i < w.size(); ++i) force[static_cast<Index>(order[i])] = stiffening * at_deflection[i];
    return force;
  };
  const VectorXd data = Eigen::Map<const VectorXd>(record.force.data(), n);
  double mu = 0.5;
  VectorXd slope;
  VectorXd residuals;
  for (int iteration = 0; iteration < 20; ++iteration) {
    constexpr double h = 1e-4;  // F is smooth in μ on a scale of 1
    const VectorXd force = force_at(mu);
    slope = (force_at(mu + h) - force) / h;
    residuals = data - force;
    if (!(slope.squaredNorm() > 0)) break;  // at the greatest friction: no curve of sliding is as high
    const double next = std::clamp(mu + slope.dot(residuals) / slope.squaredNorm(), 0.0, greatest_friction);
    const bool done = std::abs(next - mu) < 1e-8;
    mu = next;
    if (done) break;
  }
  // Sandwich with the autocovariance of the scores, tapered (Newey & West) over a tenth of the record.
  const VectorXd scores = slope.cwiseProduct(residuals);
  const Index reach = std::max<Index>(n / 10, 1);
  double variance = scores.squaredNorm();
  for (Index lag = 1; lag < std::min(reach, n); ++lag) {
    const double taper = 1 - static_cast<double>(lag) / static_cast<double>(reach);
    variance += 2 * taper * scores.head(n - lag).dot(scores.tail(n - lag));
  }
  return {mu, std::sqrt(std::max(variance, 0.0)) / slope.squaredNorm()};
}

}  // namespace

ConstantFit fit_constant(const FitProblem& problem) {
  const auto& record = problem.record;
  const double w_max = *std::max_element(record.deflection.begin(), record.deflection.end());
  const SlidingLadder ladder(std::min(1 + 2.5 * w_max * w_max, longest_ladder), 0.002, problem.rig.fibre);
  const auto nominal = estimate_at(record, 1, ladder);
  const double deviation = problem.errors.bending_stiffness;
  const double shift =
      0.5 * (estimate_at(record, 1 + deviation, ladder).mu - estimate_at(record, 1 - deviation, ladder).mu);
  return {.mu0 = nominal.mu, .standard_error = elementary::length(nominal.from_residuals, shift)};
}

}  // namespace flexslip
