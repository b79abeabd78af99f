// The states on the path of a test; and its beginning, of a specimen with a thickness: bent by less than some half depths its surface slides outwards first, sticks, and then
// slides in (theory.md, "Rollers and thickness").
//
// Two states belong to each length there, so that the way is told in the deflection, which only rises while the stage advances: friction matters
// too little for a snap. Friction is kinetic.
#pragma once

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

// A state on the path of a test.

// apart: the nose is off a fibre that friction holds bent, without a force. crack: Crack (history.h).
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
  return fibre.slides_inward_only() ? fibre.state(point.S, point.q) : fibre.state_at_deflection(point.w, point.q);
}

// [EI/L]
struct StretchWork {
  double stage;        // ∫ F d(stage)
  double friction;     // heat at the supports
  double released;     // what a snap sets free beyond friction
  double cracked = 0;  // what a crack sets free
};

class Shallow {
 public:
  // Domain: a fibre that does not begin straight; references that outlive this.
  Shallow(const Friction& friction, const Rig& rig) : friction_(friction), rig_(rig) {}

  // Whether a state is on this part of the way: below a length of 1, or the less bent of two.
  static bool holds(const Fibre& fibre, double S, double w);

  PathPoint straight() const;

  // The end of the next stretch towards a stage position: there, at the end of sticking or sliding, or at the length 1 drawn in.
  // Domain:     a point on this part; a stage position other than its own, >= 0.
  // Max error:  of the stage position, its rounding.
  PathPoint next(const PathPoint& from, double stage) const;

  // Between two points of one stretch.
  StretchWork work(const PathPoint& from, const PathPoint& to) const;
  PathPoint point_at(const PathPoint& from, const PathPoint& to, double w) const;

  // At a stage position, with a friction, or as much of it as there is.
  PathPoint held(double stage, double q) const;

 private:
  struct Place {
    Fibre::DeflectionState at;
    double q_w;                                              // [1/L] along the way
    double length_w;                                         // [L/L] of what lies between the contacts
    double slides() const { return at.S_w + at.S_q * q_w; }  // [L/L] of what has been drawn in
  };
  // The friction at which a place is looked for: led on from the last that was found.
  struct Guess {
    double w, q, q_w;
    double at(double deflection) const;
    void follow(const Place& found);
  };
  // Sliding in (1) or out (-1), or at rest at a length.
  struct Way {
    double direction;  // 0: at rest
    double S;
  };
  Place place(const Way& way, double w, double q_near) const;
  double stage_of(const Place& place) const { return place.at.state.w + place.at.state.F / rig_.stiffness; }
  double length_met(const FibreState& state) const;  // [L] where friction is looked up
  // [L] How far that may go on as if friction were smooth: half its scale, and half of the way to its knots and over one of them.
  double smooth_at(double length) const;
  double friction_at(const FibreState& state) const;

  const Friction& friction_;
  const Rig& rig_;
};

}  // namespace flexslip
