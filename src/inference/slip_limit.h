// How far the force can fall by a slip, where a specimen is bent too little to tell its friction.
#pragma once

#include <span>
#include <vector>

#include "data/drops.h"
#include "data/record.h"
#include "fibre/supported_state.h"

namespace flexslip {

// The friction between 0 and this that a slip may lose altogether.
inline constexpr double most_lost_friction = 1;

// [L] Where a specimen of less height is bent too little to tell friction, its span or a unit is wrong.
inline constexpr double least_height_of_a_bar = 1.0 / 200;

// For each drop, the most that the force can have fallen there by a slip, in units of the force of the record: what friction along the specimen, inwards
// or outwards, can hold of it at any deflection up to that, less what the specimen gains by moving on. Whatever the bending stiffness is: a part of
// the force before.
// Domain:     drops of the record; supports as state_on_supports.
// Accuracy:   that of the map; all of the force where there is no state of so much friction, or of none.
// Source:     theory.md, "What a slip can do to a bar"; of a stocky bar over small deflections 1.5 μ h/L of the force.
std::vector<double> most_by_slips(const ReducedRecord& record, std::span<const Drop> drops, const Supports& supports);

// Is a fall of the force surely more than the most that a slip can make, for the noise of a reading? All in one unit of force.
bool is_beyond_slips(double fall, double most, double noise);

}  // namespace flexslip
