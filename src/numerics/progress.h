// The progress of the work of a thread. The work enters its stages where it does them; no signature
// mentions progress.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "numerics/effort.h"

namespace flexslip {

struct Reached {
  std::string_view stage;  // the current activity, in words
  // [1] share of the whole that is usually done by now; from 0 to 1, never decreasing
  double share;
};

// While a Watch lives, it calls `report` on this thread with the progress of its work: at each
// stage, and after every `every` states. Within a stage the share grows with the effort spent,
// scaled by the effort of the stages before: linearly up to half of the expected effort, then ever
// more slowly.
class Watch {
 public:
  static constexpr std::uint64_t every = 100'000;  // [states] a few ms

  explicit Watch(std::function<void(const Reached&)> report);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  friend class Effort;
  friend class Stages;
  // The current activity, and the share of the whole before and after it.
  struct Stretch {
    std::string_view stage;
    double from, to;  // [1]
  };
  void begin(const Stretch& next);
  void notify();
  double share() const;

  std::function<void(const Reached&)> report_;
  Watch* before_;
  std::uint64_t begun_, entered_;  // [states] the effort spent at that moment
  Stretch now_{"", 0, 1};
};

// Consecutive stages of a piece of work. Together they make up the current stage of the enclosing
// work. Without a Watch they do nothing.
class Stages {
 public:
  Stages();
  // Ends the piece. If it ended early, its omitted stages count as done.
  ~Stages();
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  // Begins a stage and ends the one before. An empty name keeps the name of the enclosing work.
  // Domain:     `share` [1] of the time of the piece, as measured (bench/stages); the sum is at
  //             most 1. The name outlives the Watch.
  void enter(std::string_view name, double share);

 private:
  Watch* watch_;
  Watch::Stretch whole_;
  double done_ = 0, next_ = 0;  // [1] share of the piece
};

}  // namespace flexslip
