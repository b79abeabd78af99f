// The test that a case describes, computed forward: what it would measure, and what there is to say of that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bending_test/history.h"
#include "case/case_file.h"
#include "case/problem.h"
#include "case/simulation.h"
#include "data/record.h"
#include "data/scales.h"

namespace flexslip {

struct SimulationOptions {
  int points = 200;        // on each stretch of sticking or sliding, where the stage moves continuously; at least 2
  double noise = 0;        // [N] standard deviation of the force readings, in the units of the case
  std::uint64_t seed = 1;  // of the noise
  HistoryProgress progress = {};
};

// What was followed, on supports that friction is met on: what figures are drawn of.
struct FollowedTest {
  BendingTest bending_test;
  History history;
  std::vector<double> stages;  // [L] between which the stage moved, or at which it stood
  bool in_steps;
  LegOptions legs;
};

struct SimulatedTest {
  bool reduced, in_inches;  // as the case
  Scales scales;
  Simulation simulation;
  std::optional<FollowedTest> followed;  // none on rollers that roll loose: no snaps, no heat, no history
  std::vector<std::string> remarks;      // sentences
  std::string why_it_ends;               // before its programme does; "" if it does not
};

// Friction is made ready for stage positions up to `farthest` [L], of which figures may ask beyond the programme.
// Fails:      InputError as bending_test_of; for a path that does not fit into a gigabyte; on rollers that roll loose also for cracks, and for a
//             friction of the other support.
SimulatedTest simulate(const Case& input, const SimulationOptions& options, double farthest = 0);

// The test as a picture shows it: of a stage in steps also between its readings.
// Domain:     a test that was followed. So for the next.
struct SimulatedPortrait {
  History history;
  std::vector<Leg> legs;  // of its path
  SlidingLimits limits;
};
SimulatedPortrait portrait_of(const SimulatedTest& test, const std::vector<Crack>& cracks);

// Its overall equilibria at some stage positions [L].
OverallPortrait overall_portrait(const SimulatedTest& test, std::span<const double> stages);

}  // namespace flexslip
