#include "io/text_table.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "io/cells.h"
#include "io/input_error.h"
#include "io/table_source.h"

namespace flexslip {
namespace {

[[noreturn]] void refuse(const std::string& file, std::size_t line, std::string expected, std::string found,
                         std::string remedy) {
  throw InputError({.file = file,
                    .line = line,
                    .expected = std::move(expected),
                    .found = std::move(found),
                    .remedy = std::move(remedy)});
}

bool is_like_formula(std::string_view words) {
  const std::size_t first = words.find_first_not_of('\'');
  return first != std::string_view::npos && std::string_view("=+-@").find(words[first]) != std::string_view::npos;
}

// What without_formula was given.
std::string as_meant(std::string words) {
  if (words.starts_with('\'') && is_like_formula(words)) words.erase(0, 1);
  return words;
}

std::vector<std::string> cells_of(const TableSource& source, std::size_t number, std::string_view line,
                                  char delimiter) {
  const std::string& file = source.name;
  std::vector<std::string> cells;
  CellReader reader(line, delimiter);
  while (const auto cell = reader.next()) {
    cells.push_back(as_meant(unescaped(*cell)));
    if (source.sheet && is_dated(source.sheet->kinds.at(number, cells.size())))
      throw source.sheet->dated(file, number, cells.size(), std::strtod(cells.back().c_str(), nullptr),
                                "a number or words");
  }
  if (reader.broken())
    refuse(file, number, "quotes in pairs around a whole cell",
           fmt::format("a stray quote in cell {}", cells.size() + 1), "delete it");
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

// The length of the valid UTF-8 character that a text begins with [bytes]; 0 if there is none.
std::size_t character_at(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  if (length < 3) return length;
  const std::uint32_t second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90) ||
                            (first == 0xef && second == 0xbf && byte(2) >= 0xbe);
  return overlong || no_character ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = character_at(text);
    const auto first = static_cast<unsigned char>(text.front());
    if (length == 0)
      out += "\ufffd";
    else if (first < ' ' || first == 0x7f || (first == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0))
      out += ' ';
    else
      out += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::string without_formula(std::string_view words) { return (is_like_formula(words) ? "'" : "") + std::string(words); }

TextTable read_text_table(const std::string& path) {
  const TableSource source = open_table(path, {}, SheetFor::words);
  TextTable table{.source = source.name, .header_line = 0, .titles = {}, .rows = {}};
  LineReader lines(*source.text, table.source);
  char delimiter = ',';
  while (const auto line = lines.next()) {
    if (is_comment_or_blank(*line)) continue;
    if (!table.titles.empty()) {
      table.rows.push_back({lines.number(), cells_of(source, lines.number(), *line, delimiter)});
      auto& cells = table.rows.back().cells;
      if (cells.size() > table.titles.size())
        refuse(table.source, lines.number(), fmt::format("{} cells, as the header has", table.titles.size()),
               fmt::format("{}", cells.size()), "put a cell that holds the delimiter in quotes");
      cells.resize(table.titles.size());
      continue;
    }
    delimiter = delimiter_of(*line);
    if (delimiter == ' ') delimiter = ',';  // one column
    table.titles = cells_of(source, lines.number(), *line, delimiter);
    table.header_line = lines.number();
  }
  if (table.titles.empty()) refuse(table.source, 0, "a header line that names the columns", "an empty file", "");
  for (auto title = table.titles.begin(); title != table.titles.end(); ++title) {
    if (title->empty()) refuse(table.source, table.header_line, "a title for every column", "an empty one", "");
    if (std::find(table.titles.begin(), title, *title) != title)
      refuse(table.source, table.header_line, "each title once", in_quotes(*title) + " twice", "");
  }
  return table;
}

}  // namespace flexslip
