#include "inference/process_mode.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

#include "inference/chain.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"
#include "numerics/kept_array.h"
#include "numerics/minimum.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using Eigen::Index;

constexpr int of_friction_and_stiffness = 3;  // mean, drift, and ln EI
static_assert(of_friction_and_stiffness + rig_error_capacity + 2 * max_waves <= max_columns);

// The prior of the slack between a bound and friction, which is not negative.
double sign_of(const SkippedPoint& site) { return site.held ? -1 : 1; }

}  // namespace

FrictionProcess::FrictionProcess(Passages passages) : passages_(std::move(passages)) {
  if (passages_.size() < min_readings) throw std::invalid_argument("too few readings tell of friction");
  const double range = passages_.range;
  prior_ = {0.5 * 0.5, 0.2 * 0.2};  // of mean and trend
  Index next = 2;
  if (passages_.stiffness_error > 0) {
    columns_.stiffness = next++;
    prior_.push_back(passages_.stiffness_error * passages_.stiffness_error);
  }
  columns_.rig = next;
  next += static_cast<Index>(passages_.rig_errors.size());
  prior_.resize(static_cast<std::size_t>(next), 1);
  columns_.waves = next;
  std::vector<double> advance, place_error;  // [L] of x
  const auto slopes = rises_of(passages_);
  for (std::size_t i = 1; i < passages_.size(); ++i) {
    const double x_by_S = passages_.share * passages_.along.slope(passages_.S[i]);
    advance.push_back(x_by_S * passages_.advance[i]);
    place_error.push_back(x_by_S * std::abs(slopes.S_force[i]) * passages_.noise);
  }
  // Readings that cluster between a few long jumps resolve no shorter waves than evenly spaced
  // ones. Noise of the places creates spurious waves shorter than its circle.
  const auto& o = options();
  min_wavelength_ =
      std::max({o.min_wave_advances * median_of(std::move(advance)), range / static_cast<double>(passages_.size()),
                o.min_wave_circles * 2 * std::numbers::pi * median_of(std::move(place_error))});
  prior_of_theta_ = ThetaPrior::of(range, passages_.noise, o);
}

FrictionProcess FrictionProcess::with_pull(const Coefficients& pull) const {
  FrictionProcess pulled = *this;
  pulled.pull_ = pull;
  return pulled;
}

// The columns at a place, with space for waves.
Coefficients FrictionProcess::columns_beside_waves(double place, std::size_t waves) const {
  Coefficients h = Coefficients::Zero(columns_.waves + 2 * static_cast<Index>(waves));
  h[columns_.mean] = 1;
  h[columns_.drift] = place / passages_.range;
  return h;
}

Coefficients FrictionProcess::columns_at(double place, const Mode& mode) const {
  Coefficients h = columns_beside_waves(place, mode.theta.waves);
  for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
    const double rate = 2 * std::numbers::pi * elementary::exp(-mode.theta.log_wavelength(wave));
    const auto [sine, cosine] = elementary::sine_and_cosine(rate * place);
    h[columns_.waves + 2 * static_cast<Index>(wave)] = cosine;
    h[columns_.waves + 2 * static_cast<Index>(wave) + 1] = sine;
  }
  return h;
}

std::vector<FrictionProcess::Node> FrictionProcess::nodes_of(const Mode& mode) const {
  std::vector<double> S, stage, near;
  // In an overshooting snap the bound holds up to the unknown nearest stable state: by symmetry,
  // over at least half of the length.
  constexpr double bounded = 0.5;
  const double bounded_part = passages_.overshoots ? bounded : 1;
  for (const auto& site : mode.sites) {
    const double part =
        site.held ? 1 : bounded_part * static_cast<double>(site.node) / static_cast<double>(site.nodes + 1);
    const double before = mode.at.S[site.reading - 1];
    const double beyond = site.stuck ? landing_of(*site.stuck, mode.at.S) : mode.at.S[site.reading];
    const std::size_t reading = reading_of(site);
    S.push_back(before + part * (beyond - before));
    stage.push_back(mode.at.stage[reading]);
    if (site.stuck) stage.back() += (site.held ? site.stuck->last : site.stuck->landing) - passages_.stage[reading];
    near.push_back(mode.at.mu[reading]);
  }
  const auto levels = friction_at_stage(S, stage, near, passages_.fibre, passages_.compliance, mode.at.eta);
  std::vector<Node> nodes;
  for (std::size_t j = 0; j < S.size(); ++j) nodes.push_back({S[j], levels[j]});
  return nodes;
}

