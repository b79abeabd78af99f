#include "inference/process_mode.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

#include "inference/chain.h"
#include "inference/process_posterior.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"
#include "numerics/kept_array.h"
#include "numerics/minimum.h"
#include "numerics/progress.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

using Eigen::Index;

constexpr int of_friction_and_stiffness = 3;  // mean, drift, and ln EI
static_assert(of_friction_and_stiffness + most_rig_errors + 2 * max_waves <= max_columns);

}  // namespace

FrictionProcess::FrictionProcess(Passages passages) : passages_(std::move(passages)) {
  if (passages_.size() < min_readings) throw std::invalid_argument("too few readings tell of friction");
  const double range = passages_.range;
  prior_ = {0.5 * 0.5, 0.2 * 0.2};  // of the mean and the drift
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
    const double x_by_S = 0.5 * passages_.along.slope(passages_.S[i]);
    advance.push_back(2 * x_by_S * passages_.advance[i]);
    place_error.push_back(x_by_S * std::abs(slopes.S_force[i]) * passages_.noise);
  }
  // Readings that hardly advance between a few long jumps tell of no shorter waves than as many spread evenly do; and noise, which moves the
  // place of a reading as well, makes waves of its own that are shorter than its circle.
  min_wavelength_ = std::max({2 * median_of(std::move(advance)), range / static_cast<double>(passages_.size()),
                              2 * std::numbers::pi * median_of(std::move(place_error))});
  prior_of_theta_ = ThetaPrior::of(range, passages_.noise);
}

FrictionProcess FrictionProcess::with_pull(const Coefficients& pull) const {
  FrictionProcess pulled = *this;
  pulled.pull_ = pull;
  return pulled;
}

// The columns at a place, of waves the room for them.
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
  const auto at_site = [](const GapSite& site, const std::vector<double>& values) {
    const double part = static_cast<double>(site.node) / static_cast<double>(site.nodes + 1);
    const double before = values[site.reading - 1];
    return before + part * (values[site.reading] - before);
  };
  for (const auto& site : mode.sites) {
    S.push_back(at_site(site, mode.at.S));
    stage.push_back(mode.at.stage[site.reading]);
    near.push_back(mode.at.mu[site.reading]);
  }
  const auto levels = levels_of(S, stage, near, passages_.fibre, passages_.compliance, mode.at.eta);
  std::vector<Node> nodes;
  for (std::size_t j = 0; j < S.size(); ++j) nodes.push_back({S[j], levels[j]});
  return nodes;
}

// What friction at a node is below, less what is expected of it.
double FrictionProcess::bound_at(const Node& node, const GapSite& site, const Mode& mode) const {
  return node.level - mean_friction + by_errors_at(mode.at, site.reading, site.wave_slope);
}

// The friction that a reading shows larger by an error: where it moves places, waves move along; roughness, whose size and places nobody knows
// beforehand, tells nothing.
double FrictionProcess::by_error(const RigError& error, std::size_t reading, double wave_slope) const {
  return error.friction[reading] + wave_slope * error.place[reading];
}

// Likewise by the errors of EI and of the rig that a linearisation has taken off.
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
  for (std::size_t i = 0; i < n; ++i) {
    for (; j < nodes.size() && mode.sites[j].reading == i; ++j)
      add({.place = passages_.place(nodes[j].S), .rows = 0, .noise_gain = 0, .variance = 0}, 0, i,
          mode.sites[j].wave_slope);
    add({.place = passages_.place(at.S[i]),
         .rows = i == 0 ? 0.0 : static_cast<double>(passages_.row[i] - passages_.row[i - 1]),
         .noise_gain = at.noise_gain[i],
         .variance = nugget * nugget},
        at.y[i] - mean_friction + by_errors_at(at, i, at.wave_slope[i]), i, at.wave_slope[i]);
  }
  set_waves(mode.theta, observations);
  say_sites(mode, nodes, observations);
  return observations;
}

