// The points of a cyclic record, each as friction at a length of the fibre, for some bending stiffness and contact: which loop they belong
// to, and whether the fibre slides there.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "bending_test/rig.h"
#include "data/legs.h"
#include "data/record.h"

namespace flexslip::loops {

struct Calibration {
  double log_stiffness;
  std::vector<double> contact;  // [L] of each column
};

// A point of the record under a calibration, with the slopes of q.
struct Point {
  std::size_t index, leg;
  double stage, S, q;  // contact taken off; true scales
  double q_log_stiffness, q_contact, q_force;
  double stick_rate;  // dq/d(stage) at fixed S
  bool slides;
};

// A loading and the unloading after it.
struct LoopLegs {
  std::optional<std::size_t> loading, unloading;
  std::size_t column;  // of its contact
};

// Standard deviation of one reading, from second differences within the legs: no smooth curve passes for noise.
double reading_noise(const ReducedRecord& record, std::span<const Leg> legs);

std::vector<LoopLegs> pair_legs(std::span<const Leg> legs);

// The points of a record under a calibration; `columns` are the contacts of its legs.
std::vector<Point> locate(const ReducedRecord& record, const Rig& rig, double least_deflection,
                          std::span<const Leg> legs, const Calibration& calibration,
                          std::span<const std::size_t> columns);

// Of each leg the first point in `points`, and the end.
std::vector<std::size_t> leg_starts(std::span<const Point> points, std::size_t legs);

// Marks the points that stick after the turn at which a leg begins, if the fibre was in contact there. A record that begins by
// unloading begins at a turn.
void mark_stuck(std::vector<Point>& points, std::span<const Leg> legs, double force_noise);

// That of nothing is 0.
double median_or_zero(std::vector<double> values);

}  // namespace flexslip::loops
