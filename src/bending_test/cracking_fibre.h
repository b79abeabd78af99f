// A specimen that cracks while it is bent: where the deflection first reaches some values its bending stiffness falls, at once, all
// along it and for good.
//
// A crack is faster than the specimen slides: stage position and length stay, the deflection rises, and the force falls along the load
// line. So more friction has to hold the specimen, and where there is not so much, it is drawn in, in a snap. Hardly bent, or with little
// of its stiffness left, it may need any friction: where not even largest_q would hold it, it is drawn in as it cracks, to where that does,
// and what friction takes on that way counts as set free by the crack. Static friction holds again after a crack. Less EI is the same fibre
// on a rig that is stiffer in the reduced units (theory.md, "Cracks").
#pragma once

#include <optional>
#include <vector>

#include "bending_test/motion.h"

namespace flexslip {

struct Crack {
  double w;     // [L] the deflection at which it happens; one that a snap or another crack passes happens at its end
  double loss;  // [1] of the bending stiffness left, in (0, 1)
};

// Moves as MovingFibre does, with cracks as stretches among the others. All is in units of the first bending stiffness.
class CrackingFibre {
 public:
  // Domain: as MovingFibre; cracks in any order, w > 0, loss in (0, 1); std::invalid_argument otherwise.
  CrackingFibre(BendingTest test, std::vector<Crack> cracks, double farthest);

  PathPoint state() const { return in_first_units(fibre_.state()); }
  HistoryStatus end() const { return fibre_.end(); }
  const FrictionLaw& friction() const { return fibre_.friction(); }

  // As those of MovingFibre. The energy that a crack sets free is that of fibre and rig before it less that after.
  // Max error:  of the deflection of a crack, its rounding.
  std::optional<Stretch> advance_towards(double stage);
  std::vector<Stretch> parts_of(const Stretch& stretch, int n);
  void halt() { fibre_.halt(); }

 private:
  PathPoint in_first_units(PathPoint point) const;
  Stretch in_first_units(Stretch stretch) const;
  std::optional<Stretch> advance_to_next(double stage);
  Stretch crack();
  Rig rig() const { return {test_.rig.stiffness / left_, test_.rig.fibre}; }

  BendingTest test_;
  double farthest_;
  std::vector<Crack> cracks_;  // to come, the next one last
  double left_ = 1;
  bool due_ = false;      // the next crack
  bool cracked_ = false;  // and has yet to settle
  MovingFibre fibre_;
};

}  // namespace flexslip
