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
#include "inference/gap_sites.h"
#include "inference/theta.h"

namespace flexslip {

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
  const ThetaPrior& prior_of_theta() const { return prior_of_theta_; }
  double least_wavelength() const { return least_wavelength_; }         // [L] four advances of a reading
  double greatest_wavelength() const { return passages_.range / 2.2; }  // [L]

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

  // Sites that agree with the looks; the merit.
  void settle(Mode& mode) const;

  static constexpr double mean_friction = 0.55;   // expected beforehand, 0.5 its standard deviation
  static constexpr double wave_deviation = 0.08;  // [1] of a wave's cosine and sine beforehand
  // ln p(readings, gaps | θ) of a mode whose sites are settled, without the volume of the readings.
  double evidence(const Mode& mode) const {
    return mode.merit - mode.at.log_jacobian - prior_of_theta_.log_density(mode.kernel, mode.theta);
  }
  double expected_stiffness(const Mode& mode) const;  // of ln EI/nominal beforehand

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

  Passages passages_;
  ColumnPlaces columns_;
  std::vector<double> prior_;  // of the columns but waves
  double least_wavelength_;
  ThetaPrior prior_of_theta_{};
};

}  // namespace flexslip
