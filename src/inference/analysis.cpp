#include "inference/analysis.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bending_test/equilibrium.h"
#include "data/contact.h"
#include "fibre/elastica.h"
#include "inference/beginning.h"
#include "inference/profile.h"
#include "inference/rig_error_effects.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/progress.h"
#include "numerics/statistics.h"

namespace flexslip {

bool is_consistent_with_sliding(const Record& record, const Scales& scales, const Rig& rig,
                                double bending_stiffness_error) {
  const auto slides = [&](double stiffening) {
    const ReducedRecord reduced = to_reduced(record, {scales.span(), stiffening * scales.bending_stiffness()});
    const Fibre& fibre = rig.fibre;
    const ReadStates read = read_states(reduced, fibre, min_informative_deflection(fibre, min_judged_deflection));
    const auto negative = static_cast<std::size_t>(
        std::count_if(read.q.begin(), read.q.end(), [](double mu) { return mu < min_friction; }));
    const std::size_t impossible = negative + read.unexplained.size();
    return 5 * impossible <= read.q.size() + read.unexplained.size();
  };
  const double within = elementary::exp(2 * bending_stiffness_error);
  return slides(1) || slides(within) || slides(1 / within);
}

FrictionlessForceRatio frictionless_force_ratio(const ReducedRecord& record, const Fibre& fibre) {
  const double deepest = *std::max_element(record.deflection.begin(), record.deflection.end());
  if (!(deepest > min_judged_deflection)) return {};
  constexpr int enough = 200;  // for the ratio to 1e-4
  const auto frictionless = sliding_up_to(deepest, 0, enough, fibre);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    if (!(record.deflection[i] > min_judged_deflection)) continue;
    const double ratio = record.force[i] / force_at(frictionless, record.deflection[i]);
    if (std::isfinite(ratio)) ratios.push_back(ratio);
  }
  if (ratios.empty()) return {};
  return {.median = median_of(ratios), .least = *std::min_element(ratios.begin(), ratios.end())};
}

StiffnessFromSlope stiffness_from_slope(const Record& record, double span) {
  const InitialLine contact = initial_line(record);
  if (contact.status != ContactStatus::found || !(contact.slope.value > 0)) return {};
  double work = 0;
  double square = 0, sum = 0;
  for (std::size_t i = contact.first; i < contact.last; ++i) {
    sum += record.deflection[i];
    work += record.force[i] * record.deflection[i];
    square += record.deflection[i] * record.deflection[i];
  }
  constexpr double bend = 0.03;  // of the slope, by friction and large deflection: the order of 2.4 q w at w = 0.03
  const double error = elementary::length(
      elementary::length(default_stiffness_error, contact.slope.standard_error / contact.slope.value), bend);
  return {.found = work > 0 && error <= max_stiffness_error,
          .value = beam_bending_stiffness(work / square, span),
          .relative_error = error,
          .deflection = square / sum};
}

