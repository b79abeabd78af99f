// A friction along the fibre in a vector of parameters, and the force that it predicts at each point of a record.
//
// Waves are a cosine and a sine about the middle of the data, which decouples their phase from their wavelength.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Dense>

#include "inference/fit_problem.h"
#include "inference/profile.h"
#include "inference/sliding_ladder.h"

namespace flexslip {

// The parameters as one vector: mean [1], [slope [1/L]], then cosine [1], sine [1] and wavelength [L] of each wave, then the
// relative change η [1] of the bending stiffness.
struct ModelLayout {
  using Index = Eigen::Index;
  bool drift;
  Index waves;
  Index wave(Index i) const { return (drift ? 2 : 1) + 3 * i; }
  Index stiffness() const { return wave(waves); }
  Index size() const { return stiffness() + 1; }
  // Whether a polar parameter is a phase (polar_parameters.h).
  bool phase(Index i) const { return i >= wave(0) && i < stiffness() && (i - wave(0)) % 3 == 2; }
};

class ForceModel {
 public:
  // Domain:     a faultless record and its profile, of at least two points.
  ForceModel(FitProblem problem, FrictionProfile profile);

  const FitProblem& problem() const { return problem_; }
  const FrictionProfile& profile() const { return profile_; }
  const Eigen::VectorXd& measured_force() const { return force_; }  // [EI/L^2]
  double middle() const { return S_middle_; }                       // [L] of the data
  double length_seen() const { return length_seen_; }               // [L] of fibre, over one support
  double least_wavelength() const { return least_wavelength_; }     // [L] that the points of the profile show
  double prior_mean() const { return prior_mean_; }                 // [1] of η
  double prior_variance() const;                                    // [1] of η

  // The same model of another measured force [EI/L^2] at the same stage positions, and of another opinion on η [1].
  ForceModel with(const Eigen::VectorXd& force, double prior_mean) const;

  struct Response {
    Eigen::VectorXd force;   // [EI/L^2] nominal, at each stage position
    Eigen::MatrixXd slopes;  // of it, with respect to each parameter
  };

  // Units:      [EI/L^2] nominal.
  // Max error:  that of interpolation on the ladder of lengths (sliding_ladder.h).
  // Cost:       15 µs for 260 points; with slopes twice that.
  Eigen::VectorXd force(const ModelLayout& layout, const Eigen::VectorXd& p) const;
  Response response(const ModelLayout& layout, const Eigen::VectorXd& p) const;

  // The force at stage positions [L] other than those of the record.
  std::vector<double> force_at(const ModelLayout& layout, const Eigen::VectorXd& p,
                               std::span<const double> stages) const;

  // Mean positive, amplitudes adding up to at most 1, |η| < 0.3, wavelengths that the data resolve.
  bool permits(const ModelLayout& layout, const Eigen::VectorXd& p) const;

 private:
  std::vector<double> friction(const ModelLayout& layout, const Eigen::VectorXd& p) const;

  FitProblem problem_;
  FrictionProfile profile_;
  double S_middle_;
  double length_seen_;
  double least_wavelength_;
  SlidingLadder ladder_;
  Eigen::VectorXd force_;
  double prior_mean_ = 0;
};

}  // namespace flexslip
