// Another program run as a child, without a shell: its arguments reach it as they are.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace flexslip {

enum class ChildStatus {
  exited,     // all fields are valid
  not_found,  // no such program on this computer
  too_long,   // ended at the limit; the output so far is valid
};

struct ChildResult {
  ChildStatus status;
  int exit_code;       // 128 + the signal that ended it, as shells say it
  std::string output;  // what it wrote to standard output and standard error
};

struct ChildOptions {
  std::string folder = ".";                    // where the program runs
  std::chrono::milliseconds limit{};           // its time; 0: any
  std::vector<std::string> unset_variables{};  // of the environment, which the program does not see
};

// Runs a program found on PATH and waits for it. Its standard input is empty.
// Domain:     at least the name of the program.
// Fails:      not_found; too_long; std::runtime_error if the system cannot start processes; Stopped (effort.h), the child being ended then.
ChildResult run_child(const std::vector<std::string>& command, const ChildOptions& options = {});

}  // namespace flexslip
