// One mode of the posterior of friction along the specimen: hyperparameters and a linearisation
// consistent with each other.
//
// Two steps alternate. At given hyperparameters, the readings are linearised at the fitted state
// (Gauss-Newton) and the bounds in skipped segments are approximated by Gaussians (expectation
// propagation). At a given linearisation, the hyperparameters are optimised. A mode is rated by its
// log_posterior, ln p(readings, gaps, hyperparameters).
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
  std::vector<std::size_t> at;  // indices of the places among the observations
};

// The first column of each kind in a mode's observations; -1 if there is none. Waves come last.
struct ColumnPlaces {
  Eigen::Index mean = 0, drift = 1, stiffness = -1, rig = -1, waves = -1;
};

// The process of friction for the readings of one record.
class FrictionProcess {
 public:
  // Domain:     at least 20 readings; std::invalid_argument otherwise.
  explicit FrictionProcess(Passages passages);

  // The same process with further information on its columns (rig_score_correction.h).
  FrictionProcess with_pull(const Coefficients& pull) const;

  const Passages& passages() const { return passages_; }
  const SearchOptions& options() const { return passages_.options; }
  const ColumnPlaces& columns() const { return columns_; }
  const ThetaPrior& prior_of_theta() const { return prior_of_theta_; }
  // [L] The larger of four advances of a reading and 2π times the error of its place; at least
  // range/readings.
  double min_wavelength() const { return min_wavelength_; }
  double max_wavelength() const { return passages_.range / options().max_wave_share; }  // [L]

  static Mode start(Kernel kernel, const Theta& theta, const Linearisation& at);

  // Takes damped Gauss-Newton steps, with updates of the skipped points, and sets the
  // log_posterior.
  void burst(Mode& mode, int steps, double fraction) const;
  void burst(Mode& mode, const Schedule& schedule) const { burst(mode, schedule.steps, schedule.fraction); }

  // Alternates optimising the hyperparameters with a burst.
  void polish(Mode& mode, const Schedule& schedule) const;

  // The observations of a mode.
  Observations observations_of(const Mode& mode) const;
  // [1] The derivative of each of them in ln EI.
  std::vector<double> by_stiffness(const Mode& mode) const;
  // The columns h of an unobserved place.
  Coefficients columns_at(double place, const Mode& mode) const;
  // The observations of a mode together with unobserved places.
  // Domain:     places in non-decreasing order [L].
  Profile profile_of(const Mode& mode, std::span<const double> places) const;

  // ln p(θ) + ln p(readings, gaps | θ) at the linearisation and the sites of a mode, and its
  // gradient in θ.
  // Domain:     observations are observations_of(mode); afterwards they have the waves of θ.
  struct Objective {
    double value;
    std::array<double, Theta::first_wave + max_waves> gradient;
  };
  Objective objective(const Mode& mode, Observations& observations, const Theta& theta) const;
  double objective_alone(const Mode& mode, Observations& observations, const Theta& theta) const;  // its value

  // Makes the skipped points consistent with the observations, and sets the log_posterior.
  void settle(Mode& mode) const;

  static constexpr double mean_friction = 0.55;   // prior mean; the standard deviation is 0.5
  static constexpr double wave_deviation = 0.08;  // [1] prior standard deviation of a wave's cosine and sine
  // ln p(readings, gaps | θ) of a settled mode, without the volume of the readings.
  double evidence(const Mode& mode) const {
    return mode.log_posterior - mode.at.log_jacobian - prior_of_theta_.log_density(mode.kernel, mode.theta);
  }

 private:
  struct Node {
    double S;
    double level;  // [1] upper bound of friction
  };
  std::vector<Node> nodes_of(const Mode& mode) const;
  // The reading beyond the segment, or the last one.
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
    double all, waves;  // [1/L] dμ/dS of the fitted friction, and of its waves
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
  std::vector<double> prior_;  // of the columns without waves
  Coefficients pull_;          // on these columns; size 0: none
  double min_wavelength_;
  ThetaPrior prior_of_theta_{};
};

}  // namespace flexslip
