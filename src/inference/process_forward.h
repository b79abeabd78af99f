// A loading run forward over the readings of a record: which states a friction along the fibre makes them pass.
//
// Modes are found by linearising at states; only states that friction itself lets the fibre visit are worth linearising at, and near a fold,
// where a reading tells almost nothing of the place, that has to be seen to.
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
  // Domain:     a value of μ for each length; those outside [0, 2] count as the nearest bound.
  // Max error:  of S a hundredth of the distance of two lengths, away from folds.
  ForwardStates states(std::span<const double> mu, double eta) const;

 private:
  const Passages& passages_;
  std::vector<double> S_;
};

// The mode linearised anew where its own mean of friction, run forward, makes the readings pass.
Mode run_forward(const FrictionProcess& process, const ForwardRun& run, const Mode& mode);

// Have readings got to a fold, or past it, where no fibre rests?
bool is_past_a_fold(const Mode& mode);

// Only those readings, moved back to where the fibre last was.
Mode projected(const FrictionProcess& process, const ForwardRun& run, const Mode& mode);

// A mode with waves linearised where its mean and waves alone make the readings pass, their size, phase and level changed so that the run
// comes closest to the record: a wave read off noisy states is too small, because its crests are folds.
Mode fitted_forward(const FrictionProcess& process, const ForwardRun& run, const Mode& mode);

}  // namespace flexslip