namespace {

Replay replay_of(const TestAnalysis& analysis) {
  constexpr double from = min_friction_deflection;
  Replay replay{.force = std::vector<double>(analysis.reduced.force.size(), not_a_number)};
  const FrictionTable table = replay_table(analysis.reduced, analysis.rig, analysis.profile, analysis.drops.drops);
  if (table.S.size() < 2) return replay;
  std::vector<std::size_t> rows;
  std::vector<double> stages;
  double last = 0;
  constexpr double deepest_replayed = 1;  // [L] beyond, an existing state may not be found (supported_state.h)
  const double deepest = analysis.rig.fibre.on_edges() ? infinity : deepest_replayed;
  for (std::size_t i = 0; i < analysis.reduced.stage.size(); ++i)
    if (analysis.reduced.deflection[i] > from && analysis.reduced.deflection[i] <= deepest &&
        analysis.reduced.stage[i] >= last) {
      rows.push_back(i);
      last = analysis.reduced.stage[i];
      stages.push_back(last);
    }
  if (!(last > 0)) return replay;  // every row is deeper
  const TestPath replayed = path_in_steps({Friction::as_met(table), analysis.rig}, stages);
  for (std::size_t k = 0; k < replayed.path.size(); ++k) replay.force[rows[k]] = replayed.path[k].F;
  return replay;
}

// A record in units of the fitted bending stiffness.
struct AtFit {
  double stiffening;  // [1] fitted / nominal bending stiffness
  ReducedRecord record;
  Rig rig;
  MeasurementErrors errors;
};

AtFit in_units_of_fit(ReducedRecord record, const TestAnalysis& analysis) {
  const auto& stiffness = analysis.fit.bending_stiffness;
  for (double& force : record.force) force /= stiffness.value;
  return {.stiffening = stiffness.value,
          .record = std::move(record),
          .rig = analysis.rig.in_units_of(stiffness.value),
          .errors = {.force = analysis.errors.force / stiffness.value,
                     .bending_stiffness = stiffness.standard_error / stiffness.value,
                     .contact = analysis.errors.contact}};
}

// The record corrected for the estimated errors of the rig.
AtFit at_fit(const TestAnalysis& analysis) {
  return in_units_of_fit(analysis.fit.correction.corrected(analysis.reduced), analysis);
}

double stiffening_of(const TestAnalysis& analysis) {
  return analysis.status == AnalysisStatus::ok ? analysis.fit.bending_stiffness.value : 1;
}

// [L] Twice the measured stage position, the limit of a correction.
double farthest_run(const TestAnalysis& analysis) {
  return 2 * *std::max_element(analysis.reduced.stage.begin(), analysis.reduced.stage.end());
}

// A point of a simulation of the fit as this rig would measure it, in units of the nominal bending
// stiffness.
void read_by_rig(PathPoint& point, const TestAnalysis& analysis) {
  point.F *= stiffening_of(analysis);
  const Shift shift = analysis.fit.correction.at(point.stage);  // the correction changes slowly with the stage
  point.w -= shift.deflection;
  point.F -= shift.force;
  point.stage -= shift.deflection + shift.force / analysis.rig.stiffness;
}

// The friction share refers to the specimen without losses, which lower friction and work alike.
void share_as_unharmed(MeasuredEnergy& energy, const MeasuredEnergy& unharmed) {
  const double less = energy.work_of_fracture / unharmed.work_of_fracture;
  energy.friction_share = unharmed.friction_share;
  energy.account.friction = less * unharmed.account.friction;
  energy.account.snaps = less * unharmed.account.snaps;
}

// In units of the nominal bending stiffness.
MeasuredEnergy measured_energy(const AtFit& at, const std::vector<Drop>& drops) {
  MeasuredEnergy energy{};
  const auto& [stiffening, record, rig, errors] = at;
  const ReadStates read = read_states(record, rig.fibre, min_informative_deflection(rig.fibre, min_profile_deflection));
  for (std::size_t i = 1; i < record.force.size(); ++i) {
    const double mean_force = 0.5 * (record.force[i] + record.force[i - 1]);
    energy.account.stage_work += mean_force * (record.stage[i] - record.stage[i - 1]);
    energy.work_of_fracture += mean_force * (record.deflection[i] - record.deflection[i - 1]);
  }
  const double last_force = record.force.empty() ? 0 : record.force.back();
  energy.account.load_train = 0.5 * last_force * last_force / rig.stiffness;
  const auto drop_ends_at = [&](std::size_t before, std::size_t after) {
    return std::any_of(drops.begin(), drops.end(), [&](const Drop& drop) {
      return drop.before < after && drop.after >= after && drop.before <= before;
    });
  };
  FibreState previous{};
  for (std::size_t k = 0; k < read.rows.size(); ++k) {
    const FibreState state = rig.fibre.state(read.S[k], read.q[k]);
    if (state.status != FibreStatus::ok) continue;
    if (k == 0) {
      // Before the first point μ cannot be measured; its first value serves there.
      energy.account.friction += read.q[0] * state.Pn * 0.5 * (state.S - 1);
    } else {
      const auto i = read.rows[k - 1];
      const auto j = read.rows[k];
      if (drop_ends_at(i, j)) {
        double work = 0;
        for (std::size_t row = i + 1; row <= j; ++row)
          work += 0.5 * (record.force[row] + record.force[row - 1]) * (record.stage[row] - record.stage[row - 1]);
        const double train = (state.F * state.F - previous.F * previous.F) / (2 * rig.stiffness);
        energy.account.snaps += work - (state.U - previous.U) - train;
      } else {
        energy.account.friction += 0.5 * (read.q[k] * state.Pn + read.q[k - 1] * previous.Pn) * (state.S - previous.S);
      }
    }
    energy.account.bending = state.U;
    previous = state;
  }
  auto& account = energy.account;
  energy.friction_share = (account.friction + account.snaps) / energy.work_of_fracture;
  for (double* part : {&account.stage_work, &account.bending, &account.load_train, &account.friction, &account.snaps,
                       &energy.work_of_fracture})
    *part *= stiffening;
  return energy;
}

// The errors of the quantities are independent.
double error_of_share(const TestAnalysis& analysis) {
  if (!analysis.work_share_sensitivities) return not_a_number;
  const PerQuantity<double> deviations =
      prior_deviations(analysis.errors, analysis.rig_errors, analysis.rig.fibre.supports());
  double error = 0;
  for (const StatedQuantity quantity : stated_quantities)
    error = elementary::length(error, (*analysis.work_share_sensitivities)[quantity] * deviations[quantity]);
  return error;
}

// The derivative of the friction share, from readings restated with another value at the bending
// stiffness of its fit.
Sensitivities work_sensitivities(const TestAnalysis& analysis) {
  const AtFit found = in_units_of_fit(analysis.reduced, analysis);
  const auto share_of = [&](const FitProblem& problem) {
    return measured_energy({.stiffening = 1, .record = problem.record, .rig = problem.rig, .errors = problem.errors},
                           analysis.drops.drops)
        .friction_share;
  };
  const FitProblem stated{found.record, found.rig, found.errors};
  Sensitivities by;
  for (const StatedQuantity quantity : stated_quantities) {
    // The share is nearly linear in each quantity; over this step, single readings that enter or
    // leave matter little.
    constexpr double way = 0.004;
    const auto share_with = [&](double more) {
      const double stiffer = elementary::exp(more * (*analysis.fit.log_stiffness_by)[quantity]) - 1;
      return share_of(restated(restated(stated, quantity, more), StatedQuantity::bending_stiffness, stiffer));
    };
    const bool may_be_none = quantity == StatedQuantity::thickness || quantity == StatedQuantity::support_radius;
    const double least = may_be_none ? 0 : -way;
    by[quantity] = (share_with(way) - share_with(least)) / (way - least);
  }
  return by;
}

// The sum of the drops and their mean, as fractions of the maximum force. The empirical limits
// agree with the authors on 24 of their 26 published tests.
SawtoothCategory category_of(const TestAnalysis& analysis) {
  const double greatest = *std::max_element(analysis.record.force.begin(), analysis.record.force.end());
  double total = 0;
  for (const auto& drop : analysis.drops.drops) total += drop.force_fall;
  const auto drops = static_cast<double>(analysis.drops.drops.size());
  if (drops < 3 || total < 0.03 * greatest) return SawtoothCategory::none;
  return total >= 0.15 * greatest || total >= 0.015 * drops * greatest ? SawtoothCategory::clear
                                                                       : SawtoothCategory::nominal;
}

FrictionProfile profile_at_fit(const TestAnalysis& analysis) {
  const AtFit at = at_fit(analysis);
  return measure_friction(at.record, at.rig, at.errors, min_friction_deflection);
}

PointwiseFriction friction_read_of(const FrictionProfile& profile) {
  std::vector<double> mu;
  for (const auto& point : profile.points) mu.push_back(point.mu);
  std::sort(mu.begin(), mu.end());
  return {
      .median = quantile_in_order(mu, 0.5), .low80 = quantile_in_order(mu, 0.1), .high80 = quantile_in_order(mu, 0.9)};
}

std::vector<Check> checks_of(const FitProblem& problem, const FrictionFit& fit, const AnalysisOptions& options) {
  std::vector<Check> checks{check_residuals(problem, fit), check_drops(problem, fit, options.drops),
                            check_whiteness(fit), check_friction(fit),
                            check_bending_stiffness(fit, problem.errors.bending_stiffness)};
  return checks;
}

}  // namespace

