#include "instruments/layout.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "instruments/column_words.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "io/statistics_rows.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t misfit_share = 10;  // one line in so many may be damaged: more, and the rows are not understood
constexpr std::size_t longest_unit = 16;  // [bytes] a line with longer words is none of units

using Cells = std::span<const std::string_view>;

bool is_blank(Cells cells) {
  return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty(); });
}

bool has_number(std::string_view cell) { return !number_cell(cell).number.empty(); }

// ---- rows

// A row as most are: which of its columns hold numbers, one character each, "101", and how many cells it has.
struct UsualRow {
  std::string pattern;
  std::size_t numbers, cells;
};

std::string pattern_of(Cells cells) {
  std::string pattern;
  for (const std::string_view cell : cells) pattern += has_number(cell) ? '1' : '0';
  pattern.erase(pattern.find_last_of('1') + 1);
  return pattern;
}

// The columns with numbers of most lines, by their numbers, and the cells that most of these lines have.
UsualRow usual_row(const Sheet& sheet) {
  std::map<std::string, std::map<std::size_t, std::size_t>> lines_with;  // a pattern, and so many cells
  for (std::size_t line = 0; line < sheet.size(); ++line)
    if (!sheet.is_comment(line)) ++lines_with[pattern_of(sheet.cells(line))][sheet.cells(line).size()];
  UsualRow usual{};
  std::size_t most = 0;
  for (const auto& [pattern, lines_of] : lines_with) {
    std::size_t lines = 0;
    for (const auto& [cells, count] : lines_of) lines += count;
    const auto numbers = static_cast<std::size_t>(std::count(pattern.begin(), pattern.end(), '1'));
    if (numbers * lines <= most) continue;
    most = numbers * lines;
    const auto longest = std::max_element(lines_of.begin(), lines_of.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    usual = {pattern, numbers, longest->first};
  }
  if (most == 0)
    throw InputError({.expected = "rows of numbers",
                      .found = sheet.size() == 0 ? "an empty file" : "no line with numbers",
                      .remedy = "export the raw data of the test as CSV"});
  return usual;
}

// Numbers in most of the columns, or in some and nothing in the others.
bool is_row(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  if (sheet.is_comment(line)) return false;
  std::size_t numbers = 0;
  std::size_t words = 0;
  for (std::size_t i = 0; i < usual.pattern.size(); ++i) {
    if (usual.pattern[i] != '1') continue;
    const std::string_view cell = sheet.at(line, i);
    if (has_number(cell))
      ++numbers;
    else if (!says_missing(cell))
      ++words;
  }
  return 2 * numbers > usual.numbers || (numbers > 0 && words == 0);
}

bool fits(Cells cells, const UsualRow& usual) {
  if (cells.size() < usual.pattern.size()) return false;
  return cells.size() <= usual.cells || is_blank(cells.subspan(usual.cells));
}

// Is a line between rows one with damaged cells: all of them, and some numbers, or each says that it is missing?
bool is_damaged_row(Cells cells, const UsualRow& usual) {
  return cells.size() == usual.cells &&
         (std::any_of(cells.begin(), cells.end(), has_number) || std::all_of(cells.begin(), cells.end(), says_missing));
}

// ---- names and units

bool is_unit_line(Cells cells) {
  std::size_t units = 0;
  std::size_t others = 0;
  for (const std::string_view cell : cells) {
    const bool counts_nothing = cell.empty() || cell == "-" || cell == "1";
    if (counts_nothing) continue;
    if (cell.size() > longest_unit) return false;
    ++(names_a_unit(cell) && !has_number(cell) ? units : others);
  }
  return units > others;
}

bool means_something(std::string_view title) { return role_of(title_parts(title).name) != ColumnRole::other; }

// The titles on a line: as many words as columns and no numbers, or two that mean something. Empty if it has none.
std::vector<std::string> titles_on(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  std::string_view text = trimmed(sheet.text(line));
  const Cells cells = sheet.cells(line);
  std::vector<std::string> titles(cells.begin(), cells.end());
  if (sheet.is_comment(line)) {  // "# time force": its cells are those behind the mark
    text = trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())));
    titles.front().erase(0, titles.front().find_first_not_of("# \t"));
    if (titles.front().empty()) titles.erase(titles.begin());
  }
  while (titles.size() > usual.cells && titles.back().empty()) titles.pop_back();
  if (titles.size() != usual.cells) titles = split_titles(text, usual.cells);
  std::size_t words = 0;
  std::size_t units = 0;
  std::size_t meant = 0;
  for (const std::string& title : titles) {
    if (has_number(title)) return {};
    if (!says_missing(title)) ++words;
    if (names_a_unit(title)) ++units;
    if (means_something(title)) ++meant;
  }
  // A comment that means nothing is prose, unless it gives each column its unit, as Gwyddion does: "# x [m]  y [m]".
  const bool have_units = std::all_of(titles.begin(), titles.end(),
                                      [](const std::string& title) { return names_a_unit(title_parts(title).unit); });
  const bool is_prose = sheet.is_comment(line) && meant == 0 && !have_units;
  const bool are_units = units > 1 && 2 * units > words;
  if (is_prose || are_units || (words < 2 && usual.cells > 1) || words == 0) return {};
  return 2 * words >= usual.numbers || meant >= 2 ? titles : std::vector<std::string>{};
}

