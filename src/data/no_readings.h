// Invalid readings of a record: spikes, dropouts, lost packets, and readings beyond the range of
// the load cell.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/record.h"

namespace flexslip {

// Points with an invalid force. The force leaves its course, upwards or downwards, and returns
// within three points. Its rise exceeds what the load train allows for the stage travel.
// Domain:     at least 11 points, in loading; stiffness [N/m] > 0 of the load train. If it is
//             infinite, three times the steepest rise of the smooth curve replaces it.
// Fails:      empty if more than a twentieth of the points qualify: the force then fluctuates, and
//             its readings are valid.
// Method:     the threshold is six standard deviations of a step, from the noise of quiet parts and
//             from the median step.
std::vector<std::size_t> find_spikes(const Record& record, double stiffness);

// Points with an invalid position. It jumps by more than 20 typical steps and 20 neighbouring
// steps, and returns within three points. A longer excursion is invalid if all its positions are
// equal while the force continues: the logger then wrote a code for a missing value.
// Domain:     columns of equal length, in any unit.
// Fails:      empty if more than a twentieth of the points qualify, or more than half with such a
//             code: the stage then moves to and fro.
std::vector<std::size_t> find_stray_positions(std::span<const double> stage, std::span<const double> force);

// Readings taken while the stage is stationary, except the first at each position; rising.
// Domain:     stage in any unit.
// Method:     points within 0.5 % of the median step of the first one share a position. They form a
//             hold if they are at least five and more than three times the median number per
//             position. If several readings are taken at every position, all of them count.
std::vector<std::size_t> find_halts(const std::vector<double>& stage);

// The number of points before the counter of the load cell overflows; all points if it never does.
// An overflow is a jump from nearly the largest magnitude to an equally large force of the other
// sign, which no specimen causes. At least three points must approach the limit, which
// distinguishes an overflow from a glitch.
std::size_t points_before_wrap(std::span<const double> force);

// The number of points before the load cell saturates or its counter overflows
// (points_before_wrap); all points if it never does. Saturation is a rise that ends in five or more
// points within half the noise of the maximum, where the earlier slope predicts a far larger rise.
// A specimen that yields keeps its noise, and a smooth maximum bends gradually: neither is
// saturation.
// Domain:     columns of equal length.
std::size_t points_before_overload(const Record& record);

}  // namespace flexslip