std::vector<double> FrictionProcess::by_stiffness(const Mode& mode) const {
  std::vector<double> by;
  std::size_t site = 0;
  for (std::size_t i = 0; i < passages_.size(); ++i) {
    for (; site < mode.sites.size() && mode.sites[site].reading == i; ++site)
      by.push_back(by_error(passages_.stiffness, i, mode.sites[site].wave_slope));
    by.push_back(by_error(passages_.stiffness, i, mode.at.wave_slope[i]));
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

// The bound less the slack, which the site says.
void FrictionProcess::say_sites(const Mode& mode, const std::vector<Node>& nodes, Observations& observations) const {
  std::size_t j = 0;
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    if (observations.all[k].is_reading()) continue;
    const GapSite& site = mode.sites[j];
    const double bound = bound_at(nodes[j++], site, mode);
    const bool seen = site.precision > 0;
    observations.all[k].variance = seen ? 1 / site.precision : infinity;
    observations.values[k] = seen ? bound - site.precision_mean / site.precision : bound;
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

// One round of expectation propagation, all sites at once.
void FrictionProcess::update_sites(Mode& mode, const std::vector<Node>& nodes, const Observations& observations,
                                   const std::vector<SmoothedObservation>& smoothed) const {
  std::size_t j = 0;
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    if (observations.all[k].is_reading()) continue;
    GapSite& site = mode.sites[j];
    const double mean = bound_at(nodes[j++], site, mode) - smoothed[k].f;
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
    constexpr double fraction = 0.5;  // all at once overshoot where they tell of the same friction
    site.precision += fraction * (new_precision - site.precision);
    site.precision_mean += fraction * (new_mean - site.precision_mean);
  }
}

// What the evidence would gain by an EI and a rig away from those of the linearisation: no gain, since there it does not hold.
double FrictionProcess::by_moving_rig(const Mode& mode, const Chain& chain) const {
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
  mode.sites = sites_of(passages_, mode.at, elementary::exp(mode.theta.values[Theta::log_noise]), mode.sites);
  const auto nodes = nodes_of(mode);
  Observations observations = observations_of(mode, nodes);
  const auto p = hyperparameters_of(mode.theta);
  double before = 0;
  constexpr int max_rounds = 30;
  for (int round = 0; round < max_rounds; ++round) {
    const Chain chain(observations, mode.kernel, p);
    double evidence = chain.log_likelihood();
    if (!std::isfinite(evidence)) evidence = -infinity;  // so far from any sliding that it leads nowhere
    if (!mode.sites.empty()) {
      const auto smoothed = chain.smoothed();
      std::size_t j = 0;
      for (std::size_t k = 0; k < observations.all.size(); ++k) {
        if (observations.all[k].is_reading()) continue;
        evidence +=
            log_weight(mode.sites[j], bound_at(nodes[j], mode.sites[j], mode) - smoothed[k].f, smoothed[k].variance);
        ++j;
      }
      constexpr double negligible = 0.002;  // of the evidence
      if (round + 1 < max_rounds && !(round > 0 && std::abs(evidence - before) < negligible)) {
        before = evidence;
        update_sites(mode, nodes, observations, smoothed);
        say_sites(mode, nodes, observations);
        continue;
      }
    }
    mode.merit = evidence - by_moving_rig(mode, chain) + mode.at.log_jacobian +
                 prior_of_theta_.log_density(mode.kernel, mode.theta);
    break;
  }
}

// dμ/dS of the friction fitted, at each observation.
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
    const double x_by_S = 0.5 * passages_.along.slope(passages_.drawn_in_at(observations.all[k].place));
    slopes.push_back({x_by_S * (smoothed[k].slope + beta[columns_.drift] / passages_.range + waves), x_by_S * waves});
  }
  return slopes;
}

// One Gauss-Newton step; returns how far the fitted lengths had to go, the greatest of them [L].
double FrictionProcess::pass(Mode& mode, double fraction) const {
  mode.sites = sites_of(passages_, mode.at, elementary::exp(mode.theta.values[Theta::log_noise]), mode.sites);
  const auto nodes = nodes_of(mode);
  const Observations observations = observations_of(mode, nodes);
  const auto p = hyperparameters_of(mode.theta);
  const Chain chain(observations, mode.kernel, p);
  if (!std::isfinite(chain.log_likelihood())) return 0;
  const auto smoothed = chain.smoothed();
  const auto slopes = slopes_of(mode, observations, chain, smoothed);
  auto& at = mode.at;
  const double most = 0.15 + 5 * passages_.stiffness_error;
  constexpr double longest = 0.01;  // J holds near where it was taken
  const double eta = columns_.stiffness >= 0 ? std::clamp(chain.mean()[columns_.stiffness], -most, most) : at.eta;
  const double eta_step = std::clamp(eta - at.eta, -longest / fraction, longest / fraction);
  const std::vector<double> rig(chain.mean().data() + columns_.rig, chain.mean().data() + columns_.waves);
  std::vector<double> target(passages_.size());
  double moved = 0;
  std::size_t i = 0, j = 0;
  for (std::size_t k = 0; k < observations.all.size(); ++k) {
    if (!observations.all[k].is_reading()) {
      double& slope = mode.sites[j++].wave_slope;
      slope += fraction * (slopes[k].waves - slope);
      continue;
    }
    const double reach = 4 * std::abs(at.S_force[i]) * p.noise;
    const double by_noise = std::clamp(-at.S_force[i] * smoothed[k].e, -reach, reach);
    target[i] = at.S_seen[i] + by_noise + at.S_eta[i] * eta_step;
    for (std::size_t r = 0; r < passages_.rig_errors.size(); ++r)
      target[i] += (rig[r] - at.rig[r]) * passages_.rig_errors[r].place[i];
    moved = std::max(moved, std::abs(target[i] - at.S[i]));
    at.slope[i] += fraction * (slopes[k].all - at.slope[i]);
    at.wave_slope[i] += fraction * (slopes[k].waves - at.wave_slope[i]);
    ++i;
  }
  update_sites(mode, nodes, observations, smoothed);
  at.eta += fraction * eta_step;
  for (std::size_t r = 0; r < rig.size(); ++r) at.rig[r] += fraction * (rig[r] - at.rig[r]);
  for (std::size_t k = 0; k < target.size(); ++k) at.S[k] += fraction * (target[k] - at.S[k]);
  complete(at, passages_);
  return moved;
}

