// The effect of the loading nose on the middle of a specimen (theory.md, "Two supports").
#pragma once

namespace flexslip {

// Whether friction at the nose fixes the middle of a specimen with unequal forces on its sides.
enum class Nose {
  holds,  // both sides slide equally
  free,   // the nose has no friction, or turns: the weaker side slides
};

// [1] The distance that a sliding support travels on the specimen, relative to the sliding length
// of both supports. It is 1 if one support slides at a time.
constexpr double share_of_sliding(Nose nose) { return nose == Nose::holds ? 0.5 : 1; }

}  // namespace flexslip