// The upper bound of friction at a node, minus the prior mean.
double FrictionProcess::bound_at(const Node& node, const SkippedPoint& site, const Mode& mode) const {
  return node.level - mean_friction + by_errors_at(mode.at, reading_of(site), site.wave_slope);
}

// The effect of an error on the friction of a reading. Shifted places shift waves too; the
// roughness is unknown and carries no information.
double FrictionProcess::by_error(const RigError& error, std::size_t reading, double wave_slope) const {
  return error.friction[reading] + wave_slope * error.place[reading];
}

// The same for the errors of EI and the rig that a linearisation corrects.
double FrictionProcess::by_errors_at(const Linearisation& at, std::size_t reading, double wave_slope) const {
  double more = columns_.stiffness >= 0 ? by_error(passages_.stiffness, reading, wave_slope) * at.eta : 0;
  for (std::size_t r = 0; r < at.rig.size(); ++r)
    more += by_error(passages_.rig_errors[r], reading, wave_slope) * at.rig[r];
  return more;
}

Observations FrictionProcess::observations_of(const Mode& mode) const { return observations_of(mode, nodes_of(mode)); }

Observations FrictionProcess::observations_of(const Mode& mode, const std::vector<Node>& nodes) const {
  const auto& at = mode.at;
  const std::size_t n = passages_.size();
  Observations observations;
  observations.prior = prior_;
  observations.prior.insert(observations.prior.end(), 2 * mode.theta.waves, wave_deviation * wave_deviation);
  if (pull_.size() > 0) {
    observations.pull = Coefficients::Zero(static_cast<Index>(observations.prior.size()));
    observations.pull.head(pull_.size()) = pull_;
  }
  observations.all.reserve(n + nodes.size());
  observations.values.reserve(n + nodes.size());
  observations.columns.reserve(n + nodes.size());
  const auto add = [&](const Observation& observation, double value, std::size_t reading, double wave_slope) {
    observations.all.push_back(observation);
    observations.values.push_back(value);
    Coefficients& h = observations.columns.emplace_back(columns_beside_waves(observation.place, mode.theta.waves));
    if (columns_.stiffness >= 0) h[columns_.stiffness] = by_error(passages_.stiffness, reading, wave_slope);
    for (std::size_t r = 0; r < passages_.rig_errors.size(); ++r)
      h[columns_.rig + static_cast<Index>(r)] = by_error(passages_.rig_errors[r], reading, wave_slope);
  };
  std::size_t j = 0;
  const auto add_sites_before = [&](std::size_t reading) {
    for (; j < nodes.size() && mode.sites[j].reading == reading; ++j)
      add({.place = passages_.place(nodes[j].S), .rows = 0, .noise_gain = 0, .variance = 0}, 0,
          reading_of(mode.sites[j]), mode.sites[j].wave_slope);
  };
  for (std::size_t i = 0; i < n; ++i) {
    add_sites_before(i);
    add({.place = passages_.place(at.S[i]),
         .rows = i == 0 ? 0.0 : static_cast<double>(passages_.row[i] - passages_.row[i - 1]),
         .noise_gain = at.noise_gain[i],
         .variance = nugget * nugget},
        at.y[i] - mean_friction + by_errors_at(at, i, at.wave_slope[i]), i, at.wave_slope[i]);
  }
  add_sites_before(n);
  set_waves(mode.theta, observations);
  say_sites(mode, nodes, observations);
  return observations;
}