Mode FrictionProcess::start(Kernel kernel, const Theta& theta, const Linearisation& at) {
  return {.kernel = kernel, .theta = theta, .at = at, .sites = {}, .merit = -infinity};
}

void FrictionProcess::burst(Mode& mode, int steps, double fraction) const {
  for (int step = 0; step < steps; ++step) {
    constexpr double settled = 2e-6;  // [L] far below what a reading resolves
    if (pass(mode, fraction) < settled) break;
  }
  settle(mode);
}

// [1] Of ln λ: a tenth of a period over the range.
double FrictionProcess::longest_step(double log_wavelength) const {
  return 0.3 * elementary::exp(log_wavelength - elementary::log(passages_.range));
}

// Minus the inverse curvature of the merit in θ, roughly.
FrictionProcess::ThetaMatrix FrictionProcess::usual_spread(const Theta& theta) const {
  const auto n = static_cast<Index>(theta.size());
  ThetaMatrix spread = 0.05 * ThetaMatrix::Identity(n, n);
  for (std::size_t wave = 0; wave < theta.waves; ++wave) {
    const auto at = static_cast<Index>(Theta::first_wave + wave);
    const double longest = longest_step(theta.log_wavelength(wave));
    spread(at, at) = 0.01 * longest * longest;
  }
  return spread;
}