bool begins_table(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  const Cells cells = sheet.cells(line);
  if (is_unit_line(cells) && cells.size() <= usual.cells + 1 && 2 * cells.size() >= usual.cells) return true;
  const std::vector<std::string> titles = titles_on(sheet, line, usual);
  return sheet.is_comment(line) ? std::any_of(titles.begin(), titles.end(), means_something) : !titles.empty();
}

// The titles on two lines, where cells are merged downwards: what means something and stands above a cell that is empty is its title.
std::vector<std::string> titles_on_two_lines(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  const Cells above = sheet.cells(line - 1), below = sheet.cells(line);
  if (above.size() != usual.cells || below.size() != usual.cells || sheet.is_comment(line)) return {};
  std::vector<std::string> titles(below.begin(), below.end());
  bool is_merged = false;
  std::size_t words = 0;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const bool is_title_above = titles[i].empty() && means_something(above[i]);
    if (is_title_above) titles[i] = above[i];
    is_merged = is_merged || is_title_above;
    if (has_number(titles[i]) || names_a_unit(below[i])) return {};  // units may be fewer than titles
    if (!titles[i].empty()) ++words;
  }
  return is_merged && words > 1 ? titles : std::vector<std::string>{};
}

// A table that begins with a row: names and units are the last of the lines above it that belong to none.
TableBlock begun_at(const Sheet& sheet, std::size_t row, std::vector<std::size_t> above, const UsualRow& usual) {
  TableBlock block{.header_line = row};
  if (!above.empty() && is_unit_line(sheet.cells(above.back()))) {
    const Cells cells = sheet.cells(above.back());
    block.header_line = above.back();
    if (fits(cells, usual))
      for (std::size_t i = 0; i < usual.cells; ++i)
        block.units.emplace_back(without_brackets(sheet.at(block.header_line, i)));
    above.pop_back();
  }
  if (!above.empty()) {
    const std::size_t line = above.back();
    block.titles = titles_on(sheet, line, usual);
    if (above.size() > 1 && above[above.size() - 2] + 1 == line)
      if (std::vector<std::string> both = titles_on_two_lines(sheet, line, usual); !both.empty())
        block.titles = std::move(both);
    if (!block.titles.empty()) {
      block.header_line = line;
      above.pop_back();
    }
  }
  block.remarks = std::move(above);
  return block;
}

// ---- rows that are no readings