std::vector<double> FrictionProcess::by_stiffness(const Mode& mode) const {
  std::vector<double> by;
  std::size_t site = 0;
  for (std::size_t i = 0; i <= passages_.size(); ++i) {
    for (; site < mode.sites.size() && mode.sites[site].reading == i; ++site)
      by.push_back(by_error(passages_.stiffness, reading_of(mode.sites[site]), mode.sites[site].wave_slope));
    if (i < passages_.size()) by.push_back(by_error(passages_.stiffness, i, mode.at.wave_slope[i]));
  }
  return by;
}

Profile FrictionProcess::profile_of(const Mode& mode, std::span<const double> places) const {
  const Observations seen = observations_of(mode);
  Profile profile;
  auto& observations = profile.observations;
  observations.prior = seen.prior;
  observations.pull = seen.pull;
  std::size_t next = 0;
  const auto unseen_to = [&](double end) {
    for (; next < places.size() && places[next] < end; ++next) {
      profile.at.push_back(observations.all.size());
      observations.all.push_back({.place = places[next], .rows = 0, .noise_gain = 0, .variance = infinity});
      observations.values.push_back(0);
      observations.columns.push_back(columns_at(places[next], mode));
    }
  };
  for (std::size_t k = 0; k < seen.all.size(); ++k) {
    unseen_to(seen.all[k].place);
    observations.all.push_back(seen.all[k]);
    observations.values.push_back(seen.values[k]);
    observations.columns.push_back(seen.columns[k]);
  }
  unseen_to(infinity);
  return profile;
}

// The bound minus the mean slack of the point.
void FrictionProcess::say_sites(const Mode& mode, const std::vector<Node>& nodes, Observations& observations) const {
  std::size_t j = 0;
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    if (observations.all[k].is_reading()) continue;
    const SkippedPoint& site = mode.sites[j];
    const double bound = bound_at(nodes[j++], site, mode);
    const bool seen = site.precision > 0;
    observations.all[k].variance = seen ? 1 / site.precision : infinity;
    observations.values[k] = seen ? bound - sign_of(site) * site.precision_mean / site.precision : bound;
  }
}

namespace {

double value_of(const Chain& chain, const Mode& mode, const Theta& theta, const ThetaPrior& prior) {
  return chain.log_likelihood() + mode.at.log_jacobian + prior.log_density(mode.kernel, theta);
}

}  // namespace

void FrictionProcess::set_waves(const Theta& theta, Observations& observations) const {
  const std::size_t n = observations.all.size();
  KeptArray<double> angles(n), sines(n), cosines(n);
  for (std::size_t wave = 0; wave < theta.waves; ++wave) {
    const double rate = 2 * std::numbers::pi * elementary::exp(-theta.log_wavelength(wave));
    for (std::size_t k = 0; k < n; ++k) angles[k] = rate * observations.all[k].place;
    elementary::sine_and_cosine({angles.data(), n}, {sines.data(), n}, {cosines.data(), n});
    const Index at = columns_.waves + 2 * static_cast<Index>(wave);
    for (std::size_t k = 0; k < n; ++k) {
      observations.columns[k][at] = cosines[k];
      observations.columns[k][at + 1] = sines[k];
    }
  }
}

double FrictionProcess::objective_alone(const Mode& mode, Observations& observations, const Theta& theta) const {
  set_waves(theta, observations);
  return value_of(Chain(observations, mode.kernel, hyperparameters_of(theta)), mode, theta, prior_of_theta_);
}

FrictionProcess::Objective FrictionProcess::objective(const Mode& mode, Observations& observations,
                                                      const Theta& theta) const {
  set_waves(theta, observations);
  std::array<double, max_waves> wavelengths{};
  for (std::size_t wave = 0; wave < theta.waves; ++wave)
    wavelengths[wave] = elementary::exp(theta.log_wavelength(wave));
  const auto p = hyperparameters_of(theta);
  const Chain chain(observations, mode.kernel, p);
  const auto likelihood = chain.gradient(std::span(wavelengths).first(theta.waves));
  Objective result{.value = value_of(chain, mode, theta, prior_of_theta_), .gradient = {}};
  for (std::size_t i = 0; i < Theta::first_wave; ++i) {
    if (mode.kernel == Kernel::none && i >= Theta::log_roughness) continue;
    const double of_value = i == Theta::logit_correlation ? p.correlation * (1 - p.correlation / max_correlation) : 1;
    result.gradient[i] = likelihood.hyperparameters[i] * of_value + prior_of_theta_.slope(theta, i);
  }
  for (std::size_t wave = 0; wave < theta.waves; ++wave)
    result.gradient[Theta::first_wave + wave] = likelihood.log_wavelengths[wave];
  return result;
}

