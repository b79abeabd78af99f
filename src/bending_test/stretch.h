// A part of the way that a test takes.
#pragma once

#include "bending_test/path_point.h"

namespace flexslip {

// Part of the way between two events, or to the stage position asked for.
struct Stretch {
  PathPoint from, to;  // to.motion is that of the stretch: in stick S is constant, in a snap the stage
  StretchWork work;
};

enum class HistoryStatus {
  ok,
  slipped_through,  // a stage position exceeds every equilibrium: the fibre slips through the supports
  contact_lost,     // a snap let the fibre out until no force was left
};

}  // namespace flexslip