Estimate MeasuredEnergy::share() const {
  Estimate share = normal_estimate(friction_share, friction_share_error);
  share.low = std::max(share.low, 0.0);
  share.high = std::min(share.high, 1.0);
  return share;
}

double MeasuredEnergy::least_share() const {
  constexpr double one_sided = 1.645;  // the 95 % quantile of a normal deviate
  return std::max(friction_share - one_sided * friction_share_error, 0.0);
}

TestAnalysis analyse_drops(const Record& record, const TestDescription& description, const AnalysisOptions& options) {
  if (const auto check = check_record(record);
      check.fault == RecordFault::lengths_differ || check.fault == RecordFault::not_finite)
    throw std::invalid_argument("the record has a fault at point " + std::to_string(check.index));
  if (record.force.size() < min_fitted_points)
    throw std::invalid_argument("a record of " + std::to_string(record.force.size()) + " points tells no drops");
  const InitialLine contact = initial_line(record);
  const double L = description.span, EI = description.bending_stiffness;
  const auto slope = stiffness_from_slope(record, L);
  // A settling contact lowers the slope through the contact and raises the slope of a free line;
  // use the closer of the two.
  const double through_contact = EI / slope.value;
  const double beside = EI / beam_bending_stiffness(contact.slope.value, L);
  const bool contact_is_nearer = std::abs(elementary::log(through_contact)) < std::abs(elementary::log(beside));
  const double ratio = !slope.found ? not_a_number : contact_is_nearer ? through_contact : beside;
  constexpr double max_ratio =
      1.4;  // contact, friction and large deflection change the slopes of sound tests by up to 25 %
  const double EI_error = description.bending_stiffness_error;
  const double farthest_ratio = std::max(max_ratio, elementary::exp(2 * EI_error));
  const Scales scales(L, EI);
  const Rig stated_rig{scales.reduced_stiffness(description.load_train_stiffness), description.fibre};
  TestAnalysis analysis{.status = AnalysisStatus::ok,
                        .scales = scales,
                        .rig = stated_rig,
                        .bending_stiffness_error = EI_error,
                        .stiffness_to_slope_ratio = ratio,
                        .stiffness_implausible = ratio > farthest_ratio || ratio < 1 / farthest_ratio,
                        .record = record,
                        .reduced = to_reduced(record, scales)};
  analysis.force_noise = scales.reduced_force(force_noise(record));
  analysis.drops = find_drops(record, options.drops);
  analysis.statistics = statistics_of(record, analysis.drops.drops, description.load_train_stiffness);
  const MeasurementErrors errors{
      .force = analysis.force_noise,
      .bending_stiffness = analysis.bending_stiffness_error,
      .contact = description.contact_error ? scales.reduced_length(*description.contact_error) : default_contact_error};
  analysis.errors = errors;
  analysis.rig_errors = description.rig_errors;
  analysis.profile = measure_friction(analysis.reduced, analysis.rig, errors);
  analysis.slips = slips_of(analysis.profile, analysis.drops.drops, errors, options.suspect_limit);
  analysis.slip_summary = summarise(analysis.slips, description.nose);
  analysis.drop_features = drop_features(analysis.reduced, analysis.rig,
                                         {analysis.force_noise, EI_error, options.drops.halts}, analysis.drops.drops);
  analysis.passes = description.passes;
  return analysis;
}