// One round of expectation propagation over all points.
void FrictionProcess::update_sites(Mode& mode, const std::vector<Node>& nodes, const Observations& observations,
                                   const std::vector<SmoothedObservation>& smoothed) const {
  std::size_t j = 0;
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    if (observations.all[k].is_reading()) continue;
    SkippedPoint& site = mode.sites[j];
    const double mean = sign_of(site) * (bound_at(nodes[j++], site, mode) - smoothed[k].f);
    const double precision = 1 / std::max(smoothed[k].variance, 1e-12) - site.precision;
    if (!(precision > 1e-10)) continue;
    const double variance = 1 / precision;
    const double cavity = (mean / std::max(smoothed[k].variance, 1e-12) - site.precision_mean) * variance;
    const double blurred = variance + bound_softness * bound_softness;
    const double z = cavity / std::sqrt(blurred);
    const double hazard = elementary::gaussian_below(z).hazard;
    const double tilted_mean = cavity + variance * hazard / std::sqrt(blurred);
    const double tilted_variance = std::max(variance - variance * variance * hazard * (z + hazard) / blurred, 1e-12);
    const double new_precision = std::max(1 / tilted_variance - precision, 1e-10);
    const double new_mean = tilted_mean / tilted_variance - cavity * precision;
    const double fraction = options().gap_fraction;
    site.precision += fraction * (new_precision - site.precision);
    site.precision_mean += fraction * (new_mean - site.precision_mean);
  }
}

// The gain of evidence by values of EI and the rig far from the linearisation, which is excluded
// because the linearisation fails there.
double FrictionProcess::by_moving_rig(const Mode& mode, const Chain& chain) const {
  if (!options().parts.rig_cost) return 0;
  const bool knows_stiffness = columns_.stiffness < 0;
  const Index from = knows_stiffness ? columns_.rig : columns_.stiffness, count = columns_.waves - from;
  if (count == 0) return 0;
  Coefficients away = chain.mean().segment(from, count);
  if (!knows_stiffness) away[0] -= mode.at.eta;
  for (std::size_t r = 0; r < mode.at.rig.size(); ++r)
    away[columns_.rig - from + static_cast<Index>(r)] -= mode.at.rig[r];
  return 0.5 * square_in(chain.covariance().block(from, from, count, count), away);
}

void FrictionProcess::settle(Mode& mode) const {
  mode.sites = skipped_segments(passages_, mode.at, elementary::exp(mode.theta.values[Theta::log_noise]), mode.sites);
  const auto nodes = nodes_of(mode);
  Observations observations = observations_of(mode, nodes);
  const auto p = hyperparameters_of(mode.theta);
  double before = 0;
  constexpr int max_rounds = 30;
  for (int round = 0; round < max_rounds; ++round) {
    const Chain chain(observations, mode.kernel, p);
    double evidence = chain.log_likelihood();
    if (!std::isfinite(evidence)) evidence = -infinity;  // no sliding explains the readings
    if (!mode.sites.empty()) {
      const auto smoothed = chain.smoothed();
      std::size_t j = 0;
      for (std::size_t k = 0; k < observations.all.size(); ++k) {
        if (observations.all[k].is_reading()) continue;
        evidence += log_weight(mode.sites[j],
                               sign_of(mode.sites[j]) * (bound_at(nodes[j], mode.sites[j], mode) - smoothed[k].f),
                               smoothed[k].variance);
        ++j;
      }
      const double negligible = options().gap_accuracy;
      if (round + 1 < max_rounds && !(round > 0 && std::abs(evidence - before) < negligible)) {
        before = evidence;
        update_sites(mode, nodes, observations, smoothed);
        say_sites(mode, nodes, observations);
        continue;
      }
    }
    mode.log_posterior = evidence - by_moving_rig(mode, chain) + mode.at.log_jacobian +
                         prior_of_theta_.log_density(mode.kernel, mode.theta);
    break;
  }
}

