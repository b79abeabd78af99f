// How far the work of a thread has come, for whoever waits for it: work enters its stages where it does them, and no signature knows of it.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "numerics/effort.h"

namespace flexslip {

struct Reached {
  std::string_view stage;  // what is being done, in words
  double share;            // [1] what is usually done of the whole by then; between 0 and 1, and never less than before
};

// While it lives, `told` hears on this thread what its work has reached: at each stage, and in between every so much effort.
// Within a stage the share grows by the effort spent, by what the stages before it took: evenly up to half of what is expected, then ever more slowly.
class Watch {
 public:
  static constexpr std::uint64_t every = 100'000;  // [states] a few ms

  explicit Watch(std::function<void(const Reached&)> told);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  friend class Effort;
  friend class Stages;
  // What is being done takes the whole from one share to another.
  struct Stretch {
    std::string_view stage;
    double from, to;  // [1]
  };
  void go_on_with(const Stretch& next);
  void tell();
  double share() const;

  std::function<void(const Reached&)> told_;
  Watch* before_;
  std::uint64_t begun_, entered_;  // [states] spent until then
  Stretch now_{"", 0, 1};
};

// Stages of a piece of work, one after the other: together they are the stage of the work that it is a piece of. Where nobody watches,
// they do nothing.
class Stages {
 public:
  Stages();
  // The piece is over; if it ended early, what it left out counts as done.
  ~Stages();
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  // Ends the stage before. An empty name is that of the work as a whole.
  // Domain:     `share` [1] of the piece, of its time as measured (bench/stages); all together at most 1. The name outlives the Watch.
  void enter(std::string_view name, double share);

 private:
  Watch* watch_;
  Watch::Stretch whole_;
  double done_ = 0, next_ = 0;  // [1] of the piece
};

}  // namespace flexslip
