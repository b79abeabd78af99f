#include "platform/terminal.h"

#include <csignal>
#include <cstdlib>

#include <sys/ioctl.h>
#include <unistd.h>

namespace flexslip {

bool is_terminal(Stream stream) { return isatty(stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO) == 1; }

std::optional<std::size_t> terminal_width() {
  if (winsize size{}; ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return std::nullopt;
}

void end_with_reader() {
  std::signal(SIGPIPE, [](int) { std::_Exit(EXIT_SUCCESS); });
}

}  // namespace flexslip
