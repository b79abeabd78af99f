// How text is laid out on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "report/printed.h"

namespace flexslip {

// Characters, not bytes.
std::size_t width_of(std::string_view text);

// With spaces up to a width, after or before it.
std::string padded_right(std::string_view text, std::size_t width);
std::string padded_left(std::string_view text, std::size_t width);

// Breaks a text at spaces, to lines of 100 characters; lines after the first begin with the indent, the first with `begin`.
std::string wrapped(std::string_view text, std::string_view indent, std::string_view begin = "");

// First column to the left, the others to the right.
std::string laid_out(const PrintedTable& table);

}  // namespace flexslip
