#include "cli/progress.h"

#include <atomic>
#include <chrono>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace flexslip {
namespace {

std::string in_words(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  const double minutes = seconds / 60;
  return minutes < 100 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.1f} h", minutes / 60);
}

class Display {
 public:
  explicit Display(std::string what) : what_(std::move(what)) {}
  ~Display() {
    if (is_line_open_) std::cerr << "\n";
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  void show(std::uint64_t done, std::uint64_t all) {
    constexpr std::chrono::milliseconds often(200);
    const bool is_last = done == all;
    const auto now = Clock::now();
    if (now < next_.load(std::memory_order_relaxed) && !is_last) return;
    const std::lock_guard lock(mutex_);
    if (done < shown_) return;  // another thread was faster
    shown_ = done;
    next_ = now + often;
    if (!start_) start_ = now;
    const double seconds = std::chrono::duration<double>(now - *start_).count();
    const double left = seconds * static_cast<double>(all - done) / static_cast<double>(done);
    std::cerr << fmt::format("\r{} of {} {}, {} left   {}", done, all, what_, in_words(left), is_last ? "\n" : "")
              << std::flush;
    is_line_open_ = !is_last;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::optional<Clock::time_point> start_;  // when the first was done
  std::atomic<Clock::time_point> next_ = Clock::now();
  std::mutex mutex_;
  std::uint64_t shown_ = 0;
  bool is_line_open_ = false;
};

}  // namespace

ProgressFunction progress_of(const std::string& what, const Output& output) {
  if (output.quiet || isatty(STDERR_FILENO) != 1) return {};
  return
      [display = std::make_shared<Display>(what)](std::uint64_t done, std::uint64_t all) { display->show(done, all); };
}

}  // namespace flexslip
