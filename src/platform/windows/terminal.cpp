#include "platform/terminal.h"

#include <io.h>
#include <windows.h>

namespace flexslip {

bool is_terminal(Stream stream) { return _isatty(stream == Stream::output ? 1 : 2) != 0; }

std::optional<std::size_t> terminal_width() {
  CONSOLE_SCREEN_BUFFER_INFO screen{};
  if (!GetConsoleScreenBufferInfo(GetStdHandle(STD_OUTPUT_HANDLE), &screen)) return std::nullopt;
  return static_cast<std::size_t>(screen.srWindow.Right - screen.srWindow.Left + 1);
}

void end_with_reader() {}  // Windows has no signal for a closed reader

}  // namespace flexslip
