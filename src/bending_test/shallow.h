// The states on the path of a test; and the shallow beginning of a test with a thickness. Up to a
// deflection of some half depths, the surface first slides outwards, sticks, and then slides in
// (theory.md, "Rollers and thickness").
//
// Two states share each length there, so the path is a function of the deflection, which increases
// as the stage advances. Friction is kinetic, and too small an effect for a snap.
#pragma once

#include "bending_test/rig.h"
#include "contact/friction.h"
#include "fibre/fibre.h"

namespace flexslip {

// A state on the path of a test.

// apart: the nose has no contact, and friction holds the specimen bent. crack: Crack (history.h).
enum class Motion { stick, slip_in, slip_out, snap, crack, apart };

struct PathPoint {
  double stage;     // [L] below w without contact
  double w;         // [L]
  double F;         // [EI/L^2]
  double S;         // [L]
  double q;         // [1]
  Motion motion;    // the motion from the preceding point to this one
  double left = 1;  // [1] remaining fraction of the initial bending stiffness
};

// The state of a point; with a thickness, from the deflection, since two states may share a length.
inline FibreState state_at(const Fibre& fibre, const PathPoint& point) {
  return fibre.slides_inward_only() ? fibre.state(point.S, point.q) : fibre.state_at_deflection(point.w, point.q);
}

// The energies of a segment [EI/L].
struct StretchWork {
  double stage;        // ∫ F d(stage)
  double friction;     // heat at the supports
  double released;     // released in a snap beyond friction
  double cracked = 0;  // released in a crack
};

class Shallow {
 public:
  // Domain:     supports with a thickness; the references must outlive this.
  Shallow(const Friction& friction, const Rig& rig) : friction_(friction), rig_(rig) {}

  // True if a state is shallow: at a length below 1, or with the smaller of two deflections.
  static bool holds(const Fibre& fibre, double S, double w);

  PathPoint straight() const;

  // The end of the next segment towards a stage position: there, at the end of sticking or sliding,
  // or at the length 1 for sliding in.
  // Domain:     a shallow point; a different stage position >= 0.
  // Max error:  rounding of the stage position.
  PathPoint next(const PathPoint& from, double stage) const;

  // The energies between two points of one segment.
  StretchWork work(const PathPoint& from, const PathPoint& to) const;
  PathPoint point_at(const PathPoint& from, const PathPoint& to, double w) const;

  // The point at a stage position with friction q, or with the largest possible friction below it.
  PathPoint held(double stage, double q) const;

 private:
  struct Place {
    Fibre::DeflectionState at;
    double q_w;  // [1/L] along the path
    // [L/L] of the length between the contacts
    double length_w;
    double slides() const { return at.S_w + at.S_q * q_w; }  // [L/L] of the sliding length
  };
  // The starting value of the friction, extrapolated from the last result.
  struct Guess {
    double w, q, q_w;
    double at(double deflection) const;
    void follow(const Place& found);
  };
  // Sliding in (1) or out (-1), or sticking at a length.
  struct Way {
    double direction;  // 0: at rest
    double S;
  };
  Place place(const Way& way, double w, double q_near) const;
  double stage_of(const Place& place) const { return place.at.state.w + place.at.state.F / rig_.stiffness; }
  double length_met(const FibreState& state) const;  // [L] argument of friction
  // [L] The distance over which friction may be treated as smooth: half its scale, limited to half
  // the distance to its knots and to one knot beyond.
  double smooth_at(double length) const;
  double friction_at(const FibreState& state) const;

  const Friction& friction_;
  const Rig& rig_;
};

}  // namespace flexslip
