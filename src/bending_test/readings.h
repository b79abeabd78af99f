// The readings of a loading: where they stand, and what a record of them shows.
#pragma once

#include <cstddef>
#include <vector>

#include "bending_test/motion.h"

namespace flexslip {

// Which reading stands where: at every whole step of the stage, and at the end of its travel.
class ReadingPositions {
 public:
  // Domain:     travel > 0, step > 0, both finite.
  ReadingPositions(double travel, double step);

  double count() const { return last_ + 1; }  // with reading 0, of the straight fibre
  double position(double i) const { return i < last_ ? i * step_ : travel_; }
  // The first reading beyond a stage position; the one before it is the last that is not.
  double first_beyond(double stage) const;

 private:
  double travel_, step_, last_;
};

// Counts the falls of a force, a run of them being one, from its values in the order in which they are read: all of them, or those
// between which it rises or falls.
class ForceFalls {
 public:
  void read(double F);
  void end();  // a fall under way is one

  std::size_t count() const { return count_; }
  double largest() const { return largest_; }                                          // [EI/L^2] 0 without drops
  double mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0; }  // likewise

 private:
  double last_ = 0;
  double top_ = 0;
  bool falling_ = false;
  std::size_t count_ = 0;
  double sum_ = 0;
  double largest_ = 0;
};

struct RecordedForce {
  double stage;  // [L]
  double F;      // [EI/L^2]
};

// What is recorded in a loading up to a stage position, from the straight fibre on: a reading each step, all of the curve if it is 0
// or if there are more readings than a figure can tell apart, 20000. It ends where the fibre slips through.
// Domain:     travel at least 1e-6, step >= 0, both finite; std::invalid_argument otherwise.
std::vector<RecordedForce> record_of(const BendingTest& test, double travel, double step);

}  // namespace flexslip
