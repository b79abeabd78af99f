// What a rig may be off by, as what it does to the readings of a record.
//
// An error of the contact, the load train, the span, the gain of the load cell, the thickness or the supports moves each reading in deflection
// and force; so does a force that deviates slowly (theory.md, "What the answer hangs on"). Reduced variables of the nominal EI.
#pragma once

#include <cstddef>
#include <vector>

#include "inference/fit.h"
#include "inference/rig_correction.h"

namespace flexslip {

enum class RigQuantity { contact, preload, load_train, span, force_gain, thickness, support_radius };
inline constexpr std::size_t rig_quantities = 7;

class RigShifts {
 public:
  // Domain:     as fit_friction; the friction [1] at which thickness and supports act, 0 to 2.
  RigShifts(const FitProblem& problem, double friction);

  // For a quantity larger than stated, to first order: by one span of contact, preload, thickness and radius, by the whole of the others.
  // Domain:     a deflection [L] up to the greatest of the record, a force [EI/L^2].
  Shift by(RigQuantity quantity, double w, double F) const;

  // For each error that is independent of the others, one standard deviation of it. Of a force that deviates slowly there are several: a Matérn
  // 5/2 process over the deflection whose length is half of the record, known at eight places.
  std::vector<Shift> deviations(double w, double F) const;

 private:
  // By one span more of thickness or radius, [EI/L^2] of force at deflections evenly spread from 0 to the greatest.
  std::vector<double> of_supports(const Supports& by, double friction) const;

  double compliance_, deepest_, greatest_force_, contact_error_;
  RigErrors errors_;
  Supports supports_;
  std::vector<double> thicker_, rounder_;
};

}  // namespace flexslip