TestAnalysis analyse(const Record& record, const TestDescription& description, const AnalysisOptions& options) {
  Stages stages;
  stages.enter("contact and drops", 0.07);
  TestAnalysis analysis = analyse_drops(record, description, options);
  const MeasurementErrors& errors = analysis.errors;
  const Scales& scales = analysis.scales;
  analysis.suspects = find_suspects(analysis.reduced, analysis.profile, options.suspect_limit);
  analysis.frictionless_force_ratio = frictionless_force_ratio(analysis.reduced, analysis.rig.fibre);
  analysis.category = category_of(analysis);
  analysis.max_friction = options.max_friction;
  const FitProblem problem{analysis.reduced,       analysis.rig,     errors,
                           description.rig_errors, description.nose, description.snaps};
  stages.enter("friction", 0.8);
  const auto are_fitted = [&] { return analysis.passes && analysis.passes->status == PassesStatus::ok; };
  if (are_fitted()) analysis.fit = fit_evaluated(problem, *analysis.passes, options.fit);
  if (are_fitted() && analysis.fit.status != FrictionFitStatus::ok)
    analysis.passes->status = PassesStatus::not_explained;
  if (!are_fitted()) analysis.fit = fit_friction(problem, options.fit);
  if (analysis.fit.status != FrictionFitStatus::ok) {
    const bool is_bent = analysis.fit.status != FrictionFitStatus::too_few_points;
    analysis.status = is_bent ? AnalysisStatus::not_explained : AnalysisStatus::deflection_too_small;
    return analysis;
  }
  stages.enter("the fit run forward", 0.04);
  analysis.profile_at_fit = profile_at_fit(analysis);
  analysis.pointwise_friction = friction_read_of(analysis.profile_at_fit);
  const AtFit fitted = at_fit(analysis);
  analysis.suspects.suspect &= find_suspects(fitted.record, analysis.profile_at_fit, options.suspect_limit).suspect;
  analysis.slips = with_friction_from(analysis.profile_at_fit, analysis.slips, fitted.errors);
  analysis.slip_summary = summarise(analysis.slips, description.nose);
  // After a loss of stiffness the force may be below the frictionless force; the passes account for
  // it.
  const auto slides = [&] {
    return is_consistent_with_sliding(analysis.record, scales, analysis.rig, analysis.bending_stiffness_error);
  };
  analysis.model_implausible = misses_force(analysis.fit, analysis.reduced) || (!are_fitted() && !slides());
  analysis.replay = replay_of(analysis);
  // The measured work follows from the uncorrected readings.
  analysis.energy = measured_energy(in_units_of_fit(analysis.reduced, analysis), analysis.drops.drops);
  if (are_fitted()) share_as_unharmed(analysis.energy, measured_energy(fitted, analysis.drops.drops));
  const bool tells_work = !analysis.fit.mu0_is_bound && !is_friction_implausible(analysis) &&
                          analysis.energy.friction_share > 0;  // heat is not negative
  if (!tells_work) analysis.energy.friction_share = not_a_number;
  if (tells_work && analysis.fit.friction_by) analysis.work_share_sensitivities = work_sensitivities(analysis);
  analysis.energy.friction_share_error = error_of_share(analysis);
  stages.enter("checks", 0.09);
  analysis.checks = checks_of(problem, analysis.fit, options);

  // The mean in units of the estimated bending stiffness.
  const double stiffening = analysis.fit.bending_stiffness.value;
  const Rig rig = analysis.rig.in_units_of(stiffening);
  const Friction friction = Friction::as_met(analysis.fit.mean);
  // On a load train that takes the whole stage travel, an error of the force may leave no
  // deflection, or an unbounded one.
  const std::vector<double> positions = advancing(fitted.record.stage);
  if (positions.back() > 0 && positions.back() < farthest_run(analysis))
    analysis.model = path_in_steps({friction, rig}, positions);
  for (PathPoint& point : analysis.model.path) read_by_rig(point, analysis);
  for (Snap& snap : analysis.model.snaps) {
    read_by_rig(snap.before, analysis);
    read_by_rig(snap.after, analysis);
    snap.stage = snap.before.stage;
  }
  return analysis;
}

