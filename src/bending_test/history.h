// What a test measures: the path of states through a programme of stage positions, with its snaps and its
// energy account; specimens that crack; stages that move in steps; and the curves that pictures show.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "bending_test/equilibrium.h"
#include "bending_test/motion.h"
#include "bending_test/rig.h"
#include "contact/two_supports.h"

namespace flexslip {

// A specimen that cracks while it is bent: where the deflection first reaches some values its bending stiffness falls, at once, all
// along it and for good.
//
// A crack is faster than the specimen slides: stage position and length stay, the deflection rises, and the force falls along the load
// line. So more friction has to hold the specimen, and where there is not so much, it is drawn in, in a snap. Hardly bent, or with little
// of its stiffness left, it may need any friction: where not even largest_q would hold it, it is drawn in as it cracks, to where that does,
// and what friction takes on that way counts as set free by the crack. Static friction holds again after a crack. Less EI is the same fibre
// on a rig that is stiffer in the reduced units (theory.md, "Cracks").
//
// A specimen that wears: at each turn of the stage friction falls to a share of what it was, at rest and in sliding, everywhere along the
// specimen. Where the lower friction does not hold the specimen, it slides at once until it does, in a snap. So on the pass after p turns friction
// is wear^p of that of the test. A halt is no turn.

struct Crack {
  double w;     // [L] the deflection at which it happens; one that a snap or another crack passes happens at its end
  double loss;  // [1] of the bending stiffness left, in (0, 1)
};

// Moves as MovingFibre does, with cracks as stretches among the others, and wears. All is in units of the first bending stiffness.
class CrackingFibre {
 public:
  // Domain: as MovingFibre; cracks in any order, w > 0, loss in (0, 1); wear in (0, 1]; std::invalid_argument otherwise.
  CrackingFibre(BendingTest test, std::vector<Crack> cracks, double farthest);

  PathPoint state() const { return in_first_units(fibre_.state()); }
  HistoryStatus end() const { return fibre_.end(); }
  const FrictionLaw& friction() const { return fibre_.friction(); }

  // As those of MovingFibre. The energy that a crack sets free is that of fibre and rig before it less that after.
  // Max error:  of the deflection of a crack, its rounding.
  std::optional<Stretch> advance_towards(double stage);
  StretchWork work_of(const Stretch& stretch);
  std::vector<Stretch> parts_of(const Stretch& stretch, int n);
  void halt() { fibre_.halt(); }

 private:
  PathPoint in_first_units(PathPoint point) const;
  Stretch in_first_units(const Stretch& stretch) const;
  StretchWork in_first_units(const StretchWork& work) const;
  std::optional<Stretch> advance_to_next(double stage);
  Stretch crack();
  void wear_at_turn(double stage);
  Rig rig() const { return {test_.rig.stiffness / left_, test_.rig.fibre}; }

  BendingTest test_;
  double farthest_;
  std::vector<Crack> cracks_;  // to come, the next one last
  double left_ = 1;
  bool due_ = false;               // the next crack
  bool has_to_settle_ = false;     // after a crack, or worn
  Sliding towards_ = Sliding::in;  // where the stage moved last
  MovingFibre fibre_;
};

// A jump at constant stage position: in (w, F) a line of slope -k.
struct Snap {
  double stage;  // [L]
  PathPoint before, after;
  double friction;  // [EI/L] heat
  double released;  // [EI/L] what it sets free beyond friction
};

// Likewise a jump along a line of slope -k; the specimen may snap from where it ends.
struct CrackOpened {
  double stage;             // [L]
  PathPoint before, after;  // at the same length, but for what is said at Crack
  double released;          // [EI/L]
};

// What happened on the way.
struct TestPath {
  HistoryStatus status;  // unless ok, the path ends before
  std::vector<PathPoint> path;
  std::vector<ContactPoints> contacts;  // at each point, on two supports that are not alike; else none
  std::vector<Snap> snaps;
  std::vector<CrackOpened> cracks;
};

// With where the energy went.
struct History : TestPath {
  std::vector<EnergyAccount> energy_at;  // at each point of the path
  EnergyAccount energy;                  // at the end: all that happened up to there
};

// Of the stage positions or turning points of a programme so many are done. Called after each.
using HistoryProgress = std::function<void(std::uint64_t done, std::uint64_t all)>;

// The states at given stage positions: loading, unloading, reloading, in any order; a position repeated is a halt. A test starts
// with the straight fibre at stage 0. Cracks happen as said at Crack; all is in units of the first bending stiffness.
// Domain:     cracks as there; stages finite and >= 0, the greatest at least 1e-6; std::invalid_argument, naming the index, otherwise.
// Max error:  as MovingFibre; the energy account closes to 1e-10 + 2^-48/(S - 1) of the greatest energy in it, S being
//             the least length at which the stage turned: near the straight fibre S - 1 has few digits.
// Fails:      slipped_through, contact_lost.
History follow_in_steps(const BendingTest& test, std::span<const double> stages, const std::vector<Crack>& cracks = {},
                        const HistoryProgress& progress = {});

// The whole path through the turning points of a programme: n points on each stretch of sticking or sliding, its ends among
// them, so that reversals, the ends of sticking, snaps and cracks are exact.
// Domain:     turning points as stages above, n >= 2; std::invalid_argument otherwise.
History follow_continuously(const BendingTest& test, std::span<const double> turning_points, int n,
                            const std::vector<Crack>& cracks = {}, const HistoryProgress& progress = {});

// The same two of a specimen that does not crack, without the energies, whose integrals cost as much as the rest of the way.
TestPath path_in_steps(const BendingTest& test, std::span<const double> stages);
TestPath path_continuously(const BendingTest& test, std::span<const double> turning_points, int n);

// A stage that moves in steps.

// The stage positions of a programme that is moved through in steps: each turning point, and between two of them every step from the one
// before; the last may be shorter.
// Units:      any, of turns and step alike.
// Domain:     at least one turn; step > 0, and not so small that the positions fill the memory: std::invalid_argument otherwise.
std::vector<double> stage_steps(std::span<const double> turns, double step);

// The curves of a specimen and its friction as a picture shows them: fine enough for every wave and every knot of the friction.

// The specimen by itself, up to a length (Figs. 7 and 8A).
struct EquilibriumPortrait {
  std::vector<EquilibriumPoint> in, out;        // q = μ and q = -μ
  std::vector<EquilibriumPoint> frictionless;   // q = 0
  std::vector<EquilibriumPoint> at_one_length;  // with every friction it may have, seven tenths of the way
};

// Domain: S_max > 1.
EquilibriumPortrait portrait_of(const Friction& friction, const Fibre& fibre, double S_max);

// The curves on which the specimen slides in a test, as far as it goes: of the first two passes.
struct SlidingLimits {
  std::vector<EquilibriumPoint> in, out;  // none out of a friction that depends on where the specimen turns back
};
SlidingLimits limits_of(const BendingTest& test, const History& history);

// The overall equilibria at some stage positions [L] on the curve on which the specimen slides in (Fig. 8B).
// Domain: at least one stage position, each as overall_equilibria.
struct OverallPortrait {
  std::vector<EquilibriumPoint> in;
  std::vector<std::vector<OverallEquilibrium>> at_stage;
};
OverallPortrait overall_portrait(const Friction& friction, const Rig& rig, std::span<const double> stages);

// The curve without friction, from the straight fibre on: (0, 0), and sliding_up_to, whose domain it has.
std::vector<EquilibriumPoint> frictionless_up_to(double deflection, int n, const Fibre& fibre = {});

}  // namespace flexslip
