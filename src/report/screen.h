// The screen of an answer on a terminal: a title, rows of one line each, doubts, the next step, and
// a footer.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "finding/finding.h"
#include "report/document.h"
#include "report/table.h"

namespace flexslip {

// The layout of a screen.
struct ScreenStyle {
  std::size_t width = line_length;  // [characters]
  bool colour = false;              // bold names, and colours for verdicts and doubts, for terminals
  bool is_full = false;             // all rows and doubts with all their clauses
};

// The lines of a screen without --full, on a terminal of 100 characters or more.
inline constexpr std::size_t max_screen_lines = 12;

struct Screen {
  std::string title;     // whole lines
  Rows rows;             // in order of importance
  Rows doubts{};         // after the rows
  Rows next{};           // after the doubts
  PrintedTable table{};  // after an empty line
  std::string footer;    // one line
};

// The screen as text. Unless full, rows lose the last clauses that do not fit on one line, and the
// last rows are omitted if there are too many lines.
std::string in_text(const Screen& screen, const ScreenStyle& style);

// The number of lines that the screen leaves to more rows of its table.
std::size_t free_lines(const Screen& screen, const ScreenStyle& style);

// "name: sentence" and the lines below it, each wrapped to the width.
std::string screen_title(std::string_view name, std::string_view sentence, const std::vector<std::string>& below,
                         const ScreenStyle& style);

// The word of a verdict, in its colour if the style has colours.
std::string verdict_word(VerdictCode code, const ScreenStyle& style);

// True if a row with these words needs one line only.
bool fits_row(std::string_view words, std::size_t width);

// Words that fit on the line of a row; longer ones end in " …".
std::string cut_to_row(const std::string& words, std::size_t width);

}  // namespace flexslip
