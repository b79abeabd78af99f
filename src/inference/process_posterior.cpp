#include "inference/process_posterior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include "inference/chain.h"
#include "inference/matern.h"
#include "inference/prior_draws.h"
#include "inference/profile.h"
#include "inference/rig_score_correction.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t hyperparameter_points = 8;
constexpr std::size_t profiles_drawn = 20;

double weight_of(const Component& component, const Component& best) {
  return elementary::exp(component.log_evidence - best.log_evidence);
}

// Standard normal points in mirrored pairs: a Kronecker sequence of the golden ratio of the
// dimension.
std::vector<VectorXd> normal_points(Index dimensions) {
  double golden = 1.5;  // golden^(dimensions + 1) = golden + 1
  for (int i = 0; i < 60; ++i)
    golden = elementary::exp(elementary::log(golden + 1) / static_cast<double>(dimensions + 1));
  std::vector<VectorXd> points;
  for (std::size_t i = 0; 2 * i < hyperparameter_points; ++i) {
    VectorXd z(dimensions);
    double power = 1;
    for (Index j = 0; j < dimensions; ++j) {
      power /= golden;
      const double turned = 0.5 + static_cast<double>(i + 1) * power;
      z[j] = elementary::gaussian_quantile(std::clamp(turned - std::floor(turned), 0.02, 0.98));
    }
    points.push_back(z);
    points.emplace_back(-z);
  }
  return points;
}

// The mean of μ over a segment as a functional of a chain: its coefficients, and its covariance
// with g at each observation.
struct MeanFunctional {
  Coefficients a;
  std::vector<double> covariance;
  double variance;
};

MeanFunctional mean_over(double from, double to, const FrictionProcess& process, const Mode& mode,
                         const Observations& observations) {
  MeanFunctional f{.a = process.columns_at(0.5 * (from + to), mode), .covariance = {}, .variance = 0};
  for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
    const double rate = 2 * std::numbers::pi * elementary::exp(-mode.theta.log_wavelength(wave));
    const auto begin = elementary::sine_and_cosine(rate * from), end = elementary::sine_and_cosine(rate * to);
    const Index at = process.columns().waves + 2 * static_cast<Index>(wave);
    f.a[at] = (end.sine - begin.sine) / (rate * (to - from));
    f.a[at + 1] = (begin.cosine - end.cosine) / (rate * (to - from));
  }
  const auto p = hyperparameters_of(mode.theta);
  const double rate = mode.kernel == Kernel::none ? 0 : matern::rate_of(mode.kernel) / p.length;
  const double variance = p.roughness * p.roughness;
  for (const auto& observation : observations.all) {
    if (mode.kernel == Kernel::none) {
      f.covariance.push_back(0);
      continue;
    }
    // Distances from the observation to both ends; negative outside.
    const auto to_end = [&](double distance) {
      return std::copysign(matern::integrals_to(rate * std::abs(distance), mode.kernel).of_kernel, distance);
    };
    f.covariance.push_back(variance * (to_end(observation.place - from) + to_end(to - observation.place)) /
                           (rate * (to - from)));
  }
  if (mode.kernel != Kernel::none) {
    const double R = rate * (to - from);
    f.variance = 2 * variance * matern::integrals_to(R, mode.kernel).of_tapered / (R * R);
  }
  return f;
}

// A component at one point of its hyperparameters.
struct Point {
  Mode mode;
  double log_weight;
};

std::vector<Point> points_of(const FrictionProcess& process, const Component& component) {
  const MatrixXd L = cholesky_root(component.spread);
  std::vector<Point> points;
  if (!process.options().parts.hyperparameter_points) return {{component.mode, 0}};
  for (const auto& z : normal_points(L.rows())) {
    Point point{component.mode, 0};
    const VectorXd step = L * z;
    double squares = 0;
    for (Index j = 0; j < z.size(); ++j) {
      const bool free = !(component.mode.kernel == Kernel::none && (j == 2 || j == 3));
      if (!free) continue;
      point.mode.theta.values[static_cast<std::size_t>(j)] += step[j];
      squares += z[j] * z[j];
    }
    process.prior_of_theta().bound(point.mode.theta);
    process.settle(point.mode);
    point.log_weight = point.mode.log_posterior - component.mode.log_posterior + 0.5 * squares;
    // Skip points much more probable than the mode, at which the iteration diverged, and points far
    // below it.
    constexpr double at_most = 12, at_least = -50;
    if (point.log_weight < at_most && point.log_weight > at_least) points.push_back(std::move(point));
  }
  if (points.empty()) points.push_back({component.mode, 0});
  return points;
}

