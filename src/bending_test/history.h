// Simulated tests: the states along a programme of stage positions, with snaps, cracks and the
// energy account; stages that move in steps; and curves for figures.
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

// Cracks: where the deflection first reaches a given value, the bending stiffness decreases, at
// once, everywhere and permanently.
//
// A crack is faster than sliding: stage position and length are constant, the deflection increases,
// and the force falls along the load line. Equilibrium then requires more friction; if friction is
// too small, the specimen slides in, in a snap. At small deflection, or with little stiffness left,
// not even largest_q may suffice. The specimen then slides in during the crack until largest_q
// suffices, and the friction energy of this part counts as released by the crack. Static friction
// applies again after a crack. A smaller EI is equivalent to a stiffer rig in reduced units
// (theory.md, "Cracks").
//
// Wear: at each reversal of the stage, static and kinetic friction decrease by a factor everywhere.
// If the lower friction cannot hold the specimen, it slides at once, in a snap. After p reversals
// friction is wear^p of its initial value. A stop is not a reversal.

struct Crack {
  // [L] deflection at the crack; if a snap or another crack passes it, the crack follows that
  double w;
  double loss;  // [1] relative loss of the remaining bending stiffness, in (0, 1)
};

// Moves as MovingFibre, with cracks as additional segments, and wear. Units refer to the initial
// bending stiffness.
class CrackingFibre {
 public:
  // Domain:     as MovingFibre; cracks in any order, w > 0, loss in (0, 1); wear in (0, 1];
  //             std::invalid_argument otherwise.
  CrackingFibre(BendingTest test, std::vector<Crack> cracks, double farthest);

  PathPoint state() const { return in_first_units(fibre_.state()); }
  HistoryStatus end() const { return fibre_.end(); }
  const FrictionLaw& friction() const { return fibre_.friction(); }

  // As in MovingFibre. The energy released by a crack is the energy of specimen and rig before it
  // minus that after it.
  // Max error:  rounding, for the deflection of a crack.
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
  std::vector<Crack> cracks_;  // remaining cracks, the next one last
  double left_ = 1;
  bool due_ = false;               // the next crack is due
  bool has_to_settle_ = false;     // after a crack or wear
  Sliding towards_ = Sliding::in;  // direction of the last stage movement
  MovingFibre fibre_;
};

// A jump at constant stage position: a line of slope -k in (w, F).
struct Snap {
  double stage;  // [L]
  PathPoint before, after;
  double friction;  // [EI/L] heat
  double released;  // [EI/L] released beyond friction
};

// A crack: also a jump along a line of slope -k; a snap may follow.
struct CrackOpened {
  double stage;             // [L]
  PathPoint before, after;  // at equal length, except as described at Crack
  double released;          // [EI/L]
};

// The simulated path and its events.
struct TestPath {
  HistoryStatus status;  // unless ok, the path ends early
  std::vector<PathPoint> path;
  // at each point, for two different supports; otherwise empty
  std::vector<ContactPoints> contacts;
  std::vector<Snap> snaps;
  std::vector<CrackOpened> cracks;
};

// A path with its energies.
struct History : TestPath {
  std::vector<EnergyAccount> energy_at;  // at each point of the path
  EnergyAccount energy;                  // at the end
};

// Called after each stage position or turning point, with the number done and the total.
using HistoryProgress = std::function<void(std::uint64_t done, std::uint64_t all)>;

// The states at given stage positions, in any order: loading, unloading, reloading; a repeated
// position is a stop. A test starts with the straight specimen at stage 0. Units refer to the
// initial bending stiffness.
// Domain:     cracks as in CrackingFibre; stages finite and >= 0, the maximum at least 1e-6;
//             std::invalid_argument with the index otherwise.
// Max error:  as MovingFibre. The energy account closes to 1e-10 + 2^-48/(S - 1) of its largest
//             energy, with S the smallest length at a reversal; S - 1 loses digits when nearly
//             straight.
// Fails:      slipped_through, contact_lost.
History follow_in_steps(const BendingTest& test, std::span<const double> stages, const std::vector<Crack>& cracks = {},
                        const HistoryProgress& progress = {});

// The path through the turning points of a programme, with n points on each segment of sticking or
// sliding. The points include the ends, so events are exact.
// Domain:     turning points as stages above, n >= 2; std::invalid_argument otherwise.
History follow_continuously(const BendingTest& test, std::span<const double> turning_points, int n,
                            const std::vector<Crack>& cracks = {}, const HistoryProgress& progress = {});

// The same for a specimen without cracks, without energies, which double the cost.
TestPath path_in_steps(const BendingTest& test, std::span<const double> stages);
TestPath path_continuously(const BendingTest& test, std::span<const double> turning_points, int n);

// A stage that moves in steps.

// The stage positions of a programme in steps: each turning point, and every step in between. The
// last step before a turning point may be shorter.
// Units:      any, equal for turns and step.
// Domain:     at least one turn; step > 0; at most 1e8 positions; std::invalid_argument otherwise.
std::vector<double> stage_steps(std::span<const double> turns, double step);

// Curves for figures, fine enough for every wave and knot of the friction.

// The specimen without a rig, up to a length (Figs. 7 and 8A).
struct EquilibriumPortrait {
  std::vector<EquilibriumPoint> in, out;        // q = μ and q = -μ
  std::vector<EquilibriumPoint> frictionless;   // q = 0
  std::vector<EquilibriumPoint> at_one_length;  // all frictions at 0.7 of the length range
};

// Domain: S_max > 1.
EquilibriumPortrait portrait_of(const Friction& friction, const Fibre& fibre, double S_max);

// The sliding curves of the first two passes of a test, up to its final state.
struct SlidingLimits {
  // `out` is empty if friction depends on the reversal point
  std::vector<EquilibriumPoint> in, out;
};
SlidingLimits limits_of(const BendingTest& test, const History& history);

// The overall equilibria at given stage positions [L], on the curve for sliding in (Fig. 8B).
// Domain:     at least one stage position, each as for overall_equilibria.
struct OverallPortrait {
  std::vector<EquilibriumPoint> in;
  std::vector<std::vector<OverallEquilibrium>> at_stage;
};
OverallPortrait overall_portrait(const Friction& friction, const Rig& rig, std::span<const double> stages);

// The curve without friction from the straight specimen: (0, 0), then sliding_up_to, with its
// domain.
std::vector<EquilibriumPoint> frictionless_up_to(double deflection, int n, const Fibre& fibre = {});

}  // namespace flexslip