// A number before the marks are known: those of a column are wrong by one factor, if at all.
double roughly(const Sheet& sheet, std::size_t line, std::size_t column) {
  const std::string_view number = number_cell(sheet.at(line, column)).number;
  const bool has_comma = std::count(number.begin(), number.end(), ',') == 1;
  return sheet.number(line, column, {has_comma && number.find('.') == std::string_view::npos ? ',' : '.', '\0'});
}

Layout without_statistics(const Sheet& sheet, Layout layout) {
  for (TableBlock& block : layout.blocks) {
    std::vector<std::vector<double>> columns;
    for (std::size_t column = 0; column < layout.numeric.size(); ++column) {
      if (!layout.numeric[column]) continue;
      std::vector<double>& numbers = columns.emplace_back();
      for (const std::size_t line : block.rows) numbers.push_back(roughly(sheet, line, column));
    }
    auto [rows, notes] = statistics_among(sheet, block.rows, columns);
    block.rows = without_rows(std::move(block.rows), rows);
    layout.notes.insert(layout.notes.end(), notes.begin(), notes.end());
  }
  return layout;
}

}  // namespace

Layout layout_of(const Sheet& sheet) {
  const UsualRow usual = usual_row(sheet);
  Layout layout{.columns = usual.cells, .numeric = std::vector<bool>(usual.cells)};
  for (std::size_t i = 0; i < usual.pattern.size(); ++i) layout.numeric[i] = usual.pattern[i] == '1';
  std::vector<std::size_t> gap;  // lines since the last row that are none
  for (std::size_t line = 0; line < sheet.size(); ++line) {
    const Cells cells = sheet.cells(line);
    const bool is_one = is_row(sheet, line, usual);
    const bool begins = layout.blocks.empty() || (is_one && std::any_of(gap.begin(), gap.end(), [&](std::size_t each) {
                                                    return begins_table(sheet, each, usual);
                                                  }));
    // A line of numbers among the remarks above a table is not its first row: that fits.
    if (!is_one || (begins && !fits(cells, usual))) {
      if (is_one || !is_blank(cells)) gap.push_back(line);
      continue;
    }
    if (begins) {
      layout.blocks.push_back(begun_at(sheet, line, std::exchange(gap, {}), usual));
    } else {
      TableBlock& block = layout.blocks.back();
      for (const std::size_t each : std::exchange(gap, {}))
        if (!sheet.is_comment(each))
          (is_damaged_row(sheet.cells(each), usual) ? block.rows : block.misfits).push_back(each);
    }
    TableBlock& block = layout.blocks.back();
    (fits(cells, usual) ? block.rows : block.misfits).push_back(line);
  }
  if (layout.blocks.empty())
    throw InputError({.expected = "rows of numbers", .found = "no row with as many cells as the others"});
  TableBlock& last = layout.blocks.back();
  // The end of a file that was cut off: words or a short row as its last line.
  if (!last.misfits.empty() && last.misfits.back() > last.rows.back() && gap.empty()) {
    last.misfits.pop_back();
    layout.cut_off = true;
  } else if (gap.size() == 1 && gap.back() + 1 == sheet.size() && has_number(sheet.at(gap.back(), 0)) &&
             sheet.cells(gap.back()).size() < usual.cells) {
    gap.clear();
    layout.cut_off = true;
  }
  layout.remarks = std::move(gap);
  for (const TableBlock& block : layout.blocks)
    if (block.misfits.size() * misfit_share > block.rows.size())
      throw InputError(
          {.line = block.misfits.front() + 1,
           .expected = fmt::format("rows of {} cells", layout.columns),
           .found = fmt::format("{} lines with more or fewer cells, beside {} rows", block.misfits.size(),
                                block.rows.size()),
           .remedy = "name the separator with --separator, or delete the lines that do not belong to the table"});
  return without_statistics(sheet, std::move(layout));
}

}  // namespace flexslip
