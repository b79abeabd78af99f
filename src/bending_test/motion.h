// The motion of the specimen as the stage moves: sticking, sliding, or a snap; and the energies.
//
// The state of a test is (S, q), which determines deflection, force and stage position. Moving the
// stage changes q at fixed S while friction suffices (stick). Then the specimen slides in along q =
// μ(S), or out along q = -μ(S). Where the curve folds back it snaps, at constant stage position. A
// programme is therefore a chain of segments between events, independent of stage speed and steps
// (theory.md, "Any history").
#pragma once

#include <optional>
#include <vector>

#include "bending_test/rig.h"
#include "bending_test/shallow.h"
#include "bending_test/sliding_table.h"
#include "bending_test/snap.h"
#include "contact/friction.h"

namespace flexslip {

// The test: a specimen with friction on a rig.

// Where a snap ends.
enum class SnapRest {
  // at the next stable state, q = μ_k: released energy is lost at once (the paper's postulate,
  // (4.32))
  nearest_stable,
  // Where friction has dissipated the released energy, possibly after oscillation; |q| is then
  // below the static friction. After 1,000 oscillations, or if only a friction above 20 would hold
  // the specimen, as nearest_stable.
  overshoot,
};

struct BendingTest {
  // on two different supports without static excess, at rest at the nearest stable state
  FrictionLaw friction;
  Rig rig;
  SnapRest rest = SnapRest::nearest_stable;
  double wear = 1;  // [1] factor on friction at each reversal (CrackingFibre), in (0, 1]
};

// Segments of a path.

// A segment between two events, or to the requested stage position.
struct Stretch {
  // to.motion is the motion of the segment: stick has constant S, a snap constant stage
  PathPoint from, to;
  StretchWork jump = {};  // of a snap or a crack; for others see work_of

  bool is_jump() const { return from.stage == to.stage; }
};

enum class HistoryStatus {
  ok,
  // the stage position exceeds every equilibrium: the specimen slips through the supports
  slipped_through,
  contact_lost,  // during a snap outwards the force reaches zero
};

// [L] Shorter slips continue into the next: a nanometre for a span of a millimetre. Otherwise
// static friction on a straight specimen would cause infinitely many slips, of a length
// proportional to w^3.
inline constexpr double min_slip = 1e-6;

class MovingFibre {
 public:
  // Starts straight, at stage position 0, and may move up to `farthest` [L].
  // Domain:     rig.stiffness > 0, farthest >= 1e-6, static friction <= 20 everywhere; test as
  //             described there; no static excess on rollers; std::invalid_argument otherwise.
  MovingFibre(BendingTest test, double farthest);

  // Starts at a length and a stage position, where friction may not suffice: see settle(). If not
  // even a friction of 20 suffices, at the smallest length at which it does. Without one, the
  // specimen has slipped through.
  // Domain:     there.stage >= 0; there.S >= 1, unless shallow (shallow.h): then with its friction.
  MovingFibre(BendingTest test, double farthest, const PathPoint& there);

  const PathPoint& state() const { return state_; }
  HistoryStatus end() const { return end_; }

  // The friction on the current path. On two different supports it changes when sliding reverses
  // (two_supports.h).
  const FrictionLaw& friction() const { return test_.friction; }

  // The snap (or slip, with static excess) to rest if friction does not hold the specimen. Empty if
  // it does, or if the specimen slips through or loses contact: see end(). Energy released in a
  // shallow state counts as friction.
  std::optional<Stretch> settle();

  // Multiplies static and kinetic friction by a factor. Call settle() afterwards.
  // Domain:     as Friction::scaled.
  void scale_friction(double factor);

  // The next segment towards a stage position; empty on arrival, or if end() states a reason.
  // Domain:     0 <= stage <= farthest; std::invalid_argument otherwise.
  // Max error:  the rounding of the stage position, for events (end of stick, folds, landings).
  // Cost:       a few µs; the first in a sliding direction traces its curve (trace.h).
  std::optional<Stretch> advance_towards(double stage);

  // The energies of a segment of the current path, or a part of it; call before the next one.
  // Max error:  as sliding_table.h.
  StretchWork work_of(const Stretch& stretch);

  // The segment in n - 1 parts of equal length: in the sliding coordinate while sliding, in q while
  // sticking, in w while shallow. A segment at constant stage position is one part.
  // Domain:     n >= 2; a segment of this specimen.
  std::vector<Stretch> parts_of(const Stretch& stretch, int n);

  // The stage position at a deflection within a segment of sticking or sliding in.
  // Domain:     stretch.from.w <= w <= stretch.to.w, with a rising deflection.
  // Max error:  the rounding of the stage position.
  double stage_at_deflection(const Stretch& stretch, double w) const;

  // A state to return to after a look ahead.
  struct Position;
  Position position() const;
  void return_to(const Position& position);

  // Stops the stage: sliding stops, and static friction applies again.
  void halt() { glide_.reset(); }

 private:
  // Continued sliding: friction remains kinetic at least up to a length.
  struct Glide {
    Sliding sliding;
    double to_S;  // [L] infinite: until the stage reverses or stops
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
  void start_path(Sliding sliding);
  void retrace();

  BendingTest test_;
  double farthest_;
  SlidingCurve in_;
  std::optional<SlidingCurve> out_;
  SlidingTable table_in_, table_out_;
  PathPoint state_{};
  RigPoint here_{};  // the last point on a curve
  HistoryStatus end_ = HistoryStatus::ok;
  std::optional<Glide> glide_;
};

struct MovingFibre::Position {
  PathPoint state;
  RigPoint here;
  HistoryStatus end;
  std::optional<Glide> glide;
};

// The energies.

// Energies in EI/L, accumulated from the start of a test.
struct EnergyAccount {
  double stage_work;  // ∫ F d(stage)
  double bending;     // bending energy of the specimen
  double load_train;  // F^2/(2k)
  double friction;    // heat: ∫ q Pn dS while sliding, ∫ μ Pn |dS| in snaps
  double snaps;       // released in snaps beyond friction: noise, vibration
  double cracks;      // released in cracks, at constant stage position (Crack, history.h)
  // stage_work minus the other energies: zero except for rounding and quadrature. The work of a
  // segment is integrated independently of the other energies, so this is a check.
  double imbalance;
};

// The account after another segment of a test that starts straight.
EnergyAccount account_after(const EnergyAccount& account, const StretchWork& work, const PathPoint& end,
                            const Rig& rig);

// ∫ F dw, the work of fracture (area under the curve). It includes friction, snaps, cracks and
// the bending energy, a part of which unloading recovers.
double work_of_fracture(const EnergyAccount& account);

}  // namespace flexslip
