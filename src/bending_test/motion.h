// How the fibre moves while the stage does: at rest on its supports, sliding over them, or in a snap; and where the work of
// the stage goes.
//
// The state of a test is (S, q), which fixes deflection, force and stage position. Moving the stage changes q at fixed S as
// long as friction holds (stick); then the fibre slides in along q = μ(S), or out along q = -μ(S); where the curve folds back
// it snaps, at constant stage position. So any programme is a chain of stretches, each of one kind, from one event to the
// next, and nothing depends on how fast or in which steps the stage is moved (theory.md, "Any history").
#pragma once

#include <optional>
#include <vector>

#include "bending_test/rig.h"
#include "bending_test/shallow.h"
#include "bending_test/sliding_table.h"
#include "bending_test/snap.h"
#include "contact/friction.h"

namespace flexslip {

// What is tested, and on what: a fibre with friction on a rig.

// Where a snap comes to rest.
enum class SnapRest {
  nearest_stable,  // at the next stable state, q = μ_k: whatever is set free is lost at once (the paper's postulate, (4.32))
  overshoot,  // the energy set free carries the fibre on, until friction has consumed it: it rests with |q| below the
              // static friction, after swinging back if need be. What does not end in 1,000 swings, or swings so
              // far back that only a friction beyond 20 would hold the fibre, rests as above.
};

struct BendingTest {
  FrictionLaw
      friction;  // on two supports that are not alike without a static excess, and at rest at the nearest stable state
  Rig rig;
  SnapRest rest = SnapRest::nearest_stable;
  double wear = 1;  // [1] share of friction that each turn of the stage leaves (CrackingFibre), in (0, 1]
};

// A part of the way that a test takes.

// Part of the way between two events, or to the stage position asked for.
struct Stretch {
  PathPoint from, to;     // to.motion is that of the stretch: in stick S is constant, in a snap the stage
  StretchWork jump = {};  // of a snap or a crack; that of any other is integrated where it is asked for (work_of)

  bool is_jump() const { return from.stage == to.stage; }
};

enum class HistoryStatus {
  ok,
  slipped_through,  // a stage position exceeds every equilibrium: the fibre slips through the supports
  contact_lost,     // a snap let the fibre out until no force was left
};

// A slip shorter than this [L] runs on into the next: a nanometre for a span of a millimetre. Without it, static friction on a
// straight fibre would mean infinitely many slips, for their length goes as w^3.
inline constexpr double min_slip = 1e-6;

class MovingFibre {
 public:
  // Straight, at the stage position 0. It can be moved up to `farthest` [L].
  // Domain: rig.stiffness > 0, farthest >= 1e-6, static friction at most 20 wherever the fibre gets; test as said there; no static excess on rollers; std::invalid_argument
  //         otherwise.
  MovingFibre(BendingTest test, double farthest);

  // The same, at rest for the moment at a length and a stage position, at which friction may not hold it: see settle(). Where not even
  // a friction of 20 holds it there, at the least length at which that does; where there is none, it has slipped through.
  // Domain: there.S >= 1, unless it is shallow (shallow.h), where it is held with its friction; there.stage >= 0 besides.
  MovingFibre(BendingTest test, double farthest, const PathPoint& there);

  const PathPoint& state() const { return state_; }
  HistoryStatus end() const { return end_; }

  // That of the way which it is on: on two supports that are not alike it changes where the fibre turns back (two_supports.h).
  const FrictionLaw& friction() const { return test_.friction; }

  // The snap (with an excess of static friction, maybe a slip that runs on) in which a fibre comes to rest that friction does not hold
  // where it is. None if it does, or if it slips through or springs off the nose: see end(). What a shallow fibre sets free counts as friction.
  std::optional<Stretch> settle();

  // Friction, at rest and in sliding, is from here on so many times as large: whether it holds the fibre where it is, settle() says.
  // Domain:     as Friction::scaled.
  void scale_friction(double factor);

  // The next stretch on the way to a stage position; none when it is there, or when end() says why it never will be.
  // Domain:     0 <= stage <= farthest; std::invalid_argument otherwise.
  // Max error:  events (the end of stick, folds, landings) to the rounding of the stage position.
  // Cost:       a few µs; the first that slides in a direction traces its curve (trace.h).
  std::optional<Stretch> advance_towards(double stage);

