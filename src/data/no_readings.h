// Rows of a record that no specimen can have made: spikes, dropouts, lost packets, and what lies beyond the end of the load cell.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/record.h"

namespace flexslip {

// Points whose force is none of the specimen's: it rises by more than the load train could make it rise while the stage moved so far, and comes back
// within three points; or comes back so, after it fell.
// Domain:     at least 11 points, in loading; stiffness > 0 [N/m], of the load train, infinite if it is none: then three times the steepest rise of the smooth
//             curve stands for it.
// Fails:      none where it would be more than a twentieth of the points: such a force shakes, and its readings are what they are.
// Method:     beyond six standard deviations of a step, by the noise where the record is quiet and by what half of all steps exceed.
std::vector<std::size_t> find_spikes(const Record& record, double stiffness);

// Points whose position is none of the stage's: it jumps there, by more than 20 of its usual steps and of those beside, and is back where it was within
// three points; or after however many that all say the same, while the force goes on as beside: a word of the logger for what it could not read.
// Domain:     columns of one length, in any unit.
// Fails:      none where they would be more than a twentieth of the points, or a half by such a word: such a stage goes to and fro.
std::vector<std::size_t> find_stray_positions(std::span<const double> stage, std::span<const double> force);

// Readings while the stage halts, but the first of each place; rising.
// Domain:     a stage in any unit.
// Method:     points within 0.5 % of the median step of the first of them are at one place. It is a hold if they are five or more, and
//             more than three times as many as are at a place in the median: where several readings are taken at each, all of them count.
std::vector<std::size_t> find_halts(const std::vector<double>& stage);

// How many points lie before a force leaps from nearly its greatest magnitude to as much of the other sign, as no specimen pulls: a counter that is full
// begins anew. Three points lead there; a glitch to and fro comes from nowhere. All points if it never does.
std::size_t points_before_wrap(std::span<const double> force);

// How many points a load cell shows before it is at its end: where the force rises and then stays within half of its noise of its greatest value for five
// points or more, in which it would have risen by far more than that had it gone on. What yields is as noisy as before, and a smooth top bends into its
// flat part: they are none. Or where its counter wraps (points_before_wrap). All points if it never does.
// Domain:     columns of one length.
std::size_t points_before_overload(const Record& record);

}  // namespace flexslip
