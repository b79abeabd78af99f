// The effect of each possible error of the rig on the readings.
//
// An error of contact, load train, span, force calibration, thickness or supports shifts each
// reading in deflection and force; so does a slow deviation of the force (theory.md,
// "Sensitivity to the rig"). Reduced variables of the nominal EI.
#pragma once

#include <vector>

#include "inference/fit.h"
#include "inference/rig_correction.h"

namespace flexslip {

class RigErrorEffects {
 public:
  // Domain:     as fit_friction; friction [1] from 0 to 2, at which thickness and supports act.
  RigErrorEffects(const FitProblem& problem, double friction);

  // The shift per unit of a quantity, relative or in spans (changes_in_spans), to first order.
  // Domain:     a deflection [L] up to the maximum of the record, a force [EI/L^2].
  Shift by(StatedQuantity quantity, double w, double F) const;

  // The shifts per standard deviation of each independent error. The slow deviation of the force
  // has eight, the nodes of a Matérn 5/2 process over the deflection with half of the record as its
  // length.
  std::vector<Shift> deviations(double w, double F) const;

 private:
  // The shifts per span of thickness or radius, at evenly spaced deflections.
  struct OfSupports {
    std::vector<double> force, length;  // [EI/L^2], [L]
  };
  OfSupports of_supports(const Supports& by, double friction) const;
  Shift by(const OfSupports& supports, double w) const;

  double compliance_, deepest_, greatest_force_, slow_force_;
  Supports supports_;
  PerQuantity<double> deviations_;
  OfSupports thicker_, rounder_;
};

// The prior standard deviation of each quantity: relative [1], or a length in spans [L].
PerQuantity<double> prior_deviations(const MeasurementErrors& errors, const RigErrors& rig_errors,
                                     const Supports& supports);

// The same problem with a quantity stated larger by `more`, relative [1] or in spans [L].
// Domain:     more > -1; thickness and radius stay in the domain of Fibre; std::invalid_argument
//             otherwise.
FitProblem restated(FitProblem problem, StatedQuantity quantity, double more);

}  // namespace flexslip
