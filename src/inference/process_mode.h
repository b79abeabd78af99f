// One mode of the posterior of friction along a fibre: hyperparameters and a linearisation that agree with each other.
//
// The posterior is approached by turns: at given hyperparameters the readings are linearised at the state fitted (Gauss-Newton) and the
// bounds of the gaps, over which the fibre jumped, are taken as Gaussians (expectation propagation); at a given linearisation the
// hyperparameters are moved uphill. What a mode is worth is its log_posterior, ln p(readings, gaps, hyperparameters).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "inference/chain.h"
#include "inference/first_passages.h"
#include "inference/theta.h"
#include "numerics/minimum.h"

namespace flexslip {

struct Mode {
  Kernel kernel;
  Theta theta;
  Linearisation at;
  std::vector<SkippedPoint> sites;
  double log_posterior;  // ln p(readings, gaps, θ)
};

struct Profile {
  Observations observations;
  std::vector<std::size_t> at;  // of the places, among the observations
};

// Columns of β in the order of a mode's observations. Waves come last.
struct ColumnPlaces {
  Eigen::Index mean = 0, drift = 1, stiffness = -1, rig = -1,
               waves = -1;  // -1: not there; those of the rig up to the waves
};

// The process of one record, whose readings it holds.
class FrictionProcess {
 public:
  // Domain:     at least 20 readings; std::invalid_argument otherwise.
  explicit FrictionProcess(Passages passages);

  // The same with what else is known of its columns but waves (rig_score_correction.h).
  FrictionProcess with_pull(const Coefficients& pull) const;

  const Passages& passages() const { return passages_; }
  const SearchOptions& options() const { return passages_.options; }
  const ColumnPlaces& columns() const { return columns_; }
  const ThetaPrior& prior_of_theta() const { return prior_of_theta_; }
  // [L] Four advances of a reading, at least range/readings, and 2π of what noise moves the place of a reading by.
  double min_wavelength() const { return min_wavelength_; }
  double max_wavelength() const { return passages_.range / options().max_wave_share; }  // [L]

  static Mode start(Kernel kernel, const Theta& theta, const Linearisation& at);

  // Gauss-Newton steps by a fraction of their length, the sites along; the log_posterior is that of the end.
  void burst(Mode& mode, int steps, double fraction) const;
  void burst(Mode& mode, const Schedule& schedule) const { burst(mode, schedule.steps, schedule.fraction); }

  // Rounds of moving the hyperparameters uphill and a burst.
  void polish(Mode& mode, const Schedule& schedule) const;

  // The observations of a mode, and what they say.
  Observations observations_of(const Mode& mode) const;
  // [1] The friction that each of them reads larger by ln EI, by one.
  std::vector<double> by_stiffness(const Mode& mode) const;
  // Where a place at which nothing is seen belongs among the columns.
  Coefficients columns_at(double place, const Mode& mode) const;
  // The observations of a mode with places between them at which nothing is seen.
  // Domain:     places not falling [L].
  Profile profile_of(const Mode& mode, std::span<const double> places) const;

  // ln p(θ) + ln p(readings, gaps | θ) at the linearisation and the sites of a mode, and its gradient in θ.
  // Domain:     observations are observations_of(mode); they are left with the waves of θ.
  struct Objective {
    double value;
    std::array<double, Theta::first_wave + max_waves> gradient;
  };
  Objective objective(const Mode& mode, Observations& observations, const Theta& theta) const;
  double objective_alone(const Mode& mode, Observations& observations, const Theta& theta) const;  // its value

  // Sites that agree with the observations; the log_posterior.
  void settle(Mode& mode) const;

  static constexpr double mean_friction = 0.55;   // expected beforehand, 0.5 its standard deviation
  static constexpr double wave_deviation = 0.08;  // [1] of a wave's cosine and sine beforehand
  // ln p(readings, gaps | θ) of a mode whose sites are settled, without the volume of the readings.
  double evidence(const Mode& mode) const {
    return mode.log_posterior - mode.at.log_jacobian - prior_of_theta_.log_density(mode.kernel, mode.theta);
  }

 private:
  struct Node {
    double S;
    double level;  // [1] the friction there is below it
  };
  std::vector<Node> nodes_of(const Mode& mode) const;
  // That beyond the gap; the last, where none is.
  std::size_t reading_of(const SkippedPoint& site) const { return std::min(site.reading, passages_.size() - 1); }
  double by_error(const RigError& error, std::size_t reading, double wave_slope) const;
  double by_errors_at(const Linearisation& at, std::size_t reading, double wave_slope) const;
  double bound_at(const Node& node, const SkippedPoint& site, const Mode& mode) const;
  Observations observations_of(const Mode& mode, const std::vector<Node>& nodes) const;
  void say_sites(const Mode& mode, const std::vector<Node>& nodes, Observations& observations) const;
  Coefficients columns_beside_waves(double place, std::size_t waves) const;
  void set_waves(const Theta& theta, Observations& observations) const;
  double by_moving_rig(const Mode& mode, const Chain& chain) const;
  double pass(Mode& mode, double fraction) const;
  void update_sites(Mode& mode, const std::vector<Node>& nodes, const Observations& observations,
                    const std::vector<SmoothedObservation>& smoothed) const;
  struct Slope {
    double all, waves;  // [1/L] dμ/dS of the friction fitted, and of its waves
  };
  std::vector<Slope> slopes_of(const Mode& mode, const Observations& observations, const Chain& chain,
                               const std::vector<SmoothedObservation>& smoothed) const;
  using ThetaVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, Theta::first_wave + max_waves, 1>;
  using ThetaMatrix = SquareOf<ThetaVector>;
  double longest_step(double log_wavelength) const;
  ThetaMatrix usual_spread(const Theta& theta) const;
  void maximise(Mode& mode, ThetaMatrix& spread, int iterations) const;

  Passages passages_;
  ColumnPlaces columns_;
  std::vector<double> prior_;  // of the columns but waves
  Coefficients pull_;          // on them; of no size: none
  double min_wavelength_;
  ThetaPrior prior_of_theta_{};
};

}  // namespace flexslip