// ln of the weights, each limited to four times the mean because the tails have few points.
void temper(std::vector<Point>& points) {
  double greatest = -infinity, mean = 0;
  for (const auto& point : points) greatest = std::max(greatest, point.log_weight);
  for (const auto& point : points)
    mean += elementary::exp(point.log_weight - greatest) / static_cast<double>(points.size());
  const double most = greatest + elementary::log(4 * mean);
  for (auto& point : points) point.log_weight = std::min(point.log_weight, most);
}

bool is_rough(const Component& component) { return component.mode.kernel != Kernel::none; }

class Posterior {
 public:
  // Rough explanations use the second process, which includes the pull.
  Posterior(const FrictionProcess& process, const FrictionProcess& of_roughness, std::span<const Component> components)
      : process_(process), o_(process.options()), of_roughness_(of_roughness), components_(components) {
    const auto& S = components.front().mode.at.S;
    result_.S_begin = S.front();
    const auto& stuck = process.passages().stuck;
    result_.S_end = stuck.empty() ? S.back() : std::max(S.back(), stuck.back().S);
    from_ = process.passages().place(result_.S_begin);
    to_ = process.passages().place(result_.S_end);
  }

  ProcessPosterior result() {
    list_explanations();
    list_innovations();
    list_sensitivities();
    for (const auto& component : components_) add(component);
    std::copy_if(waves_.begin(), waves_.end(), std::back_inserter(result_.waves),
                 [](const WavePosterior& wave) { return !wave.draws.empty(); });
    result_.noise_correlation = hyperparameters_of(components_.front().mode.theta).correlation;
    add_profiles();
    return std::move(result_);
  }

 private:
  void list_explanations() {
    double total = 0;
    for (const auto& component : components_) total += weight_of(component, components_.front());
    for (const auto& component : components_) {
      const auto& theta = component.mode.theta;
      std::vector<double> wavelengths;
      for (std::size_t wave = 0; wave < theta.waves; ++wave)
        wavelengths.push_back(elementary::exp(theta.log_wavelength(wave)));
      result_.explanations.push_back({.kernel = component.mode.kernel,
                                      .wavelengths = std::move(wavelengths),
                                      .log_evidence = component.log_evidence,
                                      .log_likelihood = log_likelihood_of(component.mode),
                                      .weight = weight_of(component, components_.front()) / total});
    }
    const Component* const with = best_of(has_waves);
    const Component* const without = best_of([](const Component& each) { return !has_waves(each); });
    if (!with || !without) return;
    double sum_with = 0, sum_without = 0;
    for (const auto& component : components_)
      (has_waves(component) ? sum_with : sum_without) += weight_of(component, has_waves(component) ? *with : *without);
    result_.carried_by_readings = carried_by_readings(with->mode);
    result_.log_evidence_of_wave = with->log_evidence - without->log_evidence + elementary::log(sum_with / sum_without);
  }

  // The limit of the gain by waves: their gain over friction that is independent at each reading. A
  // larger gain means that an explanation without waves was missed.
  double carried_by_readings(const Mode& mode) const {
    const Observations observations = process_for(mode).observations_of(mode);
    const auto p = hyperparameters_of(mode.theta);
    const Coefficients beta = Chain(observations, mode.kernel, p).mean();
    const double squares = beta.tail(2 * static_cast<Index>(mode.theta.waves)).squaredNorm();
    double gain = 0;
    for (const Observation& each : observations.all) {
      if (!each.is_reading()) continue;
      const double noise = elementary::length(each.noise_gain * p.noise, nugget);
      gain += 0.5 * elementary::log(1 + 0.5 * squares / (noise * noise));
    }
    return gain;
  }

