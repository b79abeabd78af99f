#include "cli/interruption.h"

#include <csignal>
#include <cstdlib>

namespace flexslip {
namespace {

std::atomic<bool> is_interrupted = false;

}  // namespace

WhileInterruptible::WhileInterruptible() {
  for (const int signal : {SIGINT, SIGTERM})
    std::signal(signal, [](int) {
      if (is_interrupted.exchange(true)) std::_Exit(exit_interrupted);  // asked twice
    });
}

WhileInterruptible::~WhileInterruptible() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

const std::atomic<bool>& interrupted() { return is_interrupted; }

}  // namespace flexslip
