// What happens at a fixed stage position: the fibre held at rest, and the snap, in which it slides because friction cannot
// hold it.
//
// At a fixed stage position S is the only freedom left. The friction that would hold the fibre there is q(S); the elastic
// energy of fibre and frame, Π = U + F^2/2k, falls by q Pn dS as the fibre slides by dS, of which friction takes μ Pn dS. The
// rest is set free (theory.md, "Snaps").
#pragma once

#include <optional>

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "fibre/elastica.h"

namespace flexslip {

enum class Holding {
  held,
  no_contact,      // even without a force, or with q = -20, the stage stands beyond
  beyond_friction  // only a friction beyond 20 holds the fibre there
};

struct HeldState {
  Holding holding;
  FibreState state;  // w + F/k = stage if held; otherwise the last one, with q = -20 or without a force, or with q = 20
};

// The state of a fibre that rests at the length S. q is a first guess.
// Domain:     S >= 1, stage >= 0, |q| <= 20; std::invalid_argument otherwise.
// Max error:  of w + F/k, 4 ulp of the stage position.
// Method:     w and F rise strictly with q at fixed S; Newton's iteration guarded by bisection.
HeldState held_at(double S, double stage, const Rig& rig, double q);

struct SnapWork {
  double friction = 0;  // [EI/L] ∫ μ Pn |dS|, never negative
  double released = 0;  // [EI/L] what is set free beyond friction
  SnapWork& operator+=(const SnapWork& other) {
    friction += other.friction;
    released += other.released;
    return *this;
  }
  friend SnapWork operator*(double factor, const SnapWork& work) {
    return {factor * work.friction, factor * work.released};
  }
};

// The energies of a snap at a stage position from one length to another. None if the fibre is not held all the way.
// Max error:  1e-12 of the friction heat.
std::optional<SnapWork> snap_work(const Friction& friction, const Rig& rig, double stage, double S_from, double S_to);

struct Swing {
  Holding end;      // where it is not held, nothing else is valid
  double S;         // [L] where the energy is spent
  double friction;  // [EI/L] heat up to there: all that the elastic energy has fallen
};

// Where the energy that is set free from S_from to S_landing, a stable state, is consumed by friction: so far beyond it a snap
// goes that nothing else damps. no_contact also if it is drawn in beyond S = 10.
Swing swing(const Friction& friction, const Rig& rig, double stage, double S_from, double S_landing);

}  // namespace flexslip