  // ln p(readings, gaps) at the hyperparameters and waves of a mode, integrated over all else.
  double log_likelihood_of(const Mode& mode) const {
    const double value = process_.evidence(mode) + mode.at.log_jacobian;
    const auto waves = 2 * static_cast<Index>(mode.theta.waves);
    if (waves == 0) return value;
    Observations observations = process_for(mode).observations_of(mode);
    observations.pull = {};
    const Chain chain(observations, mode.kernel, hyperparameters_of(mode.theta));
    const Index first = process_.columns().waves;
    // p(y | β) = p(y) p(β | y)/p(β), at the mean of β.
    double of_waves = 0;
    for (Index j = first; j < first + waves; ++j) {
      const double beta = chain.mean()[j], prior = observations.prior[static_cast<std::size_t>(j)];
      of_waves += 0.5 * (beta * beta / prior + elementary::log(prior));
    }
    const MatrixXd L = cholesky_root(chain.covariance().block(first, first, waves, waves));
    for (Index j = 0; j < waves; ++j) of_waves -= elementary::log(L(j, j));
    return value + of_waves;
  }

  void list_innovations() {
    const Mode& mode = components_.front().mode;
    const Observations observations = process_for(mode).observations_of(mode);
    const Chain chain(observations, mode.kernel, hyperparameters_of(mode.theta));
    const auto white = chain.whitened_columns();
    const VectorXd rest =
        white.row(white.rows() - 1).transpose() - white.topRows(white.rows() - 1).transpose() * chain.mean();
    for (std::size_t k = 0; k < observations.all.size(); ++k)
      if (observations.all[k].is_reading()) result_.innovations.push_back(rest[static_cast<Index>(k)]);
  }

  // Averaged over the relevant explanations by weight.
  void list_sensitivities() {
    constexpr double worth_asking = 0.05;  // of the most probable
    double total = 0;
    for (const auto& component : components_)
      if (const double weight = weight_of(component, components_.front()); weight >= worth_asking) total += weight;
    for (const auto& component : components_)
      if (const double weight = weight_of(component, components_.front()); weight >= worth_asking)
        add_sensitivities(component.mode, weight / total);
  }

  // A larger stated value is subtracted from the readings, at the hyperparameters of a mode except
  // the wavelengths, which scale with the places.
  void add_sensitivities(const Mode& mode, double weight) {
    const Observations observations = process_for(mode).observations_of(mode);
    const auto f = mean_over(from_, to_, process_for(mode), mode, observations);
    const Coefficients beta = Chain(observations, mode.kernel, hyperparameters_of(mode.theta)).mean();
    const Index stiffness = process_.columns().stiffness;
    struct Told {
      VectorXd whitened;     // the readings
      VectorXd unexplained;  // their residuals
      double mean, log_stiffness;
    };
    const auto told_by = [&](std::vector<double> read) {
      Observations instead = observations;
      instead.values = std::move(read);
      instead.pull = {};  // independent of the readings
      const Chain chain(instead, mode.kernel, hyperparameters_of(mode.theta));
      const auto white = chain.whitened_columns();
      return Told{.whitened = white.row(white.rows() - 1).transpose(),
                  .unexplained = white.row(white.rows() - 1).transpose() -
                                 white.topRows(white.rows() - 1).transpose() * chain.mean(),
                  .mean = chain.functional(f.a, f.covariance, f.variance).mean,
                  .log_stiffness = stiffness >= 0 ? chain.mean()[stiffness] : 0};
    };
    std::vector<Told> longer;  // per unit of ln λ of each wave, orthogonal to the previous ones
    const auto less_longer = [&](Told told) {
      for (const Told& wave : longer) {
        constexpr double prior = 1;  // of ln λ, for waves of zero amplitude
        const double times = wave.whitened.dot(told.unexplained) / (wave.whitened.dot(wave.unexplained) + prior);
        told.whitened -= times * wave.whitened;
        told.unexplained -= times * wave.unexplained;
        told.mean -= times * wave.mean;
        told.log_stiffness -= times * wave.log_stiffness;
      }
      return told;
    };
    for (std::size_t wave = 0; wave < mode.theta.waves; ++wave) {
      const double rate = 2 * std::numbers::pi * elementary::exp(-mode.theta.log_wavelength(wave));
      const Index at = process_.columns().waves + 2 * static_cast<Index>(wave);
      std::vector<double> read;
      for (const Observation& observation : observations.all) {
        const double angle = rate * observation.place;
        const auto [sine, cosine] = elementary::sine_and_cosine(angle);
        read.push_back(angle * (beta[at] * sine - beta[at + 1] * cosine));
      }
      longer.push_back(less_longer(told_by(std::move(read))));
    }
    for (const StatedQuantity quantity : stated_quantities) {
      const RigError& error = process_.passages().quantities[quantity];
      std::vector<double> read;
      std::size_t reading = 0, site = 0;
      for (const Observation& observation : observations.all) {
        const bool is_reading = observation.is_reading();
        const double wave_slope = is_reading ? mode.at.wave_slope[reading] : mode.sites[site].wave_slope;
        read.push_back(-(error.friction[reading] + wave_slope * error.place[reading]));
        ++(is_reading ? reading : site);
      }
      const Told told = less_longer(told_by(std::move(read)));
      result_.friction_by[quantity] += weight * told.mean;
      result_.log_stiffness_by[quantity] += weight * told.log_stiffness;
    }
  }

