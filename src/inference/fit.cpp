#include "inference/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>

#include <Eigen/Dense>

#include "inference/constant_fit.h"
#include "inference/force_model.h"
#include "inference/likelihood_region.h"
#include "inference/wave_search.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double pi = std::numbers::pi;

ParameterEstimate estimate(double value, double standard_error) {
  return {value, standard_error, value - 1.96 * standard_error, value + 1.96 * standard_error};
}

double rms_difference(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

ParameterRange shifted(const ParameterRange& range, double by) { return {range.low + by, range.high + by, range.open}; }

// The estimate and the interval of a polar parameter, in its place among those of the region.
ParameterEstimate estimate(double value, double variance, const ParameterRange& range) {
  return {value, std::sqrt(std::max(variance, 0.0)), range.low, range.high};
}

double wrapped(double angle) { return angle - 2 * pi * std::round(angle / (2 * pi)); }

// A phase within half a turn of 0, its interval on the same turn.
ParameterEstimate wrapped(const ParameterEstimate& phase) {
  const double turn = wrapped(phase.value) - phase.value;
  return {phase.value + turn, phase.standard_error, phase.low + turn, phase.high + turn};
}

// An interval holds no value that is not possible.
ParameterEstimate within(ParameterEstimate estimate, double least, double greatest) {
  estimate.low = std::max(estimate.low, least);
  estimate.high = std::min(estimate.high, greatest);
  return estimate;
}

double bic_of(const ForceModel& model, const FitPoint& point) {
  const auto parameters = static_cast<double>(point.layout.size() - 1);
  return parameters * std::log(static_cast<double>(model.measured_force().size())) - 2 * point.log_likelihood;
}

// The parameters p of a model, with what the likelihood says of them.
ModelFit describe(ProfileModel kind, const ForceModel& model, const FitPoint& fitted, const LikelihoodRegion& region,
                  const VectorXd& p, const FitProblem& problem) {
  const FitPoint& point = region.best;
  const ModelLayout& layout = point.layout;
  const PolarParameters origin{model.middle(), 0};
  const PolarParameters middle{model.middle(), model.middle()};
  const auto in = [&](const PolarParameters& polar, const std::vector<ParameterRange>& ranges) {
    const VectorXd likeliest = polar.from_cartesian(layout, point.p);
    const VectorXd q = polar.from_cartesian(layout, p);
    const MatrixXd inverse = polar.directions(layout, point.p).inverse();
    const VectorXd variances = (inverse * region.covariance * inverse.transpose()).diagonal();
    std::vector<ParameterEstimate> estimates;
    for (Index i = 0; i < layout.size(); ++i)
      estimates.push_back(
          estimate(q[i], variances[i], shifted(ranges[static_cast<std::size_t>(i)], q[i] - likeliest[i])));
    return estimates;
  };
  const auto parameters = in(origin, region.ranges);
  const auto at_middle = in(middle, region.at_middle);
  const auto parameter = [&](Index i) { return parameters[static_cast<std::size_t>(i)]; };

  ModelFit fit{};
  fit.model = kind;
  fit.status = point.converged ? FitStatus::ok : FitStatus::not_converged;
  fit.mu0 = within(parameter(0), 0, std::numeric_limits<double>::infinity());
  fit.drift = layout.drift ? parameter(1) : ParameterEstimate{};
  fit.bending_stiffness = parameter(layout.stiffness());
  for (double* value : {&fit.bending_stiffness.value, &fit.bending_stiffness.low, &fit.bending_stiffness.high})
    *value += 1;
  fit.friction = {.mu0 = fit.mu0.value, .drift = fit.drift.value, .terms = {}, .S_reference = model.middle()};
  for (Index i = 0; i < layout.waves; ++i) {
    const Index at = layout.wave(i);
    fit.waves.push_back({.amplitude = within(parameter(at), 0, 1),
                         .wavelength = parameter(at + 1),
                         .phase = wrapped(parameter(at + 2)),
                         .phase_at_middle = wrapped(at_middle[static_cast<std::size_t>(at + 2)])});
    const auto& wave = fit.waves.back();
    fit.friction.terms.push_back({wave.amplitude.value, wave.wavelength.value, wave.phase.value});
  }
  fit.force = model.force_at(layout, p, problem.record.stage);
  fit.residual_rms = rms_difference(fit.force, problem.record.force);
  const auto n = static_cast<double>(model.measured_force().size());
  const double rho = point.noise.correlation;
  fit.correlation = rho;
  fit.innovation = std::sqrt(point.noise.variance);
  fit.effective_points = n * (1 - rho) / (1 + rho);
  fit.parameters = static_cast<int>(layout.size()) - 1;
  fit.log_likelihood = fitted.log_likelihood;
  fit.aic = 2 * fit.parameters - 2 * fit.log_likelihood;
  fit.bic = bic_of(model, fitted);
  return fit;
}

// The model `constant` is judged by its likelihood as the others are, but estimated at the nominal bending stiffness.
ModelFit with_constant(ModelFit fit, const FitProblem& problem) {
  auto constant = fit_constant(problem);
  fit.mu0 = within(estimate(constant.mu0, constant.standard_error), 0, std::numeric_limits<double>::infinity());
  fit.bending_stiffness = estimate(1, problem.errors.bending_stiffness);
  fit.friction = {.mu0 = constant.mu0, .drift = 0, .terms = {}};
  fit.force = std::move(constant.force);
  fit.residual_rms = rms_difference(fit.force, problem.record.force);
  return fit;
}

ModelFit not_found(ProfileModel kind) {
  ModelFit missing{};
  missing.model = kind;
  missing.status = FitStatus::not_found;
  missing.bic = std::numeric_limits<double>::infinity();
  return missing;
}

// Two waves, or three if the third earns its place in BIC; without a second candidate none.
std::vector<FitPoint> fit_more_waves(const ForceModel& model, const FitPoint& one, const ScanOptions& scan,
                                     const HeldValues& held) {
  std::vector<FitPoint> many;
  FitPoint current = one;
  for (int waves = 2; waves <= 3; ++waves) {
    constexpr std::size_t most_candidates = 2;
    const auto candidates = scan_wavelengths(without_waves(model, current), scan);
    auto next = fit_next_wave(model, current, candidates, most_candidates, held);
    if (next.empty()) break;
    const double penalty = 3 * std::log(static_cast<double>(model.measured_force().size()));
    const bool better = 2 * (next.front().log_likelihood - current.log_likelihood) > penalty;
    current = next.front();
    if (many.empty() || better) many = std::move(next);
    if (!better) break;
  }
  return many;
}

// The other wavelengths at which the last wave fits well, and those that the interval cannot exclude.
void add_runners_up(ModelFit& fit, const ForceModel& model, const std::vector<FitPoint>& fits,
                    const LikelihoodRegion& region) {
  constexpr std::size_t most = 5;
  const PolarParameters origin{model.middle(), 0};
  for (std::size_t i = 1; i < fits.size() && i <= most; ++i) {
    const FitPoint& other = fits[i];
    const Index at = other.layout.stiffness() - 3;
    const VectorXd q = origin.from_cartesian(other.layout, other.p);
    const VectorXd residuals = model.measured_force() - model.force(other.layout, other.p);
    fit.runners_up.push_back(
        {.wavelength = q[at + 1],
         .amplitude = q[at],
         .phase = wrapped(q[at + 2]),
         .delta_log_likelihood = other.log_likelihood - fits.front().log_likelihood,
         .residual_rms = std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()))});
    constexpr double perhaps = 20;  // of the log likelihood: worth a closer look
    if (fit.runners_up.back().delta_log_likelihood < -perhaps) continue;
    if (const auto range = wavelength_range(model, other, region))
      fit.waves.back().other_wavelengths.push_back({range->low, range->high});
  }
}

}  // namespace