bool is_friction_implausible(const TestAnalysis& analysis) {
  return analysis.suspects.suspect || analysis.fit.mu0.low > std::min(analysis.suspects.limit, analysis.max_friction);
}

double friction_underestimate(const TestAnalysis& analysis, double loss) {
  if (!(loss >= 0 && loss < 1)) throw std::invalid_argument("loss of " + std::to_string(loss) + " is not in [0, 1)");
  AtFit whole = at_fit(analysis);
  const double deepest = *std::max_element(whole.record.deflection.begin(), whole.record.deflection.end());
  for (std::size_t i = 0; i < whole.record.force.size(); ++i) {
    const double part = std::clamp(2 * whole.record.deflection[i] / deepest, 0.0, 1.0);
    whole.record.force[i] *= elementary::exp(-part * elementary::log(1 - loss));  // of F = e Ψ(w; μ)
  }
  const FrictionProfile unharmed =
      measure_friction(whole.record, whole.rig, whole.errors, min_informative_deflection(whole.rig.fibre));
  const auto& read = analysis.profile_at_fit.points;
  double integral = 0, length = 0, hidden_before = 0, S_before = not_a_number;
  auto at = read.begin();
  for (const ProfilePoint& point : unharmed.points) {
    while (at != read.end() && at->index < point.index) ++at;
    if (at == read.end() || at->index != point.index) continue;
    const double hidden = point.mu - at->mu;
    if (at->S > S_before) {
      integral += 0.5 * (hidden + hidden_before) * (at->S - S_before);
      length += at->S - S_before;
    }
    hidden_before = hidden;
    S_before = at->S;
  }
  return integral / length;
}

