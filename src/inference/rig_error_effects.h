// What a rig may be off by, as what it does to the readings of a record.
//
// An error of the contact, the load train, the span, the gain of the load cell, the thickness or the supports moves each reading in deflection
// and force; so does a force that deviates slowly (theory.md, "Sensitivity to the rig"). Reduced variables of the nominal EI.
#pragma once

#include <vector>

#include "inference/fit.h"
#include "inference/rig_correction.h"

namespace flexslip {

class RigErrorEffects {
 public:
  // Domain:     as fit_friction; the friction [1] at which thickness and supports act, 0 to 2.
  RigErrorEffects(const FitProblem& problem, double friction);

  // For a quantity larger than stated, to first order: by the whole of it, or by one span (changes_in_spans).
  // Domain:     a deflection [L] up to the greatest of the record, a force [EI/L^2].
  Shift by(StatedQuantity quantity, double w, double F) const;

  // For each error that is independent of the others, one standard deviation of it. Of a force that deviates slowly there are several: a Matérn
  // 5/2 process over the deflection whose length is half of the record, known at eight places.
  std::vector<Shift> deviations(double w, double F) const;

 private:
  // By one span more of thickness or radius, at deflections evenly spread from 0 to the greatest and the same friction.
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

// What each is off by beforehand, as a standard deviation: of its value [1], or in spans [L].
PerQuantity<double> prior_deviations(const MeasurementErrors& errors, const RigErrors& rig_errors,
                                     const Supports& supports);

// The same readings with a quantity stated larger, by such a part of it [1], or by so many spans [L]. What is stated smaller is negative.
// Domain:     more > -1; thickness and radius of the supports stay as Fibre has them; std::invalid_argument otherwise.
FitProblem restated(FitProblem problem, StatedQuantity quantity, double more);

}  // namespace flexslip
