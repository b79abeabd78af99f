// What the calculations of a thread have taken, counted where the work is done and not timed: tests bound it by the size of what is asked.
#pragma once

#include <cstdint>

namespace flexslip {

// [a state of the elastica out of a table: some 30 ns]
inline thread_local std::uint64_t effort_spent = 0;

// Of one of each, roughly, in that unit.
inline constexpr std::uint64_t effort_of_general_state = 20, effort_of_supported_state = 100;

}  // namespace flexslip
