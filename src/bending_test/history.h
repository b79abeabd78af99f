// What a test measures: the path of states through a programme of stage positions, with its snaps and its energy account.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "bending_test/cracking_fibre.h"
#include "bending_test/energy.h"
#include "bending_test/motion.h"
#include "contact/two_supports.h"

namespace flexslip {

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
  PathPoint before, after;  // at the same length, but for what cracking_fibre.h says
  double released;          // [EI/L]
};

struct History {
  HistoryStatus status;  // unless ok, the path holds the points before, and the account all that happened up to the end
  std::vector<PathPoint> path;
  std::vector<EnergyAccount> energy_at;  // at each point of the path
  std::vector<ContactPoints> contacts;   // likewise, on two supports that are not alike; else none
  std::vector<Snap> snaps;
  std::vector<CrackOpened> cracks;
  EnergyAccount energy;  // at the end
};

// Of the stage positions or turning points of a programme so many are done. Called after each.
using HistoryProgress = std::function<void(std::uint64_t done, std::uint64_t all)>;

// The states at given stage positions: loading, unloading, reloading, in any order; a position repeated is a halt. A test starts
// with the straight fibre at stage 0. Cracks happen as cracking_fibre.h says; all is in units of the first bending stiffness.
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

}  // namespace flexslip
