// What a rig is found to be off by, taken off the readings.
#pragma once

#include <vector>

#include "data/record.h"

namespace flexslip {

// By how much deflection and force of a reading would differ.
struct Shift {
  double deflection;  // [L]
  double force;       // [EI/L^2]
  double length =
      0;  // [L] between the contacts, beyond what these two make it: rollers let them roll along the specimen
};

// What is to be added to what is read, over the stage: between the positions given by lines, before the first in proportion, beyond the last what
// it is there.
class RigCorrection {
 public:
  RigCorrection() = default;  // of a rig that is as stated

  // Domain:     stage [L] rising, a shift for each of its positions, the compliance [L^3/EI] of the load train.
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
