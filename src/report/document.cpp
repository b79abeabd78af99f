#include "report/document.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/text.h"

namespace flexslip {
namespace {

std::string padded(std::string_view text, std::size_t width, bool to_the_right) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return to_the_right ? space + std::string(text) : std::string(text) + space;
}

// The end of the first word; a percent sign belongs to its number.
std::size_t end_of_word(std::string_view text) {
  std::size_t end = text.find(' ');
  while (end < text.size() - 1 && text[end + 1] == '%') end = text.find(' ', end + 1);
  return std::min(end, text.size());
}

std::string laid_out(const PrintedTable& all, std::size_t width) {
  const PrintedTable table = picked(all);
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    widths.push_back(width_of(table.head[i]));
    for (const auto& row : table.rows) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  const std::size_t last = table.head.size() - 1;
  const bool ends_in_words = last > 0 && !is_of_numbers(table, last);
  std::string out;
  const auto add = [&](const std::vector<std::string>& cells) {
    std::string line = " ";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string cell = printable(cells[i]);
      line += "  ";
      // Words that exceed the line continue below it with an indent, if there is room.
      constexpr std::size_t min_room = 30;
      if (const std::size_t indent = width_of(line);
          i == last && ends_in_words && !all.is_cut && indent + min_room <= width)
        line = wrapped(cell, std::string(indent, ' '), line, width);
      else
        line += padded(cell, widths[i], is_of_numbers(table, i));
    }
    line.erase(line.find_last_not_of(" \n") + 1);
    out += (all.is_cut ? cut_to(line, width) : line) + '\n';
  };
  add(table.head);
  for (const auto& row : table.rows) add(row);
  return out;
}

struct AsText {
  bool has_title;
  std::size_t width;

  std::string operator()(const std::string& words) const {
    const std::string indent(has_title ? 3 : 0, ' ');
    return words.empty() ? "" : wrapped(words, indent, indent, width);
  }
  std::string operator()(const Rows& rows) const {
    // A longer label has its own line if its text does not fit on the same one.
    constexpr std::size_t usual = 30, margins = 6;
    std::size_t label_width = 13;
    for (const auto& [label, words] : rows)
      if (!words.empty() && (width_of(label) <= usual || width_of(label) + width_of(words) + margins <= width))
        label_width = std::max(label_width, width_of(label));
    const std::string indent(has_title ? 3 : 2, ' ');
    std::string out;
    for (const auto& [label, words] : rows) {
      if (words.empty()) continue;
      const bool is_wide = width_of(label) > label_width;
      if (is_wide) out += indent + label + '\n';
      const std::string begin = fmt::format("{}{}   ", indent, padded(is_wide ? "" : label, label_width, false));
      out += wrapped(printable(words), std::string(width_of(begin), ' '), begin, width);
    }
    return out;
  }
  std::string operator()(const PrintedTable& table) const { return table.rows.empty() ? "" : laid_out(table, width); }
  template <class OnAPageAlone>
  std::string operator()(const OnAPageAlone&) const {
    return "";
  }
};

// True if an empty line separates two blocks: around tables, and after the answer.
bool are_apart(const Block& above, const Block& below, const Chapter& chapter) {
  const auto is_table = [](const Block& block) { return std::holds_alternative<PrintedTable>(block); };
  return is_table(above) || is_table(below) ||
         (chapter.title.empty() && std::holds_alternative<std::string>(above) && std::holds_alternative<Rows>(below));
}

}  // namespace

std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  bool is_colour = false;  // within an escape sequence, "\x1b[1;31m"
  for (const char c : text) {
    is_colour = is_colour || c == '\x1b';
    if (!is_colour && (c & 0xc0) != 0x80) ++width;
    if (c == 'm') is_colour = false;
  }
  return width;
}

std::string cut_to(const std::string& line, std::size_t width) {
  if (width_of(line) <= width) return line;
  const std::string begin = wrapped(line, "", "", width - 2);
  return begin.substr(0, begin.find('\n')) + " …";
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

std::string in_text(const std::vector<Chapter>& chapters, std::size_t width) {
  std::string out;
  for (const Chapter& chapter : chapters) {
    std::string words;
    const Block* above = nullptr;
    for (const Block& block : chapter.blocks) {
      const std::string text = std::visit(AsText{!chapter.title.empty(), width}, block);
      if (text.empty()) continue;
      if (above && are_apart(*above, block, chapter)) words += '\n';
      words += text;
      above = &block;
    }
    if (words.empty()) continue;
    if (!out.empty() || !chapter.title.empty()) out += '\n';
    if (!chapter.title.empty()) out += chapter.title + "\n";
    out += words;
  }
  return out;
}

}  // namespace flexslip