std::vector<EquilibriumPoint> frictionless_curve(const TestAnalysis& analysis) {
  constexpr int points = 200;
  const auto& deflection = analysis.record.deflection;
  const double deepest = analysis.scales.reduced_length(*std::max_element(deflection.begin(), deflection.end()));
  std::vector<EquilibriumPoint> curve = frictionless_up_to(deepest, points, analysis.rig.fibre);
  for (EquilibriumPoint& point : curve) point.F *= stiffening_of(analysis);
  return curve;
}

double euler_bernoulli_force(const TestAnalysis& analysis, double deflection) {
  return beam_stiffness * stiffening_of(analysis) * deflection;
}

TestPath simulated_mean_fit(const TestAnalysis& analysis) {
  constexpr int points = 1000;  // per segment; a figure thins them
  const auto stage = analysis.fit.correction.corrected(analysis.reduced).stage;
  const double farthest = std::min(*std::max_element(stage.begin(), stage.end()), farthest_run(analysis));
  const double stiffening = stiffening_of(analysis);
  const SnapRest rest = analysis.fit.overshoots ? SnapRest::overshoot : SnapRest::nearest_stable;
  TestPath forward = path_continuously(
      {Friction::as_met(analysis.fit.mean), analysis.rig.in_units_of(stiffening), rest}, {&farthest, 1}, points);
  for (auto& point : forward.path) read_by_rig(point, analysis);
  return forward;
}

std::vector<FittedFriction> detected_waves(const TestAnalysis& analysis) {
  const FrictionFit& fit = analysis.fit;
  std::vector<FittedFriction> waves;
  if (!fit.wave_claimed) return waves;
  constexpr double points_a_period = 24;
  const double seen = fit.S_end - fit.S_begin;
  double shortest = seen;
  for (const auto& each : fit.waves) shortest = std::min(shortest, each.wavelength.value / fit.share);  // a period in S
  const int points = static_cast<int>(std::clamp(points_a_period * seen / shortest, 100.0, 20000.0));
  for (int i = 0; i <= points; ++i) {
    const double S = fit.S_begin + seen * i / points;
    const double away = fit.between_contacts(S) - fit.S_middle;
    double mu = fit.mu0.value + fit.drift.value * away;
    for (const auto& each : fit.waves)
      mu += fit.mu0.value * each.amplitude.value *
            std::cos(2 * std::numbers::pi * fit.share * away / each.wavelength.value + each.phase_at_middle.value);
    waves.push_back({S, mu});
  }
  return waves;
}

}  // namespace flexslip