  static bool has_waves(const Component& component) { return component.mode.theta.waves > 0; }

  // The most probable of a kind; null without any.
  template <class Kind>
  const Component* best_of(Kind kind) const {
    const auto best = std::find_if(components_.begin(), components_.end(), kind);
    return best == components_.end() ? nullptr : &*best;
  }

  // The weight of a component among its kind; 0 if negligible.
  template <class Kind>
  double weight_among(const Component& component, Kind kind) const {
    if (!kind(component)) return 0;
    const double weight = weight_of(component, *best_of(kind));
    return weight > elementary::exp(-o_.weighs_nothing) ? weight : 0;
  }

  // Waves are averaged over components with waves, roughness over rough components, regardless of
  // their total weight.
  void add(const Component& component) {
    const double weight = weight_among(component, [](const Component&) { return true; });
    const double of_waves = weight_among(component, has_waves), of_roughness = weight_among(component, is_rough);
    if (weight == 0 && of_waves == 0 && of_roughness == 0) return;
    auto points = points_of(process_for(component.mode), component);
    temper(points);
    const auto& columns = process_.columns();
    for (const auto& point : points) {
      const Mode& mode = point.mode;
      const double share =
          elementary::exp(std::clamp(point.log_weight, -50.0, 3.0)) / static_cast<double>(points.size());
      const Observations observations = process_for(mode).observations_of(mode);
      const Chain chain(observations, mode.kernel, hyperparameters_of(mode.theta));
      const auto f = mean_over(from_, to_, process_for(mode), mode, observations);
      const auto mean = chain.functional(f.a, f.covariance, f.variance);
      if (of_waves > 0) draw_waves(component, mode, chain, mean, of_waves * share);
      if (weight == 0) continue;
      result_.joint.push_back(joint_part(mode, chain, mean, weight * share));
      const double deviation = std::sqrt(std::max(mean.variance, 0.0));
      result_.mean.push_back({weight * share, FrictionProcess::mean_friction + mean.mean, deviation});
      const auto of_beta = [&](Index j, double factor, double shift) {
        return NormalPart{weight * share, shift + factor * chain.mean()[j],
                          factor * std::sqrt(chain.covariance()(j, j))};
      };
      result_.drift.push_back(of_beta(columns.drift, process_.passages().share / process_.passages().range, 0));
      result_.log_stiffness.push_back(columns.stiffness >= 0 ? of_beta(columns.stiffness, 1, 0)
                                                             : NormalPart{weight * share, 0, 0});
    }
    // Moments of the points, because the logarithms are skewed about the mode.
    const auto of_theta = [&](std::size_t j, double part) {
      double total = 0, mean = 0, squares = 0;
      for (const auto& point : points) total += elementary::exp(point.log_weight);
      for (const auto& point : points) mean += elementary::exp(point.log_weight) * point.mode.theta.values[j] / total;
      for (const auto& point : points) {
        const double away = point.mode.theta.values[j] - mean;
        squares += elementary::exp(point.log_weight) * away * away / total;
      }
      const auto at = static_cast<Index>(j);
      return NormalPart{part, mean, std::sqrt(std::max(squares, component.spread(at, at)))};
    };
    if (weight > 0) result_.log_noise.push_back(of_theta(0, weight));
    if (of_roughness == 0) return;
    result_.log_roughness.push_back(of_theta(2, of_roughness));
    result_.log_length.push_back(of_theta(3, of_roughness));
  }

