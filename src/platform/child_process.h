// Running another program without a shell, so that it receives its arguments unchanged.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace flexslip {

enum class ChildStatus {
  exited,     // all fields are valid
  not_found,  // no such program on this computer
  too_long,   // stopped at the limit; the output up to then is valid
};

struct ChildResult {
  ChildStatus status;
  int exit_code;       // 128 + the signal number after a signal, as in shells
  std::string output;  // of standard output and standard error
};

struct ChildOptions {
  std::string folder = ".";                    // working folder of the program
  std::chrono::milliseconds limit{};           // of the running time; 0: no limit
  std::vector<std::string> unset_variables{};  // environment variables hidden from the program
};

// Runs a program found on PATH and waits for it. Its standard input is empty.
// Domain:     at least the name of the program.
// Fails:      not_found; too_long; std::runtime_error if the system cannot start processes; Stopped
//             (effort.h), which also ends the child.
ChildResult run_child(const std::vector<std::string>& command, const ChildOptions& options = {});

}  // namespace flexslip