// Uphill in θ, within a box that moves along; no step is longer than 1, of ln λ than a tenth of a period over the range. The spread is learned.
void FrictionProcess::maximise(Mode& mode, ThetaMatrix& spread, int iterations) const {
  const auto n = static_cast<Index>(mode.theta.size());
  Box<ThetaVector> box{.low = ThetaVector(n), .high = ThetaVector(n), .longest_step = ThetaVector::Constant(n, 1.0)};
  ThetaVector start(n);
  for (Index i = 0; i < n; ++i) start[i] = mode.theta.values[static_cast<std::size_t>(i)];
  constexpr auto first_wave = static_cast<Index>(Theta::first_wave);
  for (Index i = 0; i < first_wave; ++i) {
    box.low[i] = prior_of_theta_.least[static_cast<std::size_t>(i)];
    box.high[i] = prior_of_theta_.greatest[static_cast<std::size_t>(i)];
  }
  for (Index i = first_wave; i < n; ++i) {
    box.longest_step[i] = longest_step(start[i]);
    box.low[i] = std::max(start[i] - 0.15, elementary::log(0.5 * min_wavelength_));
    box.high[i] = std::min(start[i] + 0.15, elementary::log(1.2 * max_wavelength()));
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
  constexpr double negligible = 0.003;  // of the merit
  mode.theta = theta_at(maximised_in_box(merit_at, start, box, spread, iterations, negligible));
}

void FrictionProcess::polish(Mode& mode, int rounds, int steps, double fraction) const {
  settle(mode);
  double before = mode.merit;
  Mode best = mode;  // of states that have followed their hyperparameters: the merit of others means nothing
  ThetaMatrix spread = usual_spread(mode.theta);
  for (int round = 0; round < rounds; ++round) {
    constexpr int iterations = 8;
    maximise(mode, spread, iterations);
    burst(mode, steps, fraction);
    const double gain = mode.merit - before;
    if (round == 0 || gain > 0) {
      best = mode;
      before = mode.merit;
    }
    constexpr double negligible = 0.05;
    if (std::abs(gain) < negligible) break;
  }
  mode = std::move(best);
}

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double near_best = 12;  // of the merit: modes farther below weigh nothing

// The gain of a wave at many wavelengths, its amplitude integrated out, everything else as in a mode.
std::vector<ScannedWavelength> scan_of(const FrictionProcess& process, const Mode& mode) {
  const Observations observations = process.observations_of(mode);
  const Chain chain(observations, mode.kernel, hyperparameters_of(mode.theta));
  const std::size_t n = observations.all.size();
  const auto white = chain.whitened_columns();
  const auto p = white.rows() - 1;
  const double range = process.passages().range;
  const double least = 1 / process.max_wavelength(), most = 1 / process.min_wavelength(), step = 1 / (8 * range);
  const std::size_t count = most > least ? static_cast<std::size_t>((most - least) / step) + 1 : 0;
  // cos and sin of 2π f x for four f at once, then for the next four by turning.
  constexpr std::size_t at_once = 4;
  std::vector<Chain::Eight> waves(n), whitened(n);
  std::vector<elementary::SineAndCosine> turn(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = 2 * std::numbers::pi * observations.all[k].place;
    turn[k] = elementary::sine_and_cosine(at_once * step * x);
    for (std::size_t l = 0; l < at_once; ++l) {
      const auto begin = elementary::sine_and_cosine((least + static_cast<double>(l) * step) * x);
      waves[k][l] = begin.cosine;
      waves[k][at_once + l] = begin.sine;
    }
  }
  std::vector<ScannedWavelength> scan;
  constexpr double prior = 1 / (FrictionProcess::wave_deviation * FrictionProcess::wave_deviation);
  for (std::size_t i = 0; i < count; i += at_once) {
    chain.whiten(waves, whitened);
    std::array<Chain::Eight, max_columns + 1> with{};  // the columns and y
    Chain::Eight squares{};
    std::array<double, at_once> products{};
    for (std::size_t k = 0; k < n; ++k) {
      const double* const series = white.col(static_cast<Index>(k)).data();
      const Chain::Eight& w = whitened[k];
      for (std::size_t c = 0; c <= static_cast<std::size_t>(p); ++c)
        for (std::size_t l = 0; l < 2 * at_once; ++l) with[c][l] += series[c] * w[l];
      for (std::size_t l = 0; l < 2 * at_once; ++l) squares[l] += w[l] * w[l];
      for (std::size_t l = 0; l < at_once; ++l) products[l] += w[l] * w[at_once + l];
    }
    for (std::size_t l = 0; l < at_once && i + l < count; ++l) {
      // The columns of the mode take their part: with them β ~ N(mean, covariance) and the rest is orthogonal.
      Coefficients c(p), s(p);
      for (Index j = 0; j < p; ++j) {
        c[j] = with[static_cast<std::size_t>(j)][l];
        s[j] = with[static_cast<std::size_t>(j)][at_once + l];
      }
      const Coefficients cc = chain.covariance() * c, cs = chain.covariance() * s;
      const double a = squares[l] - c.dot(cc) + prior, b = squares[at_once + l] - s.dot(cs) + prior;
      const double ab = products[l] - c.dot(cs);
      const auto last = static_cast<std::size_t>(p);
      const double y = with[last][l] - c.dot(chain.mean()), z = with[last][at_once + l] - s.dot(chain.mean());
      const double determinant = a * b - ab * ab;
      const double gain = 0.5 * (b * y * y - 2 * ab * y * z + a * z * z) / determinant -
                          0.5 * elementary::log(determinant / (prior * prior));
      scan.push_back({1 / (least + static_cast<double>(i + l) * step), gain});
    }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < at_once; ++l) {
        const double cosine = waves[k][l], sine = waves[k][at_once + l];
        waves[k][l] = cosine * turn[k].cosine - sine * turn[k].sine;
        waves[k][at_once + l] = sine * turn[k].cosine + cosine * turn[k].sine;
      }
  }
  std::reverse(scan.begin(), scan.end());
  return scan;
}

std::vector<ScannedWavelength> peaks_of(const std::vector<ScannedWavelength>& scan, std::size_t most) {
  std::vector<ScannedWavelength> peaks;
  for (std::size_t i = 1; i + 1 < scan.size(); ++i)
    if (scan[i].gain >= scan[i - 1].gain && scan[i].gain > scan[i + 1].gain) peaks.push_back(scan[i]);
  std::stable_sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.gain > b.gain; });
  if (peaks.size() > most) peaks.resize(most);
  return peaks;
}

// Minus the second difference of the merit in a hyperparameter, over the step at which it falls by one or more on the average of both sides.
double curvature_of_fall(const FrictionProcess& process, const Mode& mode, Observations& observations,
                         std::size_t hyperparameter) {
  const auto at = [&](double step) {
    Theta theta = mode.theta;
    theta.values[hyperparameter] += step;
    return process.objective_alone(mode, observations, theta);
  };
  const double top = at(0);
  constexpr double first = 2e-4, last = 0.1;
  for (double step = first; step < last; step *= 2) {
    const double fall = top - 0.5 * (at(step) + at(-step));
    if (fall >= 1) return 2 * fall / (step * step);
  }
  return 2 / (last * last);
}

