#include "cli/interruption.h"

#include <csignal>
#include <cstdlib>

namespace flexslip {
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

}  // namespace flexslip
