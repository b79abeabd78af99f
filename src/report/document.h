// An answer for people, as chapters of words, rows, tables and pictures: made once, and laid out for a terminal and a page.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "finding/finding.h"
#include "report/plot.h"
#include "report/table.h"

namespace flexslip {

// Quantities with what is said of each; those without words are left out.
using Rows = std::vector<AnswerRow>;

// On a page alone: what is drawn when the page is made; what a machine reads, line by line; and files beside the page with what each holds.
struct Pictures {
  std::function<std::vector<Plot>()> plots;
};
struct Verbatim {
  std::string text;
};
struct FilesBeside {
  Rows files;
};

using Block = std::variant<std::string, Rows, PrintedTable, Pictures, Verbatim, FilesBeside>;

// A chapter of which nothing is to be shown is left out, its title too; what has no title comes right after the answer.
struct Chapter {
  std::string title;
  std::vector<Block> blocks;
};

// ---- For a terminal

inline constexpr std::size_t line_length = 100;  // characters, where there is no terminal

// Of so many characters a line, but tables of numbers, which are as wide as they are.
std::string in_text(const std::vector<Chapter>& chapters, std::size_t width = line_length);

// Characters, not bytes.
std::size_t width_of(std::string_view text);

// Breaks a text at spaces, to lines of so many characters; lines after the first begin with the indent, the first with `begin`.
std::string wrapped(std::string_view text, std::string_view indent, std::string_view begin = "",
                    std::size_t length = line_length);

}  // namespace flexslip