  // The columns of trend and stiffness, with the factors that give the parameters.
  struct ToldCoefficient {
    JointPart::Parameter parameter;
    Index at;
    double factor;
  };
  std::vector<ToldCoefficient> told_by_coefficients() const {
    const auto& columns = process_.columns();
    std::vector<ToldCoefficient> told{
        {JointPart::drift, columns.drift, process_.passages().share / process_.passages().range}};
    if (columns.stiffness >= 0) told.push_back({JointPart::bending_stiffness, columns.stiffness, 1});
    return told;
  }

  JointPart joint_part(const Mode& mode, const Chain& chain, const Chain::Functional& friction, double weight) const {
    JointPart part{weight, {}};
    part.value.fill(not_a_number);
    part.value[JointPart::mu0] = FrictionProcess::mean_friction + friction.mean;
    part.covariance[JointPart::mu0][JointPart::mu0] = std::max(friction.variance, 0.0);
    const auto told = told_by_coefficients();
    for (const auto& [parameter, at, factor] : told) {
      part.value[parameter] = factor * chain.mean()[at];
      auto& with_friction = part.covariance[JointPart::mu0][parameter];
      with_friction = part.covariance[parameter][JointPart::mu0] = factor * friction.with_beta[at];
      for (const ToldCoefficient& other : told)
        part.covariance[parameter][other.parameter] = factor * other.factor * chain.covariance()(at, other.at);
    }
    if (mode.kernel == Kernel::none) return part;
    part.value[JointPart::roughness] = mode.theta.values[Theta::log_roughness];
    part.value[JointPart::correlation_length] = mode.theta.values[Theta::log_length];
    return part;
  }

  // Other wavelengths are separate explanations, not part of this one's error.
  bool is_likeliest(const Mode& mode, std::size_t wave) const {
    const Mode& best = best_of(has_waves)->mode;
    if (mode.theta.waves != best.theta.waves) return false;
    const double log_wavelength = best.theta.log_wavelength(wave);
    return std::abs(mode.theta.log_wavelength(wave) - log_wavelength) <= same_wave(log_wavelength);
  }

  // Half of the resolution of wavelengths over the observed length.
  double same_wave(double log_wavelength) const {
    return 0.5 * elementary::exp(log_wavelength) / process_.passages().range;
  }

  // The spread of a wavelength between modes with the same wave, regardless of weight. It exceeds
  // the curvature at one linearisation.
  double scatter_of(const Component& component, std::size_t wave) const {
    const double log_wavelength = component.mode.theta.log_wavelength(wave);
    if (!o_.parts.scatter) return 0;
    const double same = same_wave(log_wavelength);
    double squares = 0;
    int others = 0;
    for (const auto& other : components_) {
      if (other.mode.theta.waves <= wave) continue;
      const double away = other.mode.theta.log_wavelength(wave) - log_wavelength;
      if (&other == &component || std::abs(away) > same) continue;
      squares += away * away;
      ++others;
    }
    return others > 0 ? std::sqrt(squares / others) : 0;
  }

