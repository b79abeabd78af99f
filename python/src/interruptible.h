// Long calls without the interpreter's lock, which Ctrl-C can interrupt.
#pragma once

#include <atomic>
#include <chrono>
#include <future>

#include <pybind11/pybind11.h>

#include "numerics/effort.h"

namespace flexslip::python {

// The result of `work`, computed on a separate thread. The work stops where it counts its effort or
// checks the flag.
// Fails:      as `work`; or with the exception of a signal handler, such as KeyboardInterrupt for
//             Ctrl-C.
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
