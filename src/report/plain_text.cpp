#include "report/plain_text.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace flexslip {
namespace {

// Where the first word ends; a percent sign belongs to its number.
std::size_t end_of_word(std::string_view text) {
  std::size_t end = text.find(' ');
  while (end < text.size() - 1 && text[end + 1] == '%') end = text.find(' ', end + 1);
  return std::min(end, text.size());
}

}  // namespace

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string padded_right(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, width_of(text)), ' ');
}

std::string padded_left(std::string_view text, std::size_t width) {
  return std::string(width - std::min(width, width_of(text)), ' ') + std::string(text);
}

std::string wrapped(std::string_view text, std::string_view indent, std::string_view begin, std::size_t most) {
  std::string out(begin);
  std::size_t length = width_of(begin);
  bool first = true;
  while (!text.empty()) {
    const std::size_t space = end_of_word(text);
    const std::string_view word = text.substr(0, space);
    text.remove_prefix(std::min(space + 1, text.size()));
    if (!first && length + 1 + width_of(word) > most) {
      out += fmt::format("\n{}", indent);
      length = width_of(indent);
    } else if (!first) {
      out += ' ';
      ++length;
    }
    first = false;
    out += word;
    length += width_of(word);
  }
  return out + '\n';
}

std::string laid_out(const PrintedTable& table) {
  std::vector<std::size_t> widths;
  for (const auto& title : table.head) widths.push_back(width_of(title));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string out;
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text = " ";
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += fmt::format("  {}", i > 0 ? padded_left(cells[i], widths[i]) : padded_right(cells[i], widths[i]));
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + '\n';
  };
  line(table.head);
  for (const auto& row : table.rows) line(row);
  return out;
}

}  // namespace flexslip
