#include "report/screen.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "data/names.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::string_view bold = "\x1b[1m", yellow = "\x1b[33m", plain = "\x1b[0m";
constexpr std::size_t row_margin = 18;  // [characters] before the words of a row (document.cpp)

Rows shortened(Rows rows, std::size_t width) {
  for (AnswerRow& row : rows)
    for (std::size_t end = row.words.rfind("; "); !fits_row(row.words, width) && end != std::string::npos;
         end = row.words.rfind("; "))
      row.words.resize(end);
  return rows;
}

std::size_t lines_of(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::string laid_out(const Screen& screen, const Rows& rows, const ScreenStyle& style) {
  const auto text_of = [&](const Block& block) { return in_text({{"", {block}}}, style.width); };
  const std::string doubts = text_of(screen.doubts), table = text_of(screen.table);
  const std::string text = text_of(rows) +
                           (style.colour && !doubts.empty() ? fmt::format("{}{}{}", yellow, doubts, plain) : doubts) +
                           text_of(screen.next) + (table.empty() ? "" : "\n" + table) + text_of(screen.footer);
  return screen.title + (text.empty() ? "" : "\n" + text);
}

}  // namespace

std::string in_text(const Screen& screen, const ScreenStyle& style) {
  if (style.is_full) return laid_out(screen, screen.rows, style);
  Rows rows = shortened(screen.rows, style.width);
  std::string text = laid_out(screen, rows, style);
  while (rows.size() > 1 && lines_of(text) > max_screen_lines) {
    rows.pop_back();
    text = laid_out(screen, rows, style);
  }
  return text;
}

std::size_t free_lines(const Screen& screen, const ScreenStyle& style) {
  return max_screen_lines - std::min(max_screen_lines, lines_of(in_text(screen, style)));
}

std::string screen_title(std::string_view name, std::string_view sentence, const std::vector<std::string>& below,
                         const ScreenStyle& style) {
  const std::string shown = printable(name);
  std::string title =
      wrapped(sentence, "  ", style.colour ? fmt::format("{}{}{}: ", bold, shown, plain) : shown + ": ", style.width);
  for (const std::string& line : below)
    if (!line.empty()) title += wrapped(line, "  ", "  ", style.width);
  return title;
}

std::string verdict_word(VerdictCode code, const ScreenStyle& style) {
  constexpr auto green = "\x1b[1;32m", amber = "\x1b[1;33m", red = "\x1b[1;31m";
  if (!style.colour) return std::string(word_of(code));
  return fmt::format("{}{}{}",
                     name_in_order<VerdictCode::no_answer>(code, {green, amber, amber, red, amber, green, red, red}),
                     word_of(code), plain);
}

bool fits_row(std::string_view words, std::size_t width) { return width_of(words) + row_margin <= width; }

std::string cut_to_row(const std::string& words, std::size_t width) {
  return cut_to(words, width > row_margin ? width - row_margin : 0);
}

}  // namespace flexslip