  void draw_waves(const Component& component, const Mode& mode, const Chain& chain, const Chain::Functional& mean,
                  double weight) {
    constexpr int draws = 60;
    const Index first = process_.columns().waves;
    const auto waves = static_cast<Index>(mode.theta.waves);
    // Mean, cosine and sine of each wave, then the other parameters.
    const auto told = told_by_coefficients();
    const Index of_waves = 1 + 2 * waves, all = of_waves + static_cast<Index>(told.size());
    MatrixXd covariance(all, all);
    covariance(0, 0) = std::max(mean.variance, 1e-12);
    VectorXd middle(all);
    middle[0] = FrictionProcess::mean_friction + mean.mean;
    for (Index j = 0; j < 2 * waves; ++j) {
      middle[1 + j] = chain.mean()[first + j];
      covariance(0, 1 + j) = covariance(1 + j, 0) = mean.with_beta[first + j];
    }
    covariance.block(1, 1, 2 * waves, 2 * waves) = chain.covariance().block(first, first, 2 * waves, 2 * waves);
    for (Index i = of_waves; i < all; ++i) {
      const auto& [parameter, at, factor] = told[static_cast<std::size_t>(i - of_waves)];
      middle[i] = factor * chain.mean()[at];
      covariance(0, i) = covariance(i, 0) = factor * mean.with_beta[at];
      for (Index j = 0; j < 2 * waves; ++j)
        covariance(1 + j, i) = covariance(i, 1 + j) = factor * chain.covariance()(at, first + j);
      for (Index j = of_waves; j < all; ++j) {
        const ToldCoefficient& other = told[static_cast<std::size_t>(j - of_waves)];
        covariance(i, j) = factor * other.factor * chain.covariance()(at, other.at);
      }
    }
    JointPart beside = joint_part(mode, chain, mean, weight);
    beside.covariance = {};
    const MatrixXd root = cholesky_root(covariance);
    std::array<double, max_waves> deviation{};
    for (std::size_t wave = 0; wave < mode.theta.waves; ++wave)
      deviation[wave] = elementary::length(component.wavelength_deviation[wave], scatter_of(component, wave));
    for (int i = 0; i < draws; ++i) {
      VectorXd z(all);
      for (Index j = 0; j < all; ++j) z[j] = j < of_waves ? normal_() : normal_beside_();
      const VectorXd drawn = middle + root * z;
      beside.value[JointPart::mu0] = drawn[0];
      for (Index j = of_waves; j < all; ++j)
        beside.value[told[static_cast<std::size_t>(j - of_waves)].parameter] = drawn[j];
      for (Index wave = 0; wave < waves; ++wave) {
        if (!is_likeliest(mode, static_cast<std::size_t>(wave))) continue;
        auto& posterior = waves_[static_cast<std::size_t>(wave)];
        if (posterior.draws.empty())
          posterior.log_wavelength = component.mode.theta.log_wavelength(static_cast<std::size_t>(wave));
        const double log_wavelength = component.mode.theta.log_wavelength(static_cast<std::size_t>(wave)) +
                                      deviation[static_cast<std::size_t>(wave)] * normal_();
        const double longer = log_wavelength - component.mode.theta.log_wavelength(static_cast<std::size_t>(wave));
        const auto turn = elementary::sine_and_cosine(component.turn[static_cast<std::size_t>(wave)] * longer);
        const double cosine = drawn[1 + 2 * wave], sine = drawn[2 + 2 * wave];
        posterior.draws.push_back({weight, log_wavelength, turn.cosine * cosine - turn.sine * sine,
                                   turn.sine * cosine + turn.cosine * sine, drawn[0], beside});
      }
    }
  }

  void add_profiles() {
    std::vector<double> places;
    auto& band = result_.band;
    const std::size_t profile_points = points_of_profile();
    for (std::size_t i = 0; i < profile_points; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(profile_points - 1);
      places.push_back(from_ + part * (to_ - from_));
      band.S.push_back(process_.passages().sliding_length_at(places.back()));
    }
    band.mean.assign(profile_points, 0);
    band.deviation.assign(profile_points, 0);
    double total = 0;
    for (const auto& component : components_)
      if (weighs(component)) total += weight_of(component, components_.front());
    std::vector<double> squares(profile_points, 0);
    result_.rig.assign(process_.passages().rig_errors.size(), 0);
    double passed = 0;
    for (const auto& component : components_) {
      if (!weighs(component)) continue;
      const double weight = weight_of(component, components_.front()) / total;
      const Mode& mode = component.mode;
      const auto p = hyperparameters_of(mode.theta);
      Profile profile = process_for(mode).profile_of(mode, places);
      const Chain chain(profile.observations, mode.kernel, p);
      const auto smoothed = chain.smoothed();
      for (std::size_t r = 0; r < result_.rig.size(); ++r)
        result_.rig[r] += weight * chain.mean()[process_.columns().rig + static_cast<Index>(r)];
      for (std::size_t i = 0; i < profile_points; ++i) {
        const auto& at = smoothed[profile.at[i]];
        const double mu = FrictionProcess::mean_friction + at.f;
        band.mean[i] += weight * mu;
        squares[i] += weight * (mu * mu + at.variance);
      }
      const double until = passed + weight * profiles_drawn;
      const PriorDraws beforehand(profile.observations, mode.kernel, p);
      while (static_cast<double>(result_.draws.size()) + 0.5 < until) draw_profile(beforehand, profile, chain);
      passed = until;
    }
    for (std::size_t i = 0; i < profile_points; ++i)
      band.deviation[i] = std::sqrt(std::max(squares[i] - band.mean[i] * band.mean[i], 0.0));
    result_.profile = table_of(band.mean);
  }

