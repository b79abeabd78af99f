#include "instruments/layout.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "instruments/column_role.h"
#include "instruments/column_unit.h"
#include "instruments/column_words.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t misfit_share = 10;  // one line in so many may be damaged: more, and the rows are not understood
constexpr std::size_t longest_unit = 16;  // [bytes] a line with longer words is none of units

using Cells = std::span<const std::string_view>;

bool is_comment(std::string_view line) { return trimmed(line).starts_with('#'); }

bool is_blank(Cells cells) {
  return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty(); });
}

bool has_number(std::string_view cell) { return !number_cell(cell).number.empty(); }

// The columns of a line that hold numbers, one character each: "101".
std::string pattern_of(Cells cells) {
  std::string pattern;
  for (const std::string_view cell : cells) pattern += has_number(cell) ? '1' : '0';
  pattern.erase(pattern.find_last_of('1') + 1);
  return pattern;
}

class LayoutFinder {
 public:
  explicit LayoutFinder(const Sheet& sheet) : sheet_(sheet) {}

  Layout find() {
    find_pattern();
    std::size_t line = 0;
    for (; line < sheet_.size(); ++line) {
      if (is_row(line))
        take_row(line);
      else if (!is_blank(sheet_.cells(line)))
        gap_.push_back(line);
    }
    finish();
    return std::move(layout_);
  }

