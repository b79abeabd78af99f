// The terminal of this process.
#pragma once

#include <cstddef>
#include <optional>

namespace flexslip {

enum class Stream { output, errors };

bool is_terminal(Stream stream);

// Columns of the terminal of standard output; empty without a terminal.
std::optional<std::size_t> terminal_width();

// A reader that closes standard output, such as `head`, ends this process without an error.
void end_with_reader();

}  // namespace flexslip
