// The loading and unloading legs of a record: a stage programme with turning points, cut at them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace flexslip {

enum class Direction { loading, unloading };  // the stage advances, or goes back

struct Leg {
  std::size_t first, last;  // points [first, last); the turning point is the last of the leg that it ends
  Direction direction;
};

struct LegOptions {
  double least_travel = 0.02;  // [range of the stage] a turn counts once the stage has gone back by more; shorter
                               // excursions are noise, backlash or a hold, and belong to the leg they interrupt
};

// Legs in the order of time, loading and unloading in turn; together they are all points. None for a stage that stands still.
// Domain: stage finite, in any unit; 0 < least_travel < 1. std::invalid_argument otherwise.
// Method: a turning point is the farthest position before a return of more than least_travel; of equal ones the first. So noise
//         of the stage shifts it by no more than its own size, and cannot make one if its range is below least_travel.
// Cost:   one pass.
std::vector<Leg> find_legs(std::span<const double> stage, const LegOptions& options = {});

}  // namespace flexslip