std::string_view name_of(ProfileModel model) {
  switch (model) {
    case ProfileModel::constant:
      return "constant";
    case ProfileModel::drift:
      return "drift";
    case ProfileModel::sinusoid:
      return "sinusoid";
    case ProfileModel::sinusoids:
      return "sinusoids";
  }
  return "";
}

FrictionFit fit_friction(const FitProblem& whole, const FitOptions& options) {
  const FitProblem usable = usable_part(whole);
  if (options.models.empty()) throw std::invalid_argument("no friction model to fit");
  const FitProblem problem = thinned(usable);
  const auto profile = measure_friction(problem.record, problem.rig, problem.errors, friction_shows_from);
  FrictionFit result{};
  constexpr std::size_t least_points = 20;
  if (profile.points.size() < least_points) {
    result.status = FrictionFitStatus::too_few_points;
    return result;
  }
  const ForceModel model(problem, profile);
  result.S_middle = model.middle();
  const auto asked = [&](ProfileModel kind) {
    return std::find(options.models.begin(), options.models.end(), kind) != options.models.end();
  };

  std::vector<FitPoint> one;
  std::vector<FitPoint> many;
  const FitPoint drifting = fit_mean(model, true, options.held);
  if (asked(ProfileModel::sinusoid) || asked(ProfileModel::sinusoids)) {
    const ScanOptions scan{.least_wavelength = model.least_wavelength(),
                           .stiffness_error = std::sqrt(model.prior_variance())};
    result.scan = scan_wavelengths(profile.points, scan);
    one = fit_next_wave(model, drifting, result.scan, result.scan.candidates.size(), options.held);
    if (!one.empty() && asked(ProfileModel::sinusoids)) many = fit_more_waves(model, one.front(), scan, options.held);
  }
  std::vector<std::vector<FitPoint>> fits;  // of each model, best first
  for (const auto kind : options.models) {
    if (kind == ProfileModel::constant) fits.push_back({fit_mean(model, false, options.held)});
    if (kind == ProfileModel::drift) fits.push_back({drifting});
    if (kind == ProfileModel::sinusoid) fits.push_back(one);
    if (kind == ProfileModel::sinusoids) fits.push_back(many);
  }
  const auto bic = [&](const std::vector<FitPoint>& fit) {
    return fit.empty() ? std::numeric_limits<double>::infinity() : bic_of(model, fit.front());
  };
  const auto best =
      std::min_element(fits.begin(), fits.end(), [&](const auto& a, const auto& b) { return bic(a) < bic(b); });
  result.chosen = static_cast<std::size_t>(best - fits.begin());

  const bool held = options.held.amplitude || options.held.wavelength;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const auto kind = options.models[i];
    if (fits[i].empty()) {
      result.models.push_back(not_found(kind));
      continue;
    }
    const FitPoint& fit = fits[i].front();
    // One wave is what the paper has, and is reported whichever model is chosen.
    const bool reported = i == result.chosen || kind == ProfileModel::sinusoid;
    const bool searched = reported && !held && kind != ProfileModel::constant;
    const auto region = searched ? likelihood_region(model, fit)
                                 : curvature_region(model, fit, freedom_within(model, fit.layout, options.held));
    // An amplitude is held relative to the mean, which levelling moves.
    const VectorXd p = options.held.amplitude ? region.best.p : levelled(model, region.best);
    ModelFit described = describe(kind, model, fit, region, p, usable);
    if (kind == ProfileModel::constant) described = with_constant(std::move(described), usable);
    if (searched && fit.layout.waves > 0) add_runners_up(described, model, fits[i], region);
    result.models.push_back(std::move(described));
  }
  return result;
}

}  // namespace flexslip
