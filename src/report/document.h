// A document for people: chapters of text, rows, tables and pictures, composed once and laid out
// for a terminal and for a page.
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

// Labels with their text. Rows without text are omitted.
using Rows = std::vector<AnswerRow>;

// Blocks that appear only on a page: figures, drawn when the page is written; text for machines,
// kept line by line; and a list of the accompanying files.
struct Pictures {
  std::function<std::vector<Plot>(double width)> plots;  // width [mm] of the widest figures (in_width)
};
struct Verbatim {
  std::string text;
};
struct AccompanyingFiles {
  Rows files;
};

using Block = std::variant<std::string, Rows, PrintedTable, Pictures, Verbatim, AccompanyingFiles>;

// A chapter. It is omitted if its blocks are empty. A chapter without a title follows the answer
// directly.
struct Chapter {
  std::string title;
  std::vector<Block> blocks;
  Folding folding = Folding::never;  // always: a page shows its title, and the rest on request
};

// ---- Text for a terminal

inline constexpr std::size_t line_length = 100;  // [characters] if the output is no terminal

// The chapters in lines of `width` characters. Tables of numbers may be wider.
std::string in_text(const std::vector<Chapter>& chapters, std::size_t width = line_length);

// The width of a line on a terminal [characters]: neither bytes nor the codes of colours count.
std::size_t width_of(std::string_view text);

// A line of at most `width` characters; a longer one is cut at a space and ends in " …".
// Domain:     width > 2.
std::string cut_to(const std::string& line, std::size_t width);

// Breaks a text at spaces into lines of `length` characters. The first line begins with `begin`,
// the others with `indent`.
std::string wrapped(std::string_view text, std::string_view indent, std::string_view begin = "",
                    std::size_t length = line_length);

}  // namespace flexslip
