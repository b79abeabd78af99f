#include "cli/output.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "io/text.h"
#include "io/text_file.h"
#include "platform/terminal.h"

namespace flexslip {

void draw_for(const Output& output, const Plot& plot, const std::string& path) {
  if (const Drawing drawing = draw(plot, path); !drawing.is_done())
    note(output, drawing.why_not + ": the script and data of the figure are written, but no picture");
}

void write_words(const Output& output, const std::function<Json()>& all, const std::function<std::string()>& words) {
  if (output.json)
    write_json(output.path, all());
  else
    write_text(output.path, words());
}

ScreenStyle screen_style(const Output& output) {
  if (output.path != "-" || !is_terminal(Stream::output)) return {};
  constexpr std::size_t narrowest = 40, widest = 160;
  ScreenStyle style{.width = line_length, .colour = std::getenv("NO_COLOR") == nullptr};
  if (const auto width = terminal_width()) style.width = std::clamp(*width, narrowest, widest);
  return style;
}

void note_pictures(const Output& output, const Drawing& drawing) {
  if (!drawing.is_done())
    note(output,
         drawing.why_not + ": pictures are missing from the report, which holds the scripts and data of all figures");
}

void note(const Output& output, std::string_view remark) {
  if (!output.quiet) std::cerr << fmt::format("flexslip: {}\n", printable(remark));
}

namespace {

std::atomic<bool> is_interrupted = false;

void request_to_stop(int) {
  if (is_interrupted.exchange(true)) std::_Exit(exit_interrupted);  // a second request
}

}  // namespace

WhileInterruptible::WhileInterruptible()
    : on_interrupt_(std::signal(SIGINT, request_to_stop)), on_terminate_(std::signal(SIGTERM, request_to_stop)) {}

WhileInterruptible::~WhileInterruptible() {
  std::signal(SIGINT, on_interrupt_);
  std::signal(SIGTERM, on_terminate_);
}

const std::atomic<bool>& interrupted() { return is_interrupted; }

namespace {

std::string in_words(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  const double minutes = seconds / 60;
  return minutes < 100 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.1f} h", minutes / 60);
}

// A progress message, limited to a readable rate.
class ShownProgress {
 public:
  explicit ShownProgress(bool is_terminal)
      : is_terminal_(is_terminal), next_(Clock::now() + (is_terminal ? after : once_a_minute)) {}
  ~ShownProgress() {
    if (is_shown_) std::cerr << erase << std::flush;
  }
  ShownProgress(const ShownProgress&) = delete;
  ShownProgress& operator=(const ShownProgress&) = delete;

  // Shows words() if it is time. Thread-safe.
  template <class Words>
  void say(const Words& words) {
    if (Clock::now() < next_.load(std::memory_order_relaxed)) return;
    const std::lock_guard lock(mutex_);
    if (is_terminal_)
      std::cerr << fmt::format("{}{}\r", erase, words()) << std::flush;
    else
      std::cerr << words() << std::endl;
    is_shown_ = is_terminal_;
    next_ = Clock::now() + (is_terminal_ ? often : once_a_minute);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds after{500}, often{200}, once_a_minute{60'000};
  static constexpr std::string_view erase = "\x1b[K";  // clears the rest of the line

  bool is_terminal_, is_shown_ = false;
  std::atomic<Clock::time_point> next_;
  std::mutex mutex_;
};

// The progress of counted work.
class Counted {
 public:
  Counted(std::string what, bool is_terminal) : what_(std::move(what)), shown_(is_terminal) {}

  void say(std::uint64_t done, std::uint64_t all) {
    std::call_once(begun_, [&] { start_ = Clock::now(); });
    shown_.say([&] {
      most_ = std::max(most_, done);  // other threads may be ahead
      const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
      const double left = seconds * static_cast<double>(all - most_) / static_cast<double>(most_);
      return fmt::format("{} of {} {}, {} left", most_, all, what_, in_words(left));
    });
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  ShownProgress shown_;
  std::once_flag begun_;
  Clock::time_point start_;  // when the first item was done
  std::uint64_t most_ = 0;
};

}  // namespace

ProgressFunction progress_of(const std::string& what, const Output& output) {
  if (output.quiet) return {};
  return [counted = std::make_shared<Counted>(what, is_terminal(Stream::errors))](
             std::uint64_t done, std::uint64_t all) { counted->say(done, all); };
}

std::unique_ptr<Watch> shown_stages(const std::string& what, const Output& output) {
  if (output.quiet || !is_terminal(Stream::errors)) return nullptr;
  return std::make_unique<Watch>([what, shown = std::make_shared<ShownProgress>(true)](const Reached& reached) {
    shown->say([&] { return fmt::format("{}, {:.0f} %: {}", what, std::floor(100 * reached.share), reached.stage); });
  });
}

std::string shell_word(std::string_view text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./,:@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'')
      word += R"('\'')";
    else
      word += c;
  }
  return word + "'";
}

}  // namespace flexslip
