// Long calls: without the interpreter's lock, while Ctrl-C is still heard.
#pragma once

#include <atomic>
#include <chrono>
#include <future>

#include <pybind11/pybind11.h>

#include "numerics/effort.h"

namespace flexslip::python {

// What `work` gives, computed on a thread of its own. It stops where it counts its effort, or looks at whether it should.
// Fails:      as `work`; with what the handler of a signal raises, KeyboardInterrupt for Ctrl-C.
template <class Work>
auto interruptible(const Work& work) {
  using namespace std::chrono_literals;
  std::atomic<bool> stop = false;
  auto answer = std::async(std::launch::async, [&] {
    const Stoppable stoppable(&stop);
    return work(stop);
  });
  bool interrupted = false;
  while (true) {
    {
      const pybind11::gil_scoped_release unlocked;
      if (answer.wait_for(interrupted ? 3600s : 20ms) == std::future_status::ready) break;
    }
    if (!interrupted && PyErr_CheckSignals() != 0) interrupted = stop = true;
  }
  if (interrupted) {
    const pybind11::error_already_set raised;
    throw raised;
  }
  return answer.get();
}

}  // namespace flexslip::python
