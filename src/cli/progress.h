// What is done, and the time left, on standard error.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "cli/output.h"

namespace flexslip {

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

}  // namespace flexslip
