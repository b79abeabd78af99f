// The track of a test through a figure, and arrows on it that say which way it goes.
#pragma once

#include <span>
#include <vector>

#include "bending_test/history.h"
#include "data/legs.h"

namespace flexslip {

struct TrackPoint {
  double w, F, S, q;
  Motion motion;        // by which it was reached
  Direction direction;  // of the stage
};

inline bool is_sticking(const TrackPoint& point) { return point.motion == Motion::stick; }

std::vector<TrackPoint> track_of(const History& history, std::span<const Leg> legs);

struct Panel {
  double x, y;    // reduced extents of the axes
  double aspect;  // height over width
};

struct Spot {
  double x, y;  // [width of the panel]
};

// Where a point of the track stands in a panel: of force over deflection, and of mobilised friction over length.
using Projection = Spot (*)(const TrackPoint& point, const Panel& panel);
Spot in_force(const TrackPoint& point, const Panel& panel);
Spot in_friction(const TrackPoint& point, const Panel& panel);

struct Arrow {
  Spot from, to;
};

// On each leg of one direction of the stage, and on each long stretch of sticking, none too near to another.
std::vector<Arrow> arrows_on(const std::vector<TrackPoint>& track, Projection projection, const Panel& panel,
                             Direction direction);

}  // namespace flexslip
