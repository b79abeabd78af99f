// Another program run as a child, without a shell: its arguments reach it as they are.
#pragma once

#include <string>
#include <vector>

namespace flexslip {

enum class ChildStatus {
  exited,     // all fields are valid
  not_found,  // no such program on this computer
};

struct ChildResult {
  ChildStatus status;
  int exit_code;       // 128 + the signal that ended it, as shells say it
  std::string output;  // what it wrote to standard output and standard error
};

// Runs a program found on PATH in a folder and waits for it. Its standard input is empty.
// Domain:     at least the name of the program.
// Fails:      not_found; std::runtime_error if the system cannot start processes; Stopped (effort.h), the child being ended then.
ChildResult run_child(const std::vector<std::string>& command, const std::string& folder);

}  // namespace flexslip