// dμ/dS of the fitted friction at each observation.
std::vector<FrictionProcess::Slope> FrictionProcess::slopes_of(const Mode& mode, const Observations& observations,
                                                               const Chain& chain,
                                                               const std::vector<SmoothedObservation>& smoothed) const {
  const Coefficients& beta = chain.mean();
  std::vector<Slope> slopes;
  slopes.reserve(observations.all.size());
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    const Coefficients& h = observations.columns[k];
    double waves = 0;
    for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
      const Index c = columns_.waves + 2 * static_cast<Index>(wave);
      const double rate = 2 * std::numbers::pi * elementary::exp(-mode.theta.log_wavelength(wave));
      waves += rate * (beta[c + 1] * h[c] - beta[c] * h[c + 1]);
    }
    const double x_by_S =
        passages_.share * passages_.along.slope(passages_.sliding_length_at(observations.all[k].place));
    slopes.push_back({x_by_S * (smoothed[k].slope + beta[columns_.drift] / passages_.range + waves), x_by_S * waves});
  }
  return slopes;
}

// Takes one Gauss-Newton step and returns the maximum change of the fitted lengths [L].
double FrictionProcess::pass(Mode& mode, double fraction) const {
  mode.sites = skipped_segments(passages_, mode.at, elementary::exp(mode.theta.values[Theta::log_noise]), mode.sites);
  const auto nodes = nodes_of(mode);
  const Observations observations = observations_of(mode, nodes);
  const auto p = hyperparameters_of(mode.theta);
  const Chain chain(observations, mode.kernel, p);
  if (!std::isfinite(chain.log_likelihood())) return 0;
  const auto smoothed = chain.smoothed();
  const auto slopes = slopes_of(mode, observations, chain, smoothed);
  auto& at = mode.at;
  const double most = options().stiffness_errors * passages_.stiffness_error;
  const double longest = options().stiffness_step;
  const double eta = columns_.stiffness >= 0 ? std::clamp(chain.mean()[columns_.stiffness], -most, most) : at.eta;
  const double eta_step = std::clamp(eta - at.eta, -longest / fraction, longest / fraction);
  std::vector<double> rig_step(chain.mean().data() + columns_.rig, chain.mean().data() + columns_.waves);
  for (std::size_t r = 0; r < rig_step.size(); ++r)
    rig_step[r] = std::clamp(rig_step[r] - at.rig[r], -options().rig_step / fraction, options().rig_step / fraction);
  std::vector<double> target(passages_.size());
  double moved = 0;
  std::size_t i = 0, j = 0;
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    if (!observations.all[k].is_reading()) {
      double& slope = mode.sites[j++].wave_slope;
      slope += fraction * (slopes[k].waves - slope);
      continue;
    }
    const double reach = options().noise_reach * std::abs(at.S_force[i]) * p.noise;
    const double by_noise = std::clamp(-at.S_force[i] * smoothed[k].e, -reach, reach);
    target[i] = at.S_seen[i] + by_noise + at.S_eta[i] * eta_step;
    for (std::size_t r = 0; r < passages_.rig_errors.size(); ++r)
      target[i] += rig_step[r] * passages_.rig_errors[r].place[i];
    moved = std::max(moved, std::abs(target[i] - at.S[i]));
    at.slope[i] += fraction * (slopes[k].all - at.slope[i]);
    at.wave_slope[i] += fraction * (slopes[k].waves - at.wave_slope[i]);
    ++i;
  }
  update_sites(mode, nodes, observations, smoothed);
  at.eta += fraction * eta_step;
  for (std::size_t r = 0; r < rig_step.size(); ++r) at.rig[r] += fraction * rig_step[r];
  for (std::size_t k = 0; k < target.size(); ++k) at.S[k] += fraction * (target[k] - at.S[k]);
  complete(at, passages_);
  return moved;
}

