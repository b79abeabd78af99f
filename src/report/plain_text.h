// How text is laid out on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "finding/printed.h"

namespace flexslip {

// Characters, not bytes.
std::size_t width_of(std::string_view text);

// With spaces up to a width, after or before it.
std::string padded_right(std::string_view text, std::size_t width);
std::string padded_left(std::string_view text, std::size_t width);

inline constexpr std::size_t line_length = 100;  // characters, where there is no terminal

// Breaks a text at spaces, to lines of so many characters; lines after the first begin with the indent, the first with `begin`.
std::string wrapped(std::string_view text, std::string_view indent, std::string_view begin = "",
                    std::size_t length = line_length);

// First column to the left, the others to the right.
std::string laid_out(const PrintedTable& table);

}  // namespace flexslip
