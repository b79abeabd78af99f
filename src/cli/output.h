// What a command writes, to a file or the terminal, the progress it shows there, and how it is interrupted.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include <CLI/CLI.hpp>

#include "report/draw.h"
#include "report/fit_document.h"
#include "result/table.h"

namespace flexslip {

struct Output {
  std::string path = "-";  // of the results; "-" is standard output
  bool json = false;
  bool quiet = false;
};

// Gives a command an option that names a file to write, and announces the file (CallFiles) before the command reads any.
CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& path, const std::string& help);

// Gives a command the options --json, --output and --quiet.
void add_output_options(CLI::App& command, Output& output);

// Gives a command the option --figure.
void add_figure_option(CLI::App& command, std::string& path);

// Draws a figure; without gnuplot a remark says that only its script and data are there.
void draw_for(const Output& output, const Plot& plot, const std::string& path);

// As wide as the terminal, and in colour on one, unless NO_COLOR is set; of results that go into a file, as a file has them.
ScreenStyle screen_style(const Output& output);

// A remark on standard error: what was assumed, left out or cut short.
void note(const Output& output, std::string_view remark);

// Ctrl-C and SIGTERM as a request to stop, so that what is done is kept.

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

// What is done, and the time left, on standard error.

// How much of a work is done. May be called on any thread, as often as one likes.
using ProgressFunction = std::function<void(std::uint64_t done, std::uint64_t all)>;

// Shows it a few times a second, or in a log once a minute: "1200 of 5000 designs, 12 s left". Empty if the output is quiet.
ProgressFunction progress_of(const std::string& what, const Output& output);

// While one lives, a terminal is shown what is being done and for how long, from half a second on. Nothing if the output is quiet or no terminal.
class Busy {
 public:
  Busy(std::string what, const Output& output);
  ~Busy();
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  void show(const std::string& what);

  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_over_ = false;
  std::thread shown_;
};

// Text as one word of a shell's command line.

// As it is, if no shell would read it otherwise; else in single quotes.
std::string shell_word(std::string_view text);

}  // namespace flexslip
