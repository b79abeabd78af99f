// The correction of readings for the estimated errors of the rig.
#pragma once

#include <vector>

#include "data/record.h"

namespace flexslip {

// The change of one reading.
struct Shift {
  double deflection;  // [L]
  double force;       // [EI/L^2]
  double length = 0;  // [L] additional change of the length between the contacts, on rollers
};

// The shift to add to readings as a function of the stage: linear between the given positions,
// proportional to the stage before the first, and constant after the last.
class RigCorrection {
 public:
  RigCorrection() = default;  // no correction

  // Domain:     stage [L] increasing, one shift per position; the compliance [L^3/EI] of the load
  //             train.
  RigCorrection(std::vector<double> stage, std::vector<Shift> shift, double compliance);

  Shift at(double stage) const;
  double corrected_stage(double stage) const;  // [L]
  ReducedRecord corrected(ReducedRecord record) const;

 private:
  std::vector<double> stage_;
  std::vector<Shift> shift_;
  double compliance_ = 0;
};

}  // namespace flexslip
