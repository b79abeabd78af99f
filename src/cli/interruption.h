// Ctrl-C and SIGTERM as a request to stop, so that what is done is kept.
#pragma once

#include <atomic>

namespace flexslip {

inline constexpr int exit_interrupted = 130;  // whichever of the two it was: what was done is kept

// While one of these lives, a first request sets interrupted(), and a second one ends the program.
class WhileInterruptible {
 public:
  WhileInterruptible();
  ~WhileInterruptible();
  WhileInterruptible(const WhileInterruptible&) = delete;
  WhileInterruptible& operator=(const WhileInterruptible&) = delete;

 private:
  using Handler = void (*)(int);
  Handler on_interrupt_, on_terminate_;  // as they were
};

const std::atomic<bool>& interrupted();

}  // namespace flexslip
