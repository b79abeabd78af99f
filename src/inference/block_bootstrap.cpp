#include "inference/block_bootstrap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>

#include "inference/fitted_point.h"
#include "inference/polar_parameters.h"
#include "inference/wave_search.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Numbers that are the same with every standard library, which std's distributions are not.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : generator_(seed) {}
  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; }
  Index below(Index n) { return std::min(static_cast<Index>(uniform() * static_cast<double>(n)), n - 1); }
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937_64 generator_;
};

Index block_length(double correlation, Index n) {
  constexpr double forgotten = 0.01;
  const double steps = correlation > forgotten ? std::ceil(std::log(forgotten) / std::log(correlation)) : 1;
  return std::clamp(static_cast<Index>(std::min(steps, 1e6)), Index{1}, std::max(n / 4, Index{1}));
}

VectorXd in_blocks(const VectorXd& residuals, Index block, Draws& draws) {
  const Index n = residuals.size();
  VectorXd result(n);
  for (Index filled = 0; filled < n; filled += block) {
    const Index length = std::min(block, n - filled);
    result.segment(filled, length) = residuals.segment(draws.below(n - block + 1), length);
  }
  return result;
}

BootstrapEstimate spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / n;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto quantile = [&](double share) {
    const double place = std::clamp(share * (n + 1) - 1, 0.0, n - 1);
    const auto i = static_cast<std::size_t>(place);
    const std::size_t next = std::min(i + 1, values.size() - 1);
    return values[i] + (place - static_cast<double>(i)) * (values[next] - values[i]);
  };
  return {std::sqrt(squares / std::max(n - 1, 1.0)), quantile(0.025), quantile(0.975)};
}

// The best fit from a start. The residuals jump where a drop passes a point: a descent alone stays where it began, and the
// scatter would be a third too small.
Descent::Step fitted_from(const VectorXd& start, const Descent& descent, const CorrelatedNoise& noise,
                          const Eigen::MatrixXd& covariance) {
  constexpr std::array scales{2.0, 1.0, 0.5, 0.25};
  constexpr int most_rounds = 6;
  constexpr double worthwhile = 0.1;  // of twice the log likelihood: a third of a standard error
  auto best = descent.descend(start, noise, Descent::least_squares);
  for (int round = 0; round < most_rounds; ++round) {
    const double before = best.cost;
    best = descent.searched(best, noise, covariance, scales);
    const auto descended = descent.descend(best.p, noise, Descent::least_squares);
    if (descended.cost < best.cost) best = descended;
    if (!(before - best.cost > worthwhile)) break;
  }
  return best;
}

// The solution with the last wave of a runner-up.
std::optional<VectorXd> runner_up_of(const ForceModel& model, const FitPoint& point, const ModelFit& fit) {
  constexpr double likely = 10;  // of the log likelihood: beyond it noise does not make it the better one
  if (fit.runners_up.empty() || fit.runners_up.front().delta_log_likelihood < -likely) return std::nullopt;
  const auto& other = fit.runners_up.front();
  const PolarParameters origin{model.middle(), 0};
  VectorXd q = origin.from_cartesian(point.layout, point.p);
  q.segment(point.layout.stiffness() - 3, 3) << other.amplitude, other.wavelength, other.phase;
  return origin.to_cartesian(point.layout, q);
}

}  // namespace

Bootstrap block_bootstrap(const FitProblem& problem, const ModelFit& fit, const BootstrapOptions& options,
                          const HeldValues& held) {
  if (fit.status == FitStatus::not_found || fit.model == ProfileModel::constant)
    throw std::invalid_argument("no bootstrap of a model that is not fitted to the curve");
  Bootstrap result{options.count, 0, options.seed, {}, {}, {}, {}};
  if (options.count == 0) return result;
  const ForceModel model = model_of(problem);
  const FitPoint point = fitted_point(model, fit);
  const auto& layout = point.layout;
  const auto runner_up = runner_up_of(model, point, fit);
  const VectorXd curve = model.force(layout, point.p);
  VectorXd residuals = model.measured_force() - curve;
  residuals.array() -= residuals.mean();
  // Residuals are smaller than the noise by the freedom that the parameters took.
  const auto n = static_cast<double>(residuals.size());
  residuals *= std::sqrt(n / (n - static_cast<double>(layout.size())));
  const Index block = block_length(point.noise.correlation, residuals.size());
  result.block = static_cast<std::size_t>(block);

  const Freedom freedom = freedom_within(model, layout, held);
  const Eigen::MatrixXd covariance = Descent(model, layout, freedom).covariance(point);

  Draws draws(options.seed);
  std::vector<std::vector<double>> estimates(static_cast<std::size_t>(layout.size()));
  const PolarParameters origin{model.middle(), 0};
  const VectorXd centre = origin.from_cartesian(layout, point.p);
  const double eta = point.p[layout.stiffness()];
  for (std::size_t k = 0; k < options.count; ++k) {
    const VectorXd force = curve + in_blocks(residuals, block, draws);
    const double prior = eta + std::sqrt(model.prior_variance()) * draws.normal();
    const ForceModel again = model.with(force, prior);
    const Descent descent(again, layout, freedom);
    auto best = fitted_from(point.p, descent, point.noise, covariance);
    if (runner_up) {
      const auto other = fitted_from(*runner_up, descent, point.noise, covariance);
      if (other.cost < best.cost) best = other;
    }
    // As the fit itself is: an amplitude is held relative to the mean, which levelling moves.
    if (!held.amplitude) best.p = levelled(again, {layout, best.p, point.noise, 0, true});
    const VectorXd q = origin.from_cartesian(layout, best.p);
    for (Index i = 0; i < layout.size(); ++i) {
      double value = q[i];
      if (layout.phase(i)) {
        // On the turn on which the wavelength leaves it.
        const double turned = std::numbers::pi * model.middle();
        const double away = (centre[i] + turned / centre[i - 1]) - (q[i] + turned / q[i - 1]);
        value += 2 * std::numbers::pi * std::round(away / (2 * std::numbers::pi));
        value += fit.waves[static_cast<std::size_t>((i - layout.wave(0)) / 3)].phase.value - centre[i];
      }
      estimates[static_cast<std::size_t>(i)].push_back(value);
    }
  }

  const auto spread = [&](Index i) { return spread_of(estimates[static_cast<std::size_t>(i)]); };
  result.mu0 = spread(0);
  if (layout.drift) result.drift = spread(1);
  for (Index i = 0; i < layout.waves; ++i)
    result.waves.push_back({spread(layout.wave(i)), spread(layout.wave(i) + 1), spread(layout.wave(i) + 2)});
  result.bending_stiffness = spread(layout.stiffness());
  result.bending_stiffness.low += 1;
  result.bending_stiffness.high += 1;
  return result;
}

}  // namespace flexslip