// ln p(readings, gaps), θ integrated out by the curvature of the merit at the mode.
Component component_of(const FrictionProcess& process, const Mode& mode) {
  const auto n = static_cast<Index>(mode.theta.size());
  MatrixXd H = MatrixXd::Identity(n, n);
  Observations observations = process.observations_of(mode);
  const auto free = [&](Index i) { return !(mode.kernel == Kernel::none && (i == 2 || i == 3)); };
  for (Index i = 0; i < n; ++i) {
    if (!free(i)) continue;
    // The merit may be flat at its top in ln λ, or dented, and steep beside it: what counts is where it has fallen by about one.
    const double curvature = i < 4 ? 0 : curvature_of_fall(process, mode, observations, static_cast<std::size_t>(i));
    const double h = i < 4 ? 0.02 : 1 / std::sqrt(curvature);
    Theta up = mode.theta, down = mode.theta;
    up.values[static_cast<std::size_t>(i)] += h;
    down.values[static_cast<std::size_t>(i)] -= h;
    const auto a = process.objective(mode, observations, up), b = process.objective(mode, observations, down);
    for (Index j = 0; j < n; ++j)
      if (free(j))
        H(i, j) = -(a.gradient[static_cast<std::size_t>(j)] - b.gradient[static_cast<std::size_t>(j)]) / (2 * h);
    H(i, i) = std::max(H(i, i), 0.5 * curvature);
  }
  H = (0.5 * (H + H.transpose())).eval();
  // In units of the deviations that each has by itself, since those of ln λ are far smaller.
  constexpr double min_curvature = 0.3;  // a standard deviation of at most 1.8 in the logarithm of a hyperparameter
  const Eigen::VectorXd unit = H.diagonal().cwiseMax(min_curvature).cwiseSqrt().cwiseInverse();
  const auto [curvatures, vectors] = eigen_of(MatrixXd(unit.asDiagonal() * H * unit.asDiagonal()));
  constexpr double least =
      0.003;  // two waves stretch together, with the specimen, by twenty deviations of either alone
  const Eigen::VectorXd values = curvatures.cwiseMax(least);
  double log_evidence = mode.merit + process.prior_of_theta().log_scale(mode.kernel);
  for (Index i = 0; i < n; ++i) log_evidence += elementary::log(unit[i]) - 0.5 * elementary::log(values[i]);
  const auto dimensions = static_cast<double>(n - (mode.kernel == Kernel::none ? 2 : 0));
  log_evidence += 0.5 * dimensions * elementary::log(2 * std::numbers::pi);
  // Of waves, each ln λ is uniform, and which is called the first says nothing.
  for (std::size_t wave = 0; wave < mode.theta.waves; ++wave)
    log_evidence += elementary::log(static_cast<double>(wave + 1)) -
                    elementary::log(elementary::log(process.max_wavelength() / process.min_wavelength()));
  const MatrixXd root = unit.asDiagonal() * vectors * values.cwiseSqrt().cwiseInverse().asDiagonal();
  Component component{.mode = mode, .log_evidence = log_evidence, .spread = product(root, MatrixXd(root.transpose()))};
  for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
    const auto at = static_cast<Index>(Theta::first_wave + wave);
    component.wavelength_deviation[wave] = std::sqrt(component.spread(at, at));
  }
  return component;
}

bool better(const Mode& a, const Mode& b) { return a.merit > b.merit; }

class Search {
 public:
  Search(const FrictionProcess& process, const SearchOptions& options)
      : process_(process), options_(options), rises_(rises_of(process.passages())), run_(process.passages()) {}