 private:
  // The columns with numbers of most lines, by their numbers, and the cells that most of these lines have.
  void find_pattern() {
    std::map<std::string, std::map<std::size_t, std::size_t>> lines_with;  // a pattern, and so many cells
    for (std::size_t line = 0; line < sheet_.size(); ++line)
      if (!is_comment(sheet_.text(line))) ++lines_with[pattern_of(sheet_.cells(line))][sheet_.cells(line).size()];
    std::size_t most = 0;
    for (const auto& [pattern, lines_of] : lines_with) {
      std::size_t lines = 0;
      for (const auto& [cells, count] : lines_of) lines += count;
      const auto numbers = static_cast<std::size_t>(std::count(pattern.begin(), pattern.end(), '1')) * lines;
      if (numbers <= most) continue;
      most = numbers;
      pattern_ = pattern;
    }
    if (most == 0)
      throw InputError({.expected = "rows of numbers",
                        .found = sheet_.size() == 0 ? "an empty file" : "no line with numbers",
                        .remedy = "export the raw data of the test as CSV"});
    numeric_ = static_cast<std::size_t>(std::count(pattern_.begin(), pattern_.end(), '1'));
    const auto& lines_of = lines_with[pattern_];
    const auto usual = std::max_element(lines_of.begin(), lines_of.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
    layout_.columns = usual->first;
    layout_.numeric.resize(layout_.columns);
    for (std::size_t i = 0; i < pattern_.size(); ++i) layout_.numeric[i] = pattern_[i] == '1';
  }

  // Numbers in most of the columns, or in some and nothing in the others.
  bool is_row(std::size_t line) const {
    if (is_comment(sheet_.text(line))) return false;
    const Cells cells = sheet_.cells(line);
    std::size_t numbers = 0;
    std::size_t words = 0;
    for (std::size_t i = 0; i < pattern_.size(); ++i) {
      if (pattern_[i] != '1') continue;
      const std::string_view cell = i < cells.size() ? cells[i] : std::string_view{};
      if (has_number(cell))
        ++numbers;
      else if (!says_missing(cell))
        ++words;
    }
    return 2 * numbers > numeric_ || (numbers > 0 && words == 0);
  }

  bool fits(std::size_t line) const {
    const Cells cells = sheet_.cells(line);
    if (cells.size() < pattern_.size()) return false;
    return cells.size() <= layout_.columns || is_blank(cells.subspan(layout_.columns));
  }

  void take_row(std::size_t line) {
    const bool first = layout_.blocks.empty();
    if (first || std::any_of(gap_.begin(), gap_.end(), [&](std::size_t each) { return begins_table(each); })) {
      // A line of numbers among the remarks above a table is not its first row: that fits.
      if (!fits(line)) {
        gap_.push_back(line);
        return;
      }
      layout_.blocks.emplace_back();
      take_header(layout_.blocks.back(), line);
    } else {
      for (const std::size_t each : gap_) take_misfit(each);
    }
    gap_.clear();
    if (fits(line))
      layout_.blocks.back().rows.push_back(line);
    else
      layout_.blocks.back().misfits.push_back(line);
  }

  // A line between rows with all their cells and some numbers is a row with damaged cells, one that says of each that it is missing too.
  void take_misfit(std::size_t line) {
    TableBlock& block = layout_.blocks.back();
    const Cells cells = sheet_.cells(line);
    const bool damaged =
        !is_comment(sheet_.text(line)) && cells.size() == layout_.columns &&
        (std::any_of(cells.begin(), cells.end(), has_number) || std::all_of(cells.begin(), cells.end(), says_missing));
    if (damaged)
      block.rows.push_back(line);
    else if (!is_comment(sheet_.text(line)))
      block.misfits.push_back(line);
  }

  static bool is_unit_line(Cells cells) {
    std::size_t units = 0;
    std::size_t others = 0;
    for (const std::string_view cell : cells) {
      if (cell.empty()) continue;
      const bool counts_nothing = cell == "-" || cell == "1";
      if (counts_nothing) continue;
      if (cell.size() > longest_unit) return false;
      ++(names_a_unit(cell) && !has_number(cell) ? units : others);
    }
    return units > others;
  }

  // As many words as columns and no numbers, or two that mean something.
  bool begins_table(std::size_t line) const {
    const Cells cells = sheet_.cells(line);
    if (is_unit_line(cells) && cells.size() <= layout_.columns + 1 && 2 * cells.size() >= layout_.columns) return true;
    return !titles_on(line).empty();
  }

  std::vector<std::string> titles_on(std::size_t line) const {
    std::string_view text = trimmed(sheet_.text(line));
    Cells cells = sheet_.cells(line);
    std::vector<std::string> titles;
    if (is_comment(text)) {  // "# time force": its cells are those behind the mark
      text = trimmed(text.substr(text.find_first_not_of('#') == std::string_view::npos ? text.size()
                                                                                       : text.find_first_not_of('#')));
      titles.assign(cells.begin(), cells.end());
      titles.front().erase(0, titles.front().find_first_not_of("# \t"));
      if (titles.front().empty()) titles.erase(titles.begin());
    } else {
      titles.assign(cells.begin(), cells.end());
    }
    while (titles.size() > layout_.columns && titles.back().empty()) titles.pop_back();
    if (titles.size() != layout_.columns && cells.size() != 1) titles = split_titles(text, layout_.columns);
    if (titles.size() != layout_.columns && cells.size() == 1) titles = split_titles(text, layout_.columns);
    if (titles.size() != layout_.columns) return {};
    std::size_t words = 0;
    std::size_t units = 0;
    std::size_t meant = 0;
    for (const std::string& title : titles) {
      if (has_number(title)) return {};
      if (!says_missing(title)) ++words;
      if (names_a_unit(title)) ++units;
      if (role_of(title_parts(title).name) != ColumnRole::other) ++meant;
    }
    const bool is_prose = is_comment(sheet_.text(line)) && meant == 0;
    const bool are_units = units > 1 && 2 * units > words;
    if (is_prose || are_units || (words < 2 && layout_.columns > 1) || words == 0) return {};
    return 2 * words >= numeric_ || meant >= 2 ? titles : std::vector<std::string>{};
  }

  // The titles on the last two lines of the gap, where cells are merged downwards: what means something and stands above a cell that is
  // empty is its title.
  std::vector<std::string> titles_on_two_lines() const {
    if (gap_.size() < 2 || gap_[gap_.size() - 2] + 1 != gap_.back()) return {};
    const Cells above = sheet_.cells(gap_[gap_.size() - 2]), below = sheet_.cells(gap_.back());
    if (above.size() != layout_.columns || below.size() != layout_.columns || is_comment(sheet_.text(gap_.back())))
      return {};
    std::vector<std::string> titles(below.begin(), below.end());
    bool is_merged = false;
    std::size_t words = 0;
    for (std::size_t i = 0; i < titles.size(); ++i) {
      const bool is_title_above = titles[i].empty() && role_of(title_parts(above[i]).name) != ColumnRole::other;
      if (is_title_above) titles[i] = above[i];
      is_merged = is_merged || is_title_above;
      if (has_number(titles[i]) || names_a_unit(below[i])) return {};  // units may be fewer than titles
      if (!titles[i].empty()) ++words;
    }
    return is_merged && words > 1 ? titles : std::vector<std::string>{};
  }

  // Names and units are the last lines of the gap above the first row.
  void take_header(TableBlock& block, std::size_t first_row) {
    block.header_line = first_row;
    if (!gap_.empty() && is_unit_line(sheet_.cells(gap_.back()))) {
      const Cells cells = sheet_.cells(gap_.back());
      block.header_line = gap_.back();
      const bool surplus = cells.size() > layout_.columns && !is_blank(cells.subspan(layout_.columns));
      if (cells.size() >= pattern_.size() && !surplus)
        for (std::size_t i = 0; i < layout_.columns; ++i)
          block.units.emplace_back(i < cells.size() ? without_brackets(cells[i]) : std::string_view{});
      gap_.pop_back();
    }
    if (!gap_.empty()) {
      block.titles = titles_on(gap_.back());
      if (std::vector<std::string> both = titles_on_two_lines(); !both.empty()) block.titles = std::move(both);
      if (!block.titles.empty()) {
        block.header_line = gap_.back();
        gap_.pop_back();
      }
    }
    block.remarks = std::exchange(gap_, {});
  }

  void finish() {
    if (layout_.blocks.empty())
      throw InputError({.expected = "rows of numbers", .found = "no row with as many cells as the others"});
    TableBlock& last = layout_.blocks.back();
    // The end of a file that was cut off: words or a short row as its last line.
    if (!last.misfits.empty() && last.misfits.back() > last.rows.back() && gap_.empty()) {
      last.misfits.pop_back();
      last.cut_off = true;
    } else if (gap_.size() == 1 && gap_.back() + 1 == sheet_.size() && !sheet_.cells(gap_.back()).empty() &&
               has_number(sheet_.cells(gap_.back()).front()) && sheet_.cells(gap_.back()).size() < layout_.columns) {
      gap_.clear();
      last.cut_off = true;
    }
    layout_.remarks = std::exchange(gap_, {});
    for (const TableBlock& block : layout_.blocks)
      if (block.misfits.size() * misfit_share > block.rows.size())
        throw InputError(
            {.line = block.misfits.front() + 1,
             .expected = "rows of " + std::to_string(layout_.columns) + " cells",
             .found = std::to_string(block.misfits.size()) + " lines with more or fewer cells, beside " +
                      std::to_string(block.rows.size()) + " rows",
             .remedy = "name the separator with --separator, or delete the lines that do not belong to the table"});
  }

  const Sheet& sheet_;
  Layout layout_{};
  std::string pattern_;
  std::size_t numeric_ = 0;       // columns with numbers in the pattern
  std::vector<std::size_t> gap_;  // lines since the last row that are none
};

}  // namespace

Layout layout_of(const Sheet& sheet) { return LayoutFinder(sheet).find(); }

}  // namespace flexslip
