#include "inference/fit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>

#include <Eigen/Core>

#include "bending_test/history.h"
#include "bending_test/sliding_table.h"
#include "data/names.h"
#include "inference/process_forward.h"
#include "inference/process_posterior.h"
#include "inference/process_search.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/progress.h"

namespace flexslip {
namespace {

void require_faultless(const FitProblem& problem) {
  if (!(problem.rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(problem.rig.stiffness));
  require_readings(problem.record);
  const auto& stage = problem.record.stage;
  for (std::size_t i = 1; i < stage.size(); ++i)
    if (stage[i] < stage[i - 1]) throw std::invalid_argument("point " + std::to_string(i) + " of the record runs back");
  const auto& errors = problem.errors;
  if (!(errors.force >= 0 && errors.bending_stiffness >= 0 && errors.contact >= 0))
    throw std::invalid_argument("measurement errors must not be negative");
  if (errors.bending_stiffness > max_stiffness_error)
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
  constexpr double max_deflection = 0.8;  // [L]
  std::size_t size = 0;
  while (size < whole.record.stage.size() && whole.record.deflection[size] <= max_deflection) ++size;
  return whole.with(every(1, size, whole.record));
}

std::size_t thinning_of(std::size_t points) {
  constexpr std::size_t max_points = 1200;
  return std::max<std::size_t>((points + max_points - 1) / max_points, 1);
}

FitProblem thinned(const FitProblem& problem) {
  const std::size_t size = problem.record.stage.size();
  return problem.with(every(thinning_of(size), size, problem.record));
}

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double max_friction = 3;

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
    constexpr double h = 1e-4;  // F varies with μ on a scale of 1
    const VectorXd force = force_at(mu);
    slope = (force_at(mu + h) - force) / h;
    residuals = data - force;
    if (!(slope.squaredNorm() > 0)) break;  // the maximum friction: no sliding curve is as high
    const double next = std::clamp(mu + slope.dot(residuals) / slope.squaredNorm(), 0.0, max_friction);
    const bool done = std::abs(next - mu) < 1e-8;
    mu = next;
    if (done) break;
  }
  // Sandwich with the autocovariance of the scores, tapered (Newey & West) over a tenth of the
  // record.
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

namespace {

constexpr double pi = std::numbers::pi;

Estimate estimate_of(const NormalMixture& mixture) {
  return {quantile_of(mixture, 0.5), deviation_of(mixture), quantile_of(mixture, 0.025), quantile_of(mixture, 0.975)};
}

// The estimate of a number from its logarithm.
Estimate estimate_of_exponential(const NormalMixture& mixture) { return exponential(estimate_of(mixture)); }

Estimate none() { return {0, 0, 0, 0}; }

// The estimate from weighted samples.
Estimate estimate_of(std::vector<WeightedDraw> draws) {
  std::stable_sort(draws.begin(), draws.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  double total = 0, sum = 0, squares = 0;
  for (const auto& draw : draws) {
    total += draw.weight;
    sum += draw.weight * draw.value;
  }
  const double mean = sum / total;
  for (const auto& draw : draws) squares += draw.weight * (draw.value - mean) * (draw.value - mean);
  const auto quantile = [&](double probability) {
    double below = 0;
    for (const auto& draw : draws) {
      below += draw.weight;
      if (below >= probability * total) return draw.value;
    }
    return draws.back().value;
  };
  return {quantile(0.5), std::sqrt(squares / total), quantile(0.025), quantile(0.975)};
}

// The part of the mean hidden by a soft rig is an additional error.
std::vector<JointPart> as_estimated(std::vector<JointPart> parts, double hidden_by_rig, bool rolls_back) {
  for (JointPart& part : parts) {
    part.covariance[JointPart::mu0][JointPart::mu0] += hidden_by_rig * hidden_by_rig;
    if (!rolls_back) continue;
    part.value[JointPart::drift] *= -1;
    for (const auto other : {JointPart::mu0, JointPart::bending_stiffness})
      part.covariance[JointPart::drift][other] = part.covariance[other][JointPart::drift] *= -1;
  }
  return parts;
}

// place: [L] the middle of the observed length, from midspan of the straight specimen.
WaveEstimate wave_of(const std::vector<WaveDraw>& draws, double place, double log_wavelength, double hidden_by_rig,
                     bool rolls_back) {
  std::vector<WeightedDraw> amplitude, wavelength, phase, at_middle;
  std::vector<JointPart> joint;
  double cosine = 0, sine = 0;
  for (const auto& draw : draws) {
    cosine += draw.weight * draw.cosine;
    sine += draw.weight * draw.sine;
  }
  const double about = -elementary::angle(sine, cosine);  // a cos + b sin = A cos(2πx/λ + about)
  const double usual = elementary::wrapped_angle(about - 2 * pi * place * elementary::exp(-log_wavelength));
  for (const auto& draw : draws) {
    const double lambda = elementary::exp(draw.log_wavelength);
    const double angle = about + elementary::wrapped_angle(-elementary::angle(draw.sine, draw.cosine) - about);
    amplitude.push_back({elementary::length(draw.cosine, draw.sine) / std::max(draw.mean, 0.02), draw.weight});
    wavelength.push_back({lambda, draw.weight});
    at_middle.push_back({angle, draw.weight});
    phase.push_back(
        {usual + (angle - about) - 2 * pi * place * (1 / lambda - elementary::exp(-log_wavelength)), draw.weight});
    JointPart part = draw.beside;
    part.value[JointPart::amplitude] = amplitude.back().value;
    part.value[JointPart::wavelength] = lambda;
    part.value[JointPart::phase] = phase.back().value;
    joint.push_back(part);
  }
  return {estimate_of(std::move(amplitude)), estimate_of(std::move(wavelength)), estimate_of(std::move(phase)),
          estimate_of(std::move(at_middle)),
          correlations_of(as_estimated(std::move(joint), hidden_by_rig, rolls_back))};
}

Hypotheses asked_by(ProfileModel model) {
  Hypotheses asked;
  if (model == ProfileModel::roughness) return asked;
  asked.kernels = {Kernel::none};
  asked.waves = model == ProfileModel::sinusoid ? 1 : model == ProfileModel::sinusoids ? 2 : 0;
  return asked;
}

// The force at increasing stage positions with overshooting snaps; NaN after the specimen slips
// through.
std::vector<double> forces_overshooting(const FrictionTable& friction, const Rig& rig, std::span<const double> stages) {
  std::vector<double> rising;
  for (const double stage : stages) rising.push_back(std::max(stage, rising.empty() ? 0 : rising.back()));
  const History run = follow_in_steps({Friction::as_met(friction), rig, SnapRest::overshoot}, rising);
  std::vector<double> forces(stages.size(), not_a_number);
  for (std::size_t i = 0; i < std::min(run.path.size(), forces.size()); ++i) forces[i] = run.path[i].F;
  return forces;
}

// The force at stage positions, simulated with the mean profile on this rig.
std::vector<double> run_forward(const FrictionFit& fit, const Rig& rig, std::span<const double> stages) {
  const double stiffening = fit.bending_stiffness.value;
  std::vector<double> corrected;
  for (const double stage : stages) corrected.push_back(fit.correction.corrected_stage(stage));
  auto forces = (fit.overshoots ? forces_overshooting : forces_of)(fit.mean, rig.in_units_of(stiffening), corrected);
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = stiffening * forces[i] - fit.correction.at(stages[i]).force;
  return forces;
}

double residual_rms(std::span<const double> force, const Passages& passages) {
  double sum = 0;
  for (std::size_t k = 0; k < force.size(); ++k) sum += (force[k] - passages.force[k]) * (force[k] - passages.force[k]);
  return std::sqrt(sum / static_cast<double>(force.size()));
}

RigCorrection correction_of(const std::vector<double>& rig, const Passages& passages) {
  std::vector<Shift> shift(passages.size(), Shift{0, 0});
  for (std::size_t r = 0; r < rig.size(); ++r)
    for (std::size_t i = 0; i < shift.size(); ++i) {
      shift[i].deflection += rig[r] * passages.rig_errors[r].shift[i].deflection;
      shift[i].force += rig[r] * passages.rig_errors[r].shift[i].force;
    }
  return {passages.stage, std::move(shift), passages.compliance};
}

// One friction for the whole specimen, by least squares in the force.
FrictionFit constant_fit_of(const FitProblem& whole, const FitProblem& problem, const Passages& passages) {
  const ConstantFit constant = fit_constant(problem);
  FrictionFit fit{};
  fit.status = FrictionFitStatus::ok;
  fit.model = ProfileModel::constant;
  fit.readings = passages.size();
  const auto [least, greatest] = std::minmax_element(passages.S.begin(), passages.S.end());
  fit.S_begin = *least;
  fit.S_end = *greatest;
  fit.along = passages.along;
  fit.share = passages.share;
  fit.overshoots = passages.overshoots;
  fit.S_middle = fit.along.length_at(passages.S_middle);
  const auto mean = mean_friction({{1, constant.mu0, constant.standard_error}});
  fit.mu0 = mean.estimate;
  fit.mu0.value = constant.mu0;
  fit.mu0_is_bound = mean.is_bound;
  const double s = problem.errors.bending_stiffness;
  fit.bending_stiffness = normal_estimate(1, s);
  fit.log_evidence_of_wave = not_a_number;
  fit.band = {
      {fit.S_begin, fit.S_end}, {constant.mu0, constant.mu0}, {constant.standard_error, constant.standard_error}};
  fit.mean = {fit.band.S, fit.band.mean};
  fit.force = run_forward(fit, whole.rig, whole.record.stage);
  fit.residual_rms = residual_rms(run_forward(fit, whole.rig, passages.stage), passages);
  fit.of_mu0 = {{{1, constant.mu0, constant.standard_error}}, 0, infinity};  // least squares, without a prior
  return fit;
}

}  // namespace

MeanFriction mean_friction(const NormalMixture& mixture) {
  const double negative = probability_below(mixture, 0);
  if (negative < 0.025) return {estimate_of(mixture), false};
  // For a non-negative mean: the median, the deviation about it, and the one-sided 95 % limit.
  const auto quantile = [&](double probability) {
    return std::max(quantile_of(mixture, negative + probability * (1 - negative)), 0.0);
  };
  const double median = quantile(0.5);
  return {{median, 0.5 * (quantile(0.84) - quantile(0.16)), 0, quantile(0.95)}, true};
}

double hidden_by_soft_rig(double stiffness) {
  constexpr double most = 0.13, hides_all = 10, hides_none = 20;
  return most * std::clamp((hides_none - stiffness) / (hides_none - hides_all), 0.0, 1.0);
}

std::string_view name_of(ProfileModel model) {
  return name_in_order<ProfileModel::sinusoids>(model, {"roughness", "constant", "drift", "sinusoid", "sinusoids"});
}

double weight_without_roughness(const FrictionFit& fit) {
  double weight = 0;
  for (const auto& each : fit.explanations)
    if (each.kernel == Kernel::none) weight += each.weight;
  return fit.model == ProfileModel::roughness ? weight : 0;
}

bool determines_lengths(const FrictionFit& fit) {
  return (fit.wave_claimed && !fit.waves.empty()) ||
         (fit.model == ProfileModel::roughness && !(weight_without_roughness(fit) > 0.5));
}

namespace {

// The explanation of the readings of a record, if there is one.
struct Explained {
  std::shared_ptr<const FrictionProcess> process;
  ProcessSearch found;
  double log_evidence = -infinity;  // of all measured forces, while sliding and sticking
};

Explained explained_by(const Passages& passages, const Hypotheses& asked) {
  if (passages.size() < min_readings) return {};
  Explained explained{std::make_shared<const FrictionProcess>(passages), {}};
  explained.found = search(*explained.process, asked);
  if (explained.found.components.empty()) return {};
  const Component& best = explained.found.components.front();
  const Hyperparameters at = hyperparameters_of(best.mode.theta);
  explained.log_evidence = best.log_evidence + log_density_of_rests(passages, at.noise, at.correlation);
  return explained;
}

}  // namespace

FrictionFit fit_friction(const FitProblem& whole, const FitOptions& options) {
  const FitProblem usable = usable_part(whole);
  const FitProblem problem = thinned(usable);
  FrictionFit fit{};
  fit.model = options.model;
  const Passages read = problem.record.force.size() < 3 ? Passages{} : passages_of(problem, options.search);
  fit.readings = read.size();
  if (read.judged < min_readings) {
    fit.status = FrictionFitStatus::too_few_points;
    return fit;
  }
  // Friction explains every reading of the authors' tests and of cracked ones, and three in five of
  // pure noise.
  const bool mostly_given = 3 * read.size() >= 2 * read.judged;
  // On a very soft rig the specimen does not bend enough to be simulated.
  constexpr double min_bending = 1e-5;  // [L]
  const bool bends = beam_deflection(problem.record.stage.back(), problem.rig.stiffness) > min_bending;
  if (read.size() < min_readings || !mostly_given || !bends) {
    fit.status = FrictionFitStatus::not_explained;
    return fit;
  }
  if (options.model == ProfileModel::constant) return constant_fit_of(whole, problem, read);
  Stages stages;
  stages.enter("", 0.79);
  const Hypotheses asked = asked_by(options.model);
  Explained explained = explained_by(read, asked);
  if (read.may_overshoot) {
    FitProblem overshooting = problem;
    overshooting.snaps = SnapRest::overshoot;
    Explained other = explained_by(passages_of(overshooting, options.search), asked);
    if (other.log_evidence > explained.log_evidence + claiming_gain) explained = std::move(other);
  }
  if (!explained.process || !has_slid(explained.found.components.front().mode.at)) {  // no sliding
    fit.status = FrictionFitStatus::not_explained;
    return fit;
  }
  const FrictionProcess& process = *explained.process;
  const ProcessSearch& found = explained.found;
  const Passages& passages = process.passages();
  fit.readings = passages.size();
  stages.enter("how certain friction is", 0.21);
  const ProcessPosterior posterior = posterior_of(process, found.components);

  fit.status = FrictionFitStatus::ok;
  fit.S_begin = posterior.S_begin;
  fit.S_end = posterior.S_end;
  fit.along = passages.along;
  fit.share = passages.share;
  fit.overshoots = passages.overshoots;
  fit.S_middle = fit.along.length_at(passages.S_middle);
  if (options.search.parts.hidden_by_rig) fit.hidden_by_rig = hidden_by_soft_rig(problem.rig.stiffness);
  const NormalMixture of_mean = widened(posterior.mean, fit.hidden_by_rig);
  const auto mean = mean_friction(of_mean);
  fit.mu0 = mean.estimate;
  fit.mu0_is_bound = mean.is_bound;
  const bool rolls_back = fit.along.contact_moves_outward_at(passages.S_middle);  // the contacts move outwards
  fit.drift = estimate_of(posterior.drift);
  if (rolls_back) fit.drift = {-fit.drift.value, fit.drift.standard_error, -fit.drift.high, -fit.drift.low};
  const bool rough = options.model == ProfileModel::roughness;
  fit.roughness = rough ? estimate_of_exponential(posterior.log_roughness) : none();
  fit.length = rough ? estimate_of_exponential(posterior.log_length) : none();
  fit.bending_stiffness = estimate_of_exponential(posterior.log_stiffness);
  fit.friction_by = posterior.friction_by;
  fit.log_stiffness_by = posterior.log_stiffness_by;
  fit.noise = estimate_of_exponential(posterior.log_noise);
  const auto rows = static_cast<double>(thinning_of(usable.record.force.size()));  // between fitted rows
  fit.noise_correlation = elementary::exp(elementary::log(posterior.noise_correlation) / rows);
  for (auto wave : posterior.waves) {
    if (rolls_back)
      for (auto& draw : wave.draws) draw.sine = -draw.sine;
    fit.waves.push_back(
        wave_of(wave.draws, passages.share * fit.S_middle, wave.log_wavelength, fit.hidden_by_rig, rolls_back));
  }
  // A longer wave may be a trend.
  const auto repeats = [&](const WaveEstimate& wave) { return wave.wavelength.value < passages.range / 4; };
  std::stable_sort(fit.waves.begin(), fit.waves.end(), [&](const WaveEstimate& a, const WaveEstimate& b) {
    return repeats(a) == repeats(b) ? a.amplitude.value > b.amplitude.value : repeats(a);
  });
  const bool either = !asked.waves;
  fit.log_evidence_of_wave = either && !fit.waves.empty() ? posterior.log_evidence_of_wave : not_a_number;
  fit.wave_claimed = !fit.waves.empty() && (!either || (fit.log_evidence_of_wave > claiming_gain &&
                                                        fit.log_evidence_of_wave < posterior.carried_by_readings &&
                                                        repeats(fit.waves.front())));
  fit.correlations = fit.wave_claimed ? fit.waves.front().correlations
                                      : correlations_of(as_estimated(posterior.joint, fit.hidden_by_rig, rolls_back));
  fit.shortest_wave = process.min_wavelength();
  fit.explanations = posterior.explanations;
  fit.innovations = posterior.innovations;
  for (const auto& at : found.scan) fit.scan.push_back({at.wavelength, at.gain});
  fit.band = posterior.band;
  fit.mean = posterior.profile;
  fit.correction = correction_of(posterior.rig, passages);
  fit.draws = posterior.draws;
  fit.draw_stiffness = posterior.draw_stiffness;
  fit.force = run_forward(fit, whole.rig, whole.record.stage);
  fit.residual_rms = residual_rms(run_forward(fit, whole.rig, passages.stage), passages);
  fit.of_mu0 = {of_mean, FrictionProcess::mean_friction, 0.5};
  const ThetaPrior& prior = process.prior_of_theta();
  fit.of_log_roughness = {posterior.log_roughness, prior.mean[Theta::log_roughness],
                          prior.deviation[Theta::log_roughness]};
  fit.of_log_length = {posterior.log_length, prior.mean[Theta::log_length], prior.deviation[Theta::log_length]};
  return fit;
}

}  // namespace flexslip
