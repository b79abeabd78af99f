// One mode of the posterior of friction along a fibre: hyperparameters and linearisation that agree with each other;
// and the search for all of them.
//
// The posterior is approached by turns: at given hyperparameters the readings are linearised at the state fitted (Gauss-Newton) and the
// bounds of the gaps, over which the fibre jumped, are taken as Gaussians (expectation propagation); at a given linearisation the
// hyperparameters are moved uphill. What a mode is worth is its merit, ln p(readings, gaps, hyperparameters).
#pragma once

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
  std::vector<GapSite> sites;
  double merit;  // ln p(readings, gaps, θ)
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

  // The same with what else is known of its columns but waves (rig_pull.h).
  FrictionProcess with_pull(const Coefficients& pull) const;

  const Passages& passages() const { return passages_; }
  const ColumnPlaces& columns() const { return columns_; }
  const ThetaPrior& prior_of_theta() const { return prior_of_theta_; }
  // [L] Four advances of a reading, at least range/readings, and 2π of what noise moves the place of a reading by.
  double min_wavelength() const { return min_wavelength_; }
  double max_wavelength() const { return passages_.range / 2.2; }  // [L]

  static Mode start(Kernel kernel, const Theta& theta, const Linearisation& at);

  // Gauss-Newton steps by a fraction of their length, the sites along; the merit is that of the end.
  void burst(Mode& mode, int steps, double fraction) const;

  // Rounds of moving the hyperparameters uphill and a burst.
  void polish(Mode& mode, int rounds, int steps, double fraction) const;

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

  // Sites that agree with the observations; the merit.
  void settle(Mode& mode) const;

  static constexpr double mean_friction = 0.55;   // expected beforehand, 0.5 its standard deviation
  static constexpr double wave_deviation = 0.08;  // [1] of a wave's cosine and sine beforehand
  // ln p(readings, gaps | θ) of a mode whose sites are settled, without the volume of the readings.
  double evidence(const Mode& mode) const {
    return mode.merit - mode.at.log_jacobian - prior_of_theta_.log_density(mode.kernel, mode.theta);
  }

 private:
  struct Node {
    double S;
    double level;  // [1] the friction there is below it
  };
  std::vector<Node> nodes_of(const Mode& mode) const;
  double by_error(const RigError& error, std::size_t reading, double wave_slope) const;
  double by_errors_at(const Linearisation& at, std::size_t reading, double wave_slope) const;
  double bound_at(const Node& node, const GapSite& site, const Mode& mode) const;
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

// The posterior of friction along a fibre: which kernels and which waves explain a record, and how well.
//
// Every mode found is a component of a mixture, weighed by its evidence (Laplace). Nothing is chosen but what the weights say.

struct SearchOptions {
  std::vector<Kernel> kernels{all_kernels.begin(), all_kernels.end()};
  std::optional<std::size_t>
      waves;  // modes with so many, or fewer where no further one is told from those that are there; not given: with none, with one, and with two where both are claimed
};

struct Component {
  Mode mode;
  double log_evidence;
  Eigen::MatrixXd spread;  // covariance of θ, by the curvature of the merit as it is linearised
  // [1] Of ln λ of each wave, by how the merit falls where it is linearised anew: wavelengths and the errors of the rig make up for each other.
  std::array<double, max_waves> wavelength_deviation{};
  // [rad] By how much the angle of each wave at the middle turns with ln of the lengths, along that valley.
  std::array<double, max_waves> turn{};
};

struct ScannedWavelength {
  double wavelength;  // [L]
  double gain;        // of the logarithm of the evidence, hyperparameters unchanged
};

struct ProcessSearch {
  std::vector<Component> components;    // likeliest first; none where the readings are too far from any friction
  std::vector<ScannedWavelength> scan;  // of the mode without a wave, λ rising
};

// Domain:     options.kernels not empty.
// Method:     From the rises of the record, the mode without a wave; a scan over wavelengths, and where noise blurs the places of readings two
//             more at other settings of the hyperparameters; from the best two peaks of each, modes with a wave. The best three within 12 of the first
//             are polished, if the first gains anything, and those within 3 continued to the other kernels: the best alone where it gains nothing,
//             none where it loses 2. A second wave likewise. What weighs anything is linearised until it agrees with itself, and the likeliest waves
//             are moved along the valley that their length shares with the rig.
ProcessSearch search(const FrictionProcess& process, const SearchOptions& options);

}  // namespace flexslip
