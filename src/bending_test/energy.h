// Where the work of the stage goes.
#pragma once

#include "bending_test/motion.h"

namespace flexslip {

// Energies in EI/L, accumulated from the start of a test.
struct EnergyAccount {
  double stage_work;  // ∫ F d(stage)
  double bending;     // bending energy of the fibre
  double load_train;  // F^2/(2k)
  double friction;    // heat: ∫ q Pn dS in sliding, ∫ μ Pn |dS| in snaps
  double snaps;       // what the snaps set free beyond friction: noise, vibration
  double cracks;      // what the cracks set free, at a fixed stage position (cracking_fibre.h)
  double
      imbalance;  // stage_work less the sum of the others; zero but for rounding and quadrature. The work of a stretch is
                  // integrated and not made from the others, so that this is a check
};

// The account after a further stretch, of a test that starts with the straight fibre.
EnergyAccount account_after(const EnergyAccount& account, const Stretch& stretch, const Rig& rig);

// ∫ F dw: what is read off a force-deflection curve as work of fracture, times area. Part of it is friction and snaps, part went into
// cracks, and what remains is the bending energy, of which unloading gives back what friction does not take.
double work_of_fracture(const EnergyAccount& account);

}  // namespace flexslip