  ProcessSearch run() {
    ProcessSearch result;
    Stages stages;
    stages.enter("friction without a wave", 0.08);
    Mode plain = without_wave(first_kernel());
    if (!std::isfinite(plain.merit)) return result;
    result.scan = scan_of(process_, plain);
    const std::size_t asked = options_.waves.value_or(1);
    stages.enter("friction with a wave", 0.48);
    std::vector<Mode> waves;
    for (std::size_t count = 1; count <= asked; ++count) {
      auto more = count == 1 ? with_one_more_wave(plain, result.scan)
                             : with_one_more_wave(waves.front(), scan_of(process_, waves.front()));
      if (more.empty()) break;
      waves = std::move(more);
    }
    const bool with_plain = !options_.waves || waves.empty();
    stages.enter("friction without a wave", 0.12);
    if (with_plain && !waves.empty()) improve(plain, waves.front());
    process_.polish(plain, 6, 10, 0.3);
    auto& components = result.components;
    for (const Mode& wave : waves) components.push_back(component_of(process_, wave));
    if (with_plain) components.push_back(component_of(process_, plain));
    const double gain = with_plain ? components.front().log_evidence - components.back().log_evidence : claiming_gain;
    stages.enter("a second wave", 0.03);
    if (!options_.waves && !waves.empty() && gain > claiming_gain) add_second_wave(waves, components);
    stages.enter("how rough friction is", 0.29);
    // Where a wave is out of the question with its kernel, it is not asked for with the others; nor are waves far below the best, or any beside it
    // that gains nothing.
    constexpr double out_of_question = -2, far_below = 3;
    const double beside = gain > 0 ? far_below : 0;
    for (const Kernel kernel : options_.kernels) {
      if (with_plain && kernel != plain.kernel) components.push_back(component_of(process_, continued(plain, kernel)));
      for (const Mode& wave : waves)
        if (gain > out_of_question && kernel != wave.kernel && wave.merit >= waves.front().merit - beside)
          components.push_back(component_of(process_, continued(wave, kernel)));
    }
    const auto rank = [&] {
      std::stable_sort(components.begin(), components.end(),
                       [](const auto& a, const auto& b) { return a.log_evidence > b.log_evidence; });
    };
    rank();
    const double best = components.front().log_evidence;
    for (Component& component : components)
      if (component.log_evidence > best - far_below) converge(component);
    rank();
    move_along_valley(components);
    rank();
    return result;
  }

 private:
  // Modes with two waves, where the second is claimed as well: they take the place of those with one.
  void add_second_wave(std::vector<Mode>& waves, std::vector<Component>& components) const {
    const auto two = with_one_more_wave(waves.front(), scan_of(process_, waves.front()));
    if (two.empty()) return;
    const Component best = component_of(process_, two.front());
    if (best.log_evidence < components.front().log_evidence + claiming_gain) return;
    std::erase_if(components, [](const Component& component) { return component.mode.theta.waves == 1; });
    components.insert(components.begin(), best);
    for (std::size_t i = 1; i < two.size(); ++i) components.push_back(component_of(process_, two[i]));
    waves = two;
  }

  Kernel first_kernel() const {
    for (const Kernel kernel : options_.kernels)
      if (kernel == Kernel::matern_3_2) return kernel;
    return options_.kernels.front();
  }

  // Until it is linearised at what it says itself of the rig, too: merits of others say little.
  void converge(Component& component) const {
    Mode mode = component.mode;
    constexpr int steps = 12;
    constexpr double fraction = 0.5, ran_away = 12;  // of the merit
    process_.burst(mode, steps, fraction);
    if (!(mode.merit > component.mode.merit - ran_away)) return;
    component.log_evidence += mode.merit - component.mode.merit;
    component.mode = std::move(mode);
  }

