// A loading run forward over the readings of a record: the states that the fibre visits with a given friction along it.
//
// Modes are found by linearising at states. Only states that the fibre visits are worth linearising at, and near a fold a reading tells almost
// nothing of the place.
#pragma once

#include <span>
#include <vector>

#include "inference/process_mode.h"

namespace flexslip {

struct ForwardStates {
  std::vector<double> S, mu, slope;  // [L], [1], [1/L] dμ/dS at each reading
  std::vector<double> force;         // [EI/L^2] in units of the nominal bending stiffness
};

// Friction on a ladder of lengths around the fibre seen.
class ForwardRun {
 public:
  explicit ForwardRun(const Passages& passages);

  std::span<const double> lengths() const { return S_; }  // [L]
  // Domain:     a value of μ for each length; those outside [0, 2] count as the nearest bound. Stage positions [L] that hardly fall.
  // Max error:  of S a hundredth of the distance of two lengths, away from folds.
  ForwardStates states(std::span<const double> mu, double eta, std::span<const double> stage) const;

 private:
  const Passages& passages_;
  std::vector<double> S_;
};

// A mode with waves linearised where its mean and waves alone make the readings pass, their size, phase and level changed so that the run
// comes closest to the record: a wave read off noisy states is too small, because its crests are folds.
Mode fitted_forward(const FrictionProcess& process, const ForwardRun& run, const Mode& mode);

// The force at stage positions, each beyond the last, that friction along the fibre gives.
// Domain:     table of at least two lengths.
std::vector<double> forces_of(const FrictionTable& friction, const Rig& rig, std::span<const double> stages);

}  // namespace flexslip
