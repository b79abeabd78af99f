// The simulation of a loading with a given friction along the specimen, at the readings of a
// record.
//
// A mode is linearised at the states that the specimen visits in this simulation. Near a fold, a
// reading alone barely determines the length.
#pragma once

#include <span>
#include <vector>

#include "inference/process_mode.h"

namespace flexslip {

struct ForwardStates {
  std::vector<double> S, mu, slope;  // [L], [1], [1/L] dμ/dS at each reading
  std::vector<double> force;         // [EI/L^2] in units of the nominal bending stiffness
};

// Simulations with friction given at fixed lengths around the observed ones.
class ForwardRun {
 public:
  explicit ForwardRun(const Passages& passages);

  std::span<const double> lengths() const { return S_; }  // [L]
  // Domain:     one μ per length, clamped to [0, 2]; stage positions [L] that increase, apart from
  //             noise.
  // Max error:  a hundredth of the distance between two lengths in S, away from folds.
  ForwardStates states(std::span<const double> mu, double eta, std::span<const double> stage) const;

 private:
  const Passages& passages_;
  std::vector<double> S_;
};

// A mode with waves, linearised at the simulation of its mean and waves whose size, phase and level
// fit the record best. A wave fitted at noisy inverted states would be too small, because its
// crests are folds.
Mode fitted_forward(const FrictionProcess& process, const ForwardRun& run, const Mode& mode);

// The force at increasing stage positions for a friction along the specimen.
// Domain:     table of at least two lengths.
std::vector<double> forces_of(const FrictionTable& friction, const Rig& rig, std::span<const double> stages);

}  // namespace flexslip
