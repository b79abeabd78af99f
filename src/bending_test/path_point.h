// A state on the path of a test.
#pragma once

#include "fibre/fibre.h"

namespace flexslip {

// apart: the nose is off a fibre that friction holds bent, without a force. crack: cracking_fibre.h.
enum class Motion { stick, slip_in, slip_out, snap, crack, apart };

struct PathPoint {
  double stage;     // [L] below w of a fibre that the nose is off
  double w;         // [L]
  double F;         // [EI/L^2]
  double S;         // [L]
  double q;         // [1]
  Motion motion;    // by which the fibre came to this point from the one before
  double left = 1;  // [1] share of the first bending stiffness: less after cracks
};

// Its state: of a specimen with a thickness that of the deflection, since two may belong to a length.
inline FibreState state_at(const Fibre& fibre, const PathPoint& point) {
  return fibre.begins_straight() ? fibre.state(point.S, point.q) : fibre.bent(point.w, point.q).state;
}

// [EI/L]
struct StretchWork {
  double stage;        // ∫ F d(stage)
  double friction;     // heat at the supports
  double released;     // what a snap sets free beyond friction
  double cracked = 0;  // what a crack sets free
};

}  // namespace flexslip
