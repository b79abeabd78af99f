// The effort of a thread: a count of the work done, independent of time. Tests bound it by the size
// of the problem. The place that counts can also stop the work and report its progress
// (progress.h), so no signature has to mention either.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>

namespace flexslip {

// Thrown by work that was stopped. This is no error, and there is no result.
struct Stopped {};

class Watch;

// A counter of work. One unit is one state of the elastica from a table, about 30 ns.
class Effort {
 public:
  constexpr Effort() = default;

  // Fails:      throws Stopped while a Stoppable of this thread is asked to stop.
  Effort& operator+=(std::uint64_t more) {
    if (stop_ && stop_->load(std::memory_order_relaxed)) throw Stopped{};
    spent_ += more;
    if (spent_ >= next_report_) notify();
    return *this;
  }
  void clear() { spent_ = 0; }  // only without a Watch
  std::uint64_t spent() const { return spent_; }

 private:
  friend class Stoppable;
  friend class Watch;
  friend class Stages;
  void notify();
  void set_watch(Watch* watch);

  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t spent_ = 0, next_report_ = never;
  const std::atomic<bool>* stop_ = nullptr;
  Watch* watch_ = nullptr;
};

inline constinit thread_local Effort effort_spent;

// The approximate effort of one state that is not tabulated.
inline constexpr std::uint64_t effort_of_general_state = 20, effort_of_supported_state = 100;

// While an object of this class lives, work of this thread throws Stopped soon after `stop` becomes
// true. nullptr has no effect.
class Stoppable {
 public:
  explicit Stoppable(const std::atomic<bool>* stop) : before_(effort_spent.stop_) {
    if (stop) effort_spent.stop_ = stop;
  }
  ~Stoppable() { effort_spent.stop_ = before_; }
  Stoppable(const Stoppable&) = delete;
  Stoppable& operator=(const Stoppable&) = delete;

  // The flag that stops work of this thread. Threads that share this work use it too.
  static const std::atomic<bool>* of_this_thread() { return effort_spent.stop_; }

 private:
  const std::atomic<bool>* before_;
};

}  // namespace flexslip