  // Where the energy goes on a stretch, or a part of one, of the way that the fibre is on: asked before the next.
  // Max error:  as sliding_table.h.
  StretchWork work_of(const Stretch& stretch);

  // The same stretch in n - 1 parts of equal length: in √(S - 1) (Fibre::way) where the fibre slides, in q where it sticks, in w where it is shallow. A stretch at a
  // fixed stage position is one part.
  // Domain:     n >= 2; a stretch of this fibre.
  std::vector<Stretch> parts_of(const Stretch& stretch, int n);

  // The stage position within a stretch of sticking or sliding in at which the fibre is bent so far.
  // Domain:     stretch.from.w <= w <= stretch.to.w, on a way on which the deflection rises.
  // Max error:  the rounding of the stage position.
  double stage_at_deflection(const Stretch& stretch, double w) const;

  // Where a fibre stands, to come back to after a look ahead.
  struct Position;
  Position position() const;
  void return_to(const Position& position);

  // The stage halts: sliding stops, and static friction holds again.
  void halt() { glide_.reset(); }

 private:
  // Sliding that has not stopped: friction stays kinetic, up to a length at least.
  struct Glide {
    Sliding sliding;
    double to_S;  // [L] infinite: until the stage turns back or halts
  };

  PathPoint point_within(const Stretch& stretch, double along) const;
  bool is_shallow(Sliding sliding) const;
  double limit_at(Sliding sliding) const;
  Shallow shallow() const { return {test_.friction.kinetic, test_.rig}; }
  std::optional<Stretch> stick(Sliding sliding, double limit, double stage);
  std::optional<Stretch> slide(Sliding sliding, double stage);
  bool is_free() const { return state_.F == 0 && state_.S > 1; }
  Stretch move_apart(double stage);
  std::optional<Stretch> snap(Sliding sliding);
  std::optional<Stretch> settle_shallow(PathPoint rest);
  std::optional<Stretch> overshoot(Sliding sliding, const RigPoint& nearest, const SnapWork& nearest_work);
  std::optional<Stretch> lose(Sliding sliding);
  Stretch move_to(const PathPoint& point);
  Stretch jump_to(const PathPoint& point, const SnapWork& work);
  SlidingTable& table_of(Sliding sliding) { return sliding == Sliding::in ? table_in_ : table_out_; }
  const SlidingCurve& curve_of(Sliding sliding, double S);
  void lead_on(Sliding sliding);
  void retrace();

  BendingTest test_;
  double farthest_;
  SlidingCurve in_;
  std::optional<SlidingCurve> out_;
  SlidingTable table_in_, table_out_;
  PathPoint state_{};
  RigPoint here_{};  // the last point met on a curve
  HistoryStatus end_ = HistoryStatus::ok;
  std::optional<Glide> glide_;
};

struct MovingFibre::Position {
  PathPoint state;
  RigPoint here;
  HistoryStatus end;
  std::optional<Glide> glide;
};

// Where the work of the stage goes.

// Energies in EI/L, accumulated from the start of a test.
struct EnergyAccount {
  double stage_work;  // ∫ F d(stage)
  double bending;     // bending energy of the fibre
  double load_train;  // F^2/(2k)
  double friction;    // heat: ∫ q Pn dS in sliding, ∫ μ Pn |dS| in snaps
  double snaps;       // what the snaps set free beyond friction: noise, vibration
  double cracks;      // what the cracks set free, at a fixed stage position (Crack, history.h)
  double
      imbalance;  // stage_work less the sum of the others; zero but for rounding and quadrature. The work of a stretch is
                  // integrated and not made from the others, so that this is a check
};

// The account at the end of a further stretch, of a test that starts with the straight fibre.
EnergyAccount account_after(const EnergyAccount& account, const StretchWork& work, const PathPoint& end,
                            const Rig& rig);

// ∫ F dw: what is read off a force-deflection curve as work of fracture, times area. Part of it is friction and snaps, part went into
// cracks, and what remains is the bending energy, of which unloading gives back what friction does not take.
double work_of_fracture(const EnergyAccount& account);

}  // namespace flexslip
