// Equilibrium and snaps at a fixed stage position. In a snap the specimen slides because friction
// cannot hold it.
//
// At a fixed stage position, S is the only degree of freedom. q(S) is the mobilised friction that
// keeps the specimen in equilibrium at length S. The elastic energy of specimen and rig, Π = U +
// F^2/2k, decreases by q Pn dS as the specimen slides by dS. Friction dissipates μ Pn dS; the rest
// is released (theory.md, "Snaps").
#pragma once

#include <optional>

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "fibre/elastica.h"

namespace flexslip {

enum class Holding {
  held,
  no_contact,      // the stage is above the specimen even at zero force or q = -20
  beyond_friction  // only a friction above 20 gives equilibrium
};

struct HeldState {
  Holding holding;
  // w + F/k = stage if held; otherwise the last state tried, with q = -20, zero force, or q = 20
  FibreState state;
};

// The equilibrium state at length S; q is a first guess.
// Domain:     S >= 1, stage >= 0, |q| <= 20; std::invalid_argument otherwise.
// Max error:  4 ulp of the stage position, for w + F/k.
// Method:     w and F rise strictly with q at fixed S; Newton's iteration guarded by bisection.
HeldState held_at(double S, double stage, const Rig& rig, double q);

struct SnapWork {
  double friction = 0;  // [EI/L] ∫ μ Pn |dS|, never negative
  double released = 0;  // [EI/L] released beyond friction
  SnapWork& operator+=(const SnapWork& other) {
    friction += other.friction;
    released += other.released;
    return *this;
  }
  friend SnapWork operator*(double factor, const SnapWork& work) {
    return {factor * work.friction, factor * work.released};
  }
};

// The energies of a snap between two lengths. Empty if a length in between has no equilibrium.
// Max error:  1e-12 of the friction heat.
std::optional<SnapWork> snap_work(const Friction& friction, const Rig& rig, double stage, double S_from, double S_to);

struct Overshoot {
  Holding end;      // the other fields are valid only if held
  double S;         // [L] where the energy is dissipated
  double friction;  // [EI/L] heat up to there: the total decrease of the elastic energy
};

// The overshoot of a snap that only friction damps: the length beyond the stable state S_landing at
// which friction has dissipated the energy released since S_from. no_contact also beyond S = 10.
Overshoot overshoot_of(const Friction& friction, const Rig& rig, double stage, double S_from, double S_landing);

}  // namespace flexslip
