// What the calculations of a thread have taken, counted where the work is done and not timed: tests bound it by the size of what is asked.
// Whoever counts can be stopped there, and tells there how far it has come (progress.h), so that no search needs to be told of either.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>

namespace flexslip {

// Thrown by work that was stopped: no fault, and no answer.
struct Stopped {};

class Watch;

// [a state of the elastica out of a table: some 30 ns]
class Effort {
 public:
  constexpr Effort() = default;

  // Fails:      Stopped while a Stoppable of this thread is asked to stop.
  Effort& operator+=(std::uint64_t more) {
    if (stop_ && stop_->load(std::memory_order_relaxed)) throw Stopped{};
    spent_ += more;
    if (spent_ >= next_told_) tell();
    return *this;
  }
  void clear() { spent_ = 0; }  // while no Watch lives
  std::uint64_t spent() const { return spent_; }

 private:
  friend class Stoppable;
  friend class Watch;
  friend class Stages;
  void tell();
  void watched_by(Watch* watch);

  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t spent_ = 0, next_told_ = never;
  const std::atomic<bool>* stop_ = nullptr;
  Watch* watch_ = nullptr;
};

inline constinit thread_local Effort effort_spent;

// Of one of each, roughly, in that unit.
inline constexpr std::uint64_t effort_of_general_state = 20, effort_of_supported_state = 100;

// While it lives, work of this thread ends by Stopped soon after `stop` is true; nullptr: as without it.
class Stoppable {
 public:
  explicit Stoppable(const std::atomic<bool>* stop) : before_(effort_spent.stop_) {
    if (stop) effort_spent.stop_ = stop;
  }
  ~Stoppable() { effort_spent.stop_ = before_; }
  Stoppable(const Stoppable&) = delete;
  Stoppable& operator=(const Stoppable&) = delete;

  // What work of this thread is stopped by, for threads that it shares its work with.
  static const std::atomic<bool>* of_this_thread() { return effort_spent.stop_; }

 private:
  const std::atomic<bool>* before_;
};

}  // namespace flexslip