  // [rad] φ of each wave, R cos(2πx/λ − φ).
  std::array<double, max_waves> angles_of(const Mode& mode) const {
    const Observations observations = process_.observations_of(mode);
    const Coefficients beta = Chain(observations, mode.kernel, hyperparameters_of(mode.theta)).mean();
    std::array<double, max_waves> angles{};
    for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
      const Index at = process_.columns().waves + 2 * static_cast<Index>(wave);
      angles[wave] = elementary::angle(beta[at + 1], beta[at]);
    }
    return angles;
  }

  // The likeliest waves to where their lengths and the errors of the rig are likeliest together, which no polish of one at a time gets to soon: a rig that
  // is off stretches all waves alike. How far the lengths may be off is taken for that of all other modes with so many waves.
  void move_along_valley(std::vector<Component>& components) const {
    Component& component = components.front();
    const std::size_t waves = component.mode.theta.waves;
    if (waves == 0) return;
    const auto stretched = [&](double by) {
      Mode mode = component.mode;
      for (std::size_t wave = 0; wave < waves; ++wave) mode.theta.values[Theta::first_wave + wave] += by;
      constexpr int steps = 10;
      process_.burst(mode, steps, 0.5);
      return mode;
    };
    const auto begin = component.wavelength_deviation.begin(), end = begin + static_cast<std::ptrdiff_t>(waves);
    const double linearised = *std::min_element(begin, end), step = 2 * linearised, top = component.mode.merit;
    const Mode longer = stretched(step), shorter = stretched(-step);
    const double curvature = (2 * top - longer.merit - shorter.merit) / (step * step);
    if (!std::isfinite(curvature)) return;
    const auto angles = angles_of(component.mode), of_longer = angles_of(longer), of_shorter = angles_of(shorter);
    std::array<double, max_waves> turn{};
    for (std::size_t wave = 0; wave < waves; ++wave)
      turn[wave] = (elementary::wrapped_angle(of_longer[wave] - angles[wave]) +
                    elementary::wrapped_angle(angles[wave] - of_shorter[wave])) /
                   (2 * step);
    constexpr double widest = 5;  // beyond, a parabola tells nothing
    const double told = std::max(curvature, 1 / (widest * widest * linearised * linearised));
    for (Component& each : components) {
      if (each.mode.theta.waves != waves) continue;
      each.turn = turn;
      for (std::size_t wave = 0; wave < waves; ++wave)
        each.wavelength_deviation[wave] = std::max(each.wavelength_deviation[wave], 1 / std::sqrt(told));
    }
    Mode moved = stretched(std::clamp((longer.merit - shorter.merit) / (2 * step * told), -2 * step, 2 * step));
    if (!(moved.merit > top)) return;
    component.log_evidence += moved.merit - top;
    component.mode = std::move(moved);
  }

  // A mode settled, and moved by a burst where that is much better.
  Mode settled(Mode mode, int steps, double fraction) const {
    process_.settle(mode);
    Mode moved = mode;
    process_.burst(moved, steps, fraction);
    return moved.merit > mode.merit + 5 ? moved : mode;
  }

  Mode without_wave(Kernel kernel) const {
    Mode mode = settled(process_.start(kernel, process_.prior_of_theta().usual(), rises_), 8, 0.3);
    process_.polish(mode, 3, 4, 0.3);
    process_.burst(mode, 4, 0.3);
    return mode;
  }

  std::vector<double> candidates(const Mode& plain, Mode raw, const std::vector<ScannedWavelength>& scan) const {
    std::vector<double> found;
    const auto add = [&](const std::vector<ScannedWavelength>& in) {
      for (const auto& peak : peaks_of(in, 2)) {
        if (!is_resolved(peak.wavelength, plain.theta, plain.theta.waves)) continue;
        const bool known = std::any_of(found.begin(), found.end(), [&](double other) {
          return std::abs(elementary::log(peak.wavelength / other)) < 0.5 * peak.wavelength / process_.passages().range;
        });
        if (!known) found.push_back(peak.wavelength);
      }
    };
    add(scan);
    if (!is_blurred(plain)) return found;
    Mode smooth = plain;
    const double range = process_.passages().range;
    smooth.theta.values[Theta::log_roughness] = elementary::log(0.03);
    smooth.theta.values[Theta::log_length] = elementary::log(range / 5);
    add(scan_of(process_, smooth));
    raw.theta.values[Theta::log_length] = elementary::log(range / 5);
    add(scan_of(process_, raw));
    return found;
  }

  // Does the fibre seen tell a wavelength from those that are there? Two that differ by less than a period over it are one whose height varies.
  bool is_resolved(double wavelength, const Theta& theta, std::size_t waves) const {
    for (std::size_t wave = 0; wave < waves; ++wave)
      if (std::abs(1 / wavelength - elementary::exp(-theta.log_wavelength(wave))) * process_.passages().range < 1)
        return false;
    return true;
  }

  // A mode with one more wave than `theta` has, quickly.
  Mode tried(const Mode& from, Theta theta, double log_wavelength) const {
    theta.values[Theta::log_roughness] = elementary::log(0.03);
    theta.values[Theta::log_length] = elementary::log(process_.passages().range / 10);
    theta.add_wave(log_wavelength);
    Mode mode = process_.start(from.kernel, theta, from.at);
    mode.sites = from.sites;
    mode = settled(std::move(mode), 7, 0.5);
    process_.polish(mode, 1, 3, 0.5);
    return mode;
  }

  std::vector<Mode> with_one_more_wave(const Mode& plain, const std::vector<ScannedWavelength>& scan) const {
    const double range = process_.passages().range;
    const Theta usual =
        process_.prior_of_theta().usual(std::span(plain.theta.values).subspan(Theta::first_wave, plain.theta.waves));
    const Mode raw = process_.start(plain.kernel, usual, rises_);
    const std::size_t last = plain.theta.waves;  // the wave that is sought
    std::vector<std::pair<Mode, double>> found;  // and the wavelength that it started from
    const auto rank = [&] {
      std::stable_sort(found.begin(), found.end(),
                       [](const auto& a, const auto& b) { return better(a.first, b.first); });
    };
    const auto try_from = [&](const Mode& from, double wavelength) {
      found.emplace_back(tried(from, from.theta, elementary::log(wavelength)), wavelength);
      return found.back().first.merit;
    };
    const std::vector<double> wavelengths = candidates(plain, raw, scan);
    std::vector<double> merits;
    for (const double wavelength : wavelengths) merits.push_back(try_from(plain, wavelength));
    double best = merits.empty() ? -infinity : *std::max_element(merits.begin(), merits.end());
    // Where noise blurs the places of readings, their order along the fibre is in doubt, and with it where to begin: from the rises as well the first peak,
    // what was led astray, which loses more than a wave costs, and where any wave gains, all.
    const bool blurred = is_blurred(plain);
    constexpr double cost = 6;  // of the merit
    for (std::size_t i = 0; blurred && i < wavelengths.size(); ++i)
      if (i == 0 || merits[i] < plain.merit - cost || best > plain.merit)
        best = std::max(best, try_from(raw, wavelengths[i]));
    rank();
    // Where none comes up to what friction without it is worth, none nearby does.
    const bool promising = !found.empty() && better(found.front().first, plain);
    const auto for_the_best_two = [&](auto&& add_to) {
      std::vector<double> done;
      const std::size_t so_far = blurred && promising ? found.size() : 0;
      for (std::size_t i = 0; i < so_far && done.size() < 2; ++i) {
        const double wavelength = found[i].second;
        if (found[i].first.merit < found.front().first.merit - 40 ||
            std::find(done.begin(), done.end(), wavelength) != done.end())
          continue;
        done.push_back(wavelength);
        add_to(i, wavelength);
      }
      rank();
    };
    // From beside their wavelength: on soft rigs neighbouring peaks hide each other.
    for_the_best_two([&](std::size_t, double wavelength) {
      for (const double beside : {0.25, -0.25})
        found.emplace_back(tried(raw, raw.theta, elementary::log(wavelength * (1 + beside * wavelength / range))),
                           wavelength);
    });
    for_the_best_two([&](std::size_t i, double wavelength) {
      Mode mode = fitted_forward(process_, run_, found[i].first);
      process_.settle(mode);
      process_.burst(mode, 4, 0.3);
      process_.polish(mode, 1, 4, 0.3);
      found.emplace_back(std::move(mode), wavelength);
    });
    std::vector<Mode> polished;
    for (auto& each : found) {
      Mode& mode = each.first;
      // Where the best gains nothing, no other does.
      const bool gains = polished.empty() || polished.front().merit > plain.merit;
      if (polished.size() == 3 || !gains || mode.merit < found.front().first.merit - near_best) break;
      const bool known = std::any_of(polished.begin(), polished.end(), [&](const Mode& other) {
        return std::abs(mode.theta.log_wavelength(last) - other.theta.log_wavelength(last)) < 0.003 &&
               mode.merit < other.merit + 0.5;
      });
      if (known) continue;
      if (!std::isfinite(mode.merit)) break;
      const Mode before = mode;
      process_.polish(mode, polished.empty() ? 4 : 2, 8, 0.2);
      if (before.merit > mode.merit) mode = before;
      if (is_resolved(elementary::exp(mode.theta.log_wavelength(last)), mode.theta, last)) polished.push_back(mode);
    }
    std::stable_sort(polished.begin(), polished.end(), better);
    std::vector<Mode> different;
    for (auto& mode : polished)
      if (std::none_of(different.begin(), different.end(), [&](const Mode& other) {
            return std::abs(mode.theta.log_wavelength(last) - other.theta.log_wavelength(last)) < 0.002;
          }))
        different.push_back(std::move(mode));
    return different;
  }

  // Whether noise moves the place of a reading by as much as tells waves apart.
  bool is_blurred(const Mode& mode) const {
    std::vector<double> blur;
    const double noise = elementary::exp(mode.theta.values[Theta::log_noise]);
    for (const double by_force : mode.at.S_force) blur.push_back(0.5 * std::abs(by_force) * noise);
    return median_of(std::move(blur)) > process_.passages().range / 1000;
  }

  // The mode without a wave also from where the best with one ended.
  void improve(Mode& plain, const Mode& wave) const {
    Mode other = process_.start(plain.kernel, plain.theta, wave.at);
    other.sites = wave.sites;
    process_.polish(other, 2, 6, 0.3);
    if (other.merit > plain.merit + 0.1) plain = std::move(other);
  }

  Mode continued(const Mode& mode, Kernel kernel) const {
    if (kernel == mode.kernel) return mode;
    Mode other = mode;
    other.kernel = kernel;
    process_.polish(other, 2, 6, 0.3);
    if (kernel == Kernel::none &&
        mode.theta.waves > 0) {  // smooth friction has no roughness to make up for a wave too small
      Mode forward = fitted_forward(process_, run_, other);
      process_.burst(forward, 4, 0.3);
      process_.polish(forward, 3, 6, 0.3);
      if (forward.merit > other.merit) other = std::move(forward);
    }
    return other;
  }

  const FrictionProcess& process_;
  const SearchOptions& options_;
  Linearisation rises_;
  ForwardRun run_;
};

}  // namespace

ProcessSearch search(const FrictionProcess& process, const SearchOptions& options) {
  return Search(process, options).run();
}

}  // namespace flexslip