  // Enough points for smooth waves and for the folds of the simulation.
  std::size_t points_of_profile() const {
    double finest = process_.passages().range / 10;
    for (const auto& component : components_) {
      if (!weighs(component)) continue;
      for (std::size_t wave = 0; wave < component.mode.theta.waves; ++wave)
        finest = std::min(finest, elementary::exp(component.mode.theta.log_wavelength(wave)) / 2);
      if (component.mode.kernel != Kernel::none)
        finest = std::min(finest, hyperparameters_of(component.mode.theta).length);
    }
    constexpr double for_each = 10, least = 240, most = 1000;
    return static_cast<std::size_t>(std::clamp(for_each * (to_ - from_) / finest, least, most));
  }

  bool weighs(const Component& component) const {
    return component.log_evidence > components_.front().log_evidence - o_.weighs_nothing;
  }

  FrictionTable table_of(const std::vector<double>& mu) const {
    FrictionTable table{result_.band.S, mu};
    for (double& value : table.mu) value = held_friction(process_.passages().fibre, value);
    return table;
  }

  // A prior sample, shifted to agree with the observations (Matheron).
  void draw_profile(const PriorDraws& beforehand, const Profile& profile, const Chain& chain) {
    const Drawn drawn = beforehand(normal_);
    std::vector<double> rest = profile.observations.values;
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] -= drawn.values[k];
    const auto moved = chain.means_of(rest);
    std::vector<double> mu;
    for (const std::size_t k : profile.at) mu.push_back(FrictionProcess::mean_friction + drawn.f[k] + moved.f[k]);
    result_.draws.push_back(table_of(mu));
    const Index stiffness = process_.columns().stiffness;
    const double eta = stiffness >= 0 ? drawn.beta[stiffness] + moved.beta[stiffness] : 0;
    result_.draw_stiffness.push_back(elementary::exp(eta));
  }

  const FrictionProcess& process_for(const Mode& mode) const {
    return mode.kernel == Kernel::none ? process_ : of_roughness_;
  }

  const FrictionProcess& process_;
  const SearchOptions& o_;
  const FrictionProcess& of_roughness_;
  std::span<const Component> components_;
  double from_, to_;
  std::array<WavePosterior, max_waves> waves_{};  // of the most probable explanation with waves
  ProcessPosterior result_{};
  NormalSource normal_{20210829}, normal_beside_{20210830};
};

}  // namespace

ProcessPosterior posterior_of(const FrictionProcess& process, std::span<const Component> components) {
  // If the most probable explanation is smooth, the pull is negligible.
  const SearchOptions& o = process.options();
  if (!o.parts.rig_score_correction || !is_rough(components.front()))
    return Posterior(process, process, components).result();
  const FrictionProcess pulled = process.with_pull(rig_score_correction(process, components.front().mode));
  std::vector<Component> all(components.begin(), components.end());
  for (Component& each : all) {
    if (!is_rough(each) || !(weight_of(each, components.front()) > elementary::exp(-o.weighs_nothing))) continue;
    Mode moved = each.mode;
    pulled.settle(each.mode);
    pulled.burst(moved, o.settle);
    // If the bending stiffness diverges or nothing slides, keep the mode and shift its means to
    // first order.
    const double away = std::abs(moved.at.eta - each.mode.at.eta);
    if (away <= o.pull_farthest * process.passages().stiffness_error &&
        moved.log_posterior > each.mode.log_posterior - o.ran_away && has_slid(moved.at))
      each.mode = std::move(moved);
  }
  return Posterior(process, pulled, all).result();
}

}  // namespace flexslip