Mode FrictionProcess::start(Kernel kernel, const Theta& theta, const Linearisation& at) {
  return {.kernel = kernel, .theta = theta, .at = at, .sites = {}, .log_posterior = -infinity};
}

void FrictionProcess::burst(Mode& mode, int steps, double fraction) const {
  for (int step = 0; step < steps; ++step) {
    constexpr double settled = 2e-6;  // [L] far below the resolution of a reading
    if (pass(mode, fraction) < settled) break;
  }
  settle(mode);
}

// [1] The longest step of ln λ, a tenth of a period over the range.
double FrictionProcess::longest_step(double log_wavelength) const {
  return options().wave_step * elementary::exp(log_wavelength - elementary::log(passages_.range));
}

// The approximate inverse of minus the curvature of the log_posterior in θ.
FrictionProcess::ThetaMatrix FrictionProcess::usual_spread(const Theta& theta) const {
  const auto n = static_cast<Index>(theta.size());
  ThetaMatrix spread = options().theta_spread * ThetaMatrix::Identity(n, n);
  for (std::size_t wave = 0; wave < theta.waves; ++wave) {
    const auto at = static_cast<Index>(Theta::first_wave + wave);
    const double longest = longest_step(theta.log_wavelength(wave));
    spread(at, at) = options().wave_spread * longest * longest;
  }
  return spread;
}

// Maximises over θ within a moving box (BFGS); steps are limited to 1, or longest_step for ln λ.
void FrictionProcess::maximise(Mode& mode, ThetaMatrix& spread, int iterations) const {
  const auto n = static_cast<Index>(mode.theta.size());
  Box<ThetaVector> box{
      .low = ThetaVector(n), .high = ThetaVector(n), .longest_step = ThetaVector::Constant(n, options().theta_step)};
  ThetaVector start(n);
  for (Index i = 0; i < n; ++i) start[i] = mode.theta.values[static_cast<std::size_t>(i)];
  constexpr auto first_wave = static_cast<Index>(Theta::first_wave);
  for (Index i = 0; i < first_wave; ++i) {
    box.low[i] = prior_of_theta_.min[static_cast<std::size_t>(i)];
    box.high[i] = prior_of_theta_.max[static_cast<std::size_t>(i)];
  }
  for (Index i = first_wave; i < n; ++i) {
    box.longest_step[i] = longest_step(start[i]);
    box.low[i] = std::max(start[i] - options().wave_box, elementary::log(min_wavelength_) - options().wave_box);
    box.high[i] = std::min(start[i] + options().wave_box, elementary::log(max_wavelength()) + options().wave_box);
  }
  const auto theta_at = [&](const ThetaVector& x) {
    Theta theta = mode.theta;
    for (Index i = 0; i < n; ++i) theta.values[static_cast<std::size_t>(i)] = x[i];
    return theta;
  };
  struct Merit {
    double value;
    ThetaVector gradient;
  };
  Observations observations = observations_of(mode);
  const auto merit_at = [&](const ThetaVector& x) {
    const Objective at = objective(mode, observations, theta_at(x));
    return Merit{at.value, ThetaVector(Eigen::Map<const Eigen::VectorXd>(at.gradient.data(), n))};
  };
  const double negligible = options().theta_accuracy;
  mode.theta = theta_at(maximised_in_box(merit_at, start, box, spread, iterations, negligible));
}

void FrictionProcess::polish(Mode& mode, const Schedule& schedule) const {
  settle(mode);
  double before = mode.log_posterior;
  Mode best = mode;  // only modes with settled states have a meaningful log_posterior
  ThetaMatrix spread = usual_spread(mode.theta);
  for (int round = 0; round < schedule.rounds; ++round) {
    maximise(mode, spread, static_cast<int>(options().theta_iterations));
    burst(mode, schedule);
    const double gain = mode.log_posterior - before;
    if (round == 0 || gain > 0) {
      best = mode;
      before = mode.log_posterior;
    }
    if (std::abs(gain) < options().polish_accuracy) break;
  }
  mode = std::move(best);
}

}  // namespace flexslip
