// Whether the loading nose holds the middle of a specimen (theory.md, "Two supports").
#pragma once

namespace flexslip {

// What a nose does with the middle of a specimen whose sides pull it unlike.
enum class Nose {
  holds,  // both sides slide alike
  free,   // it has no friction, or turns: the weaker side slides
};

// [1] Of the length that slides over both supports, that by which places on the specimen pass a support that slides: all of it where one does at a
// time.
constexpr double share_of_sliding(Nose nose) { return nose == Nose::holds ? 0.5 : 1; }

}  // namespace flexslip
