#include "cli/output.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "io/text_file.h"

namespace flexslip {

void draw_for(const Output& output, const Plot& plot, const std::string& path) {
  if (draw(plot, path) == DrawStatus::no_gnuplot)
    note(output, "gnuplot is not installed: the script and data of the figure are written, but no picture");
}

void write_words(const Output& output, const std::function<Json()>& all, const std::function<std::string()>& words) {
  if (output.json)
    write_json(output.path, all());
  else
    write_text(output.path, words());
}

ScreenStyle screen_style(const Output& output) {
  if (output.path != "-" || isatty(STDOUT_FILENO) != 1) return {};
  constexpr std::size_t narrowest = 40, widest = 160;
  ScreenStyle style{.width = line_length, .colour = std::getenv("NO_COLOR") == nullptr};
  if (winsize size{}; ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    style.width = std::clamp<std::size_t>(size.ws_col, narrowest, widest);
  return style;
}

void note_pictures(const Output& output, DrawStatus status) {
  if (status == DrawStatus::no_gnuplot)
    note(output, "gnuplot is not installed: the report holds the scripts and data of the figures, but no pictures");
}

void note(const Output& output, std::string_view remark) {
  if (!output.quiet) std::cerr << fmt::format("flexslip: {}\n", remark);
}

namespace {

std::atomic<bool> is_interrupted = false;

void request_to_stop(int) {
  if (is_interrupted.exchange(true)) std::_Exit(exit_interrupted);  // asked twice
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

class Display {
 public:
  // On a terminal one line is written over and over; a log gets a line a minute.
  Display(std::string what, bool is_terminal)
      : what_(std::move(what)), is_terminal_(is_terminal), often_(is_terminal ? 200 : 60'000) {}
  ~Display() {
    if (is_line_open_) std::cerr << "\n";
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  void show(std::uint64_t done, std::uint64_t all) {
    const auto now = Clock::now();
    std::call_once(begun_, [&] { start_ = now; });
    const bool is_last = is_terminal_ && done == all;
    if (now < next_.load(std::memory_order_relaxed) && !is_last) return;
    const std::lock_guard lock(mutex_);
    if (done < shown_) return;  // another thread was faster
    shown_ = done;
    next_ = now + often_;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = seconds * static_cast<double>(all - done) / static_cast<double>(done);
    const std::string words = fmt::format("{} of {} {}, {} left", done, all, what_, in_words(left));
    if (is_terminal_)
      std::cerr << fmt::format("\r{}   {}", words, is_last ? "\n" : "") << std::flush;
    else
      std::cerr << words << std::endl;
    is_line_open_ = is_terminal_ && !is_last;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  bool is_terminal_;
  std::chrono::milliseconds often_;
  std::once_flag begun_;
  Clock::time_point start_;  // when the first was done
  std::atomic<Clock::time_point> next_ = Clock::now() + often_;
  std::mutex mutex_;
  std::uint64_t shown_ = 0;
  bool is_line_open_ = false;
};

}  // namespace

ProgressFunction progress_of(const std::string& what, const Output& output) {
  if (output.quiet) return {};
  return [display = std::make_shared<Display>(what, isatty(STDERR_FILENO) == 1)](
             std::uint64_t done, std::uint64_t all) { display->show(done, all); };
}

Busy::Busy(std::string what, const Output& output) {
  if (output.quiet || isatty(STDERR_FILENO) != 1) return;
  shown_ = std::thread([this, what = std::move(what)] { show(what); });
}

Busy::~Busy() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  ended_.notify_all();
  if (shown_.joinable()) shown_.join();
}

void Busy::show(const std::string& what) {
  using namespace std::chrono_literals;
  const auto begun = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  for (auto wait = 500ms; !ended_.wait_for(lock, wait, [this] { return is_over_; }); wait = 200ms) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    std::cerr << fmt::format("\r{}, {:.1f} s; Ctrl-C ends it", what, taken.count()) << std::flush;
  }
  const bool was_shown = std::chrono::steady_clock::now() - begun > 500ms;
  if (was_shown) std::cerr << "\r\x1b[K" << std::flush;
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
