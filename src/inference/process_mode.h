// One mode of the posterior of friction along a fibre: hyperparameters and linearisation that agree with each other.
//
// The posterior is approached by turns: at given hyperparameters the readings are linearised at the state fitted (Gauss-Newton) and the
// bounds of the gaps, over which the fibre jumped, are taken as Gaussians (expectation propagation); at a given linearisation the
// hyperparameters are moved uphill. What a mode is worth is its merit, ln p(readings, gaps, hyperparameters).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "inference/chain.h"
#include "inference/first_passages.h"

namespace flexslip {

inline constexpr std::size_t most_waves = 2;

// ln σ, logit ρ/0.95, ln σ_g, ln ℓ, then ln λ of each wave.
struct Theta {
  std::array<double, 4 + most_waves> values;
  std::size_t waves = 0;

  std::size_t size() const { return 4 + waves; }
  double log_wavelength(std::size_t wave) const { return values[4 + wave]; }
};

Hyperparameters hyperparameters_of(const Theta& theta);

// What a place in a gap, where friction must have been below a bound, is taken for: a Gaussian of the slack between the two.
struct GapSite {
  std::size_t reading;        // the first beyond the gap
  std::size_t node, nodes;    // which of how many
  double precision = 0;       // [1]
  double precision_mean = 0;  // [1]
  double slope = 0;           // [1/L] dμ/dS of the friction fitted
};

struct Mode {
  Kernel kernel;
  Theta theta;
  Linearisation at;
  std::vector<GapSite> sites;
  double merit;  // ln p(readings, gaps, θ)
};

struct Profile {
  Looks looks;
  std::vector<std::size_t> at;  // of the places, among the looks
};

// Columns of β in the order of a mode's looks. Waves come last.
struct ColumnPlaces {
  Eigen::Index mean = 0, drift = 1, stiffness = -1, contact = -1, waves = -1;  // -1: not there
};

// The process of one record, whose readings it holds.
class FrictionProcess {
 public:
  // Domain:     at least 20 readings; std::invalid_argument otherwise.
  explicit FrictionProcess(Passages passages);

  const Passages& passages() const { return passages_; }
  const ColumnPlaces& columns() const { return columns_; }
  double least_wavelength() const { return least_wavelength_; }         // [L] four advances of a reading
  double greatest_wavelength() const { return passages_.range / 2.2; }  // [L]

  // Usual hyperparameters, for a start.
  Theta usual(std::span<const double> log_wavelengths = {}) const;
  static Mode start(Kernel kernel, const Theta& theta, const Linearisation& at);

  // Gauss-Newton steps by a fraction of their length, the sites along; the merit is that of the end.
  void burst(Mode& mode, int steps, double fraction) const;

  // Rounds of moving the hyperparameters uphill and a burst.
  void polish(Mode& mode, int rounds, int steps, double fraction) const;

  // The looks of a mode, and what they say.
  Looks looks_of(const Mode& mode) const;
  // Where a place at which nothing is seen belongs among the columns.
  Coefficients columns_at(double place, const Mode& mode) const;
  // The looks of a mode with places between them at which nothing is seen.
  // Domain:     places not falling [L].
  Profile profile_of(const Mode& mode, std::span<const double> places) const;

  // ln p(θ) + ln p(readings, gaps | θ) at the linearisation and the sites of a mode, and its gradient in θ.
  // Domain:     looks are looks_of(mode); they are left with the waves of θ.
  struct Objective {
    double value;
    std::array<double, 4 + most_waves> gradient;
  };
  Objective objective(const Mode& mode, Looks& looks, const Theta& theta) const;

  // Into the bounds within which hyperparameters are sought.
  void bound(Theta& theta) const;

  // Sites that agree with the looks; the merit.
  void settle(Mode& mode) const;

  static constexpr double mean_friction = 0.55;   // expected beforehand, 0.5 its standard deviation
  static constexpr double wave_deviation = 0.08;  // [1] of a wave's cosine and sine beforehand
  // ln p(readings, gaps | θ) of a mode whose sites are settled, without the volume of the readings.
  double evidence(const Mode& mode) const { return mode.merit - mode.at.log_jacobian - log_prior(mode, mode.theta); }
  double expected_stiffness(const Mode& mode) const;  // of ln EI/nominal beforehand
  struct NormalPrior {
    double mean, deviation;
  };
  NormalPrior prior_of(std::size_t hyperparameter) const {
    return {theta_mean_[hyperparameter], theta_deviation_[hyperparameter]};
  }
  double log_prior_scale(Kernel kernel) const;  // what makes exp of the prior of θ in a merit a density

 private:
  struct Node {
    double S;
    Level level;
    double by_stiffness;  // [1] d/dη of the slack, the node going with its gap
  };
  std::vector<Node> nodes_of(const Mode& mode) const;
  double bound_at(const Node& node, const Mode& mode) const;
  Looks looks_of(const Mode& mode, const std::vector<Node>& nodes) const;
  void say_sites(const Mode& mode, const std::vector<Node>& nodes, Looks& looks) const;
  void set_waves(const Theta& theta, double place, Coefficients& h) const;
  void lay_sites(Mode& mode) const;
  double by_moving_stiffness(const Mode& mode, const Chain& chain) const;
  double pass(Mode& mode, double fraction) const;
  void update_sites(Mode& mode, const std::vector<Node>& nodes, const Looks& looks,
                    const std::vector<SmoothedLook>& smoothed) const;
  std::vector<double> slopes_of(const Mode& mode, const Looks& looks, const Chain& chain,
                                const std::vector<SmoothedLook>& smoothed) const;
  Looks at_its_stiffness(const Mode& mode) const;
  Mode stiffer(const Mode& mode, double step, std::span<const double> slope_by_eta) const;
  void update_jacobian(Mode& mode) const;
  Looks near_its_stiffness(Looks looks, const Mode& mode) const;
  void maximise(Mode& mode, int iterations) const;
  double log_prior(const Mode& mode, const Theta& theta) const;

  Passages passages_;
  ColumnPlaces columns_;
  std::vector<double> prior_;  // of the columns but waves
  double least_wavelength_;
  std::array<double, 4> theta_mean_, theta_deviation_, theta_least_, theta_greatest_;
};

}  // namespace flexslip
