#include "instruments/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "instruments/column_words.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "io/statistics_rows.h"
#include "io/text.h"

namespace flexslip {

bool has_number(std::string_view cell) { return !number_cell(cell).number.empty(); }

namespace {

constexpr std::size_t misfit_share =
    10;  // lines per damaged line, at least; with more damage the rows are not understood
constexpr std::size_t longest_unit = 16;  // [bytes] a line with longer words is no line of units
constexpr std::size_t looked_at = 1000;   // lines below titles examined for cells; more do not change the answer
constexpr std::size_t least_rows = 11;    // required by an evaluation (read_measurement)

using Cells = Sheet::Cells;

// The pattern of most rows: the columns with numbers, one character each, "101", and the number of
// cells.
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

// The columns with numbers in most lines, and the number of cells of most of these lines.
UsualRow usual_row(const Sheet& sheet) {
  std::map<std::string, std::map<std::size_t, std::size_t>> lines_with;  // by pattern and number of cells
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
    throw InputError({.problem = sheet.size() == 0 ? "The file is empty" : "No line of the file holds numbers",
                      .remedy = "export the raw data of the test as CSV"});
  constexpr std::size_t max_columns = 16384;  // of a sheet of Excel
  if (usual.cells > max_columns)
    throw InputError({.problem = fmt::format("a row has {} cells, and a table at most {}", usual.cells, max_columns),
                      .remedy = "write each reading on a line of its own"});
  return usual;
}

// True for numbers in most columns, or in some if the others are empty.
bool is_row(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  if (sheet.is_comment(line) || sheet.is_blank(line)) return false;
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
  // A remark behind the last column is no cell of the row.
  for (std::size_t i = usual.cells; i < cells.size(); ++i)
    if (has_number(cells[i])) return false;
  return true;
}

// True for a damaged row: all cells are present, and some hold numbers or all are reported as
// missing.
bool is_damaged_row(Cells cells, const UsualRow& usual) {
  return cells.size() == usual.cells &&
         (std::any_of(cells.begin(), cells.end(), has_number) || std::all_of(cells.begin(), cells.end(), says_missing));
}

bool is_silent_row(Cells cells, const UsualRow& usual) {
  return is_damaged_row(cells, usual) && std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
           return has_number(cell) || says_missing(cell) || says_overload(cell);
         });
}

using CellWords = std::vector<std::string>;

// ---- titles and units, matched to the columns

bool means_something(std::string_view title) { return role_of(title_parts(title).name) != ColumnRole::other; }

bool says_nothing(std::string_view title) { return !means_something(title) && title_parts(title).unit.empty(); }

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& words, std::string_view cell) {
  const std::string word = folded(trimmed(cell.substr(0, cell.find_last_not_of(": ") + 1)));
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The title of a column that counts the rows.
bool names_a_count(std::string_view title) {
  static constexpr std::array<std::string_view, 27> words{
      "",       "#",      "n",    "no",   "no.",     "nr",   "nr.",   "n°",     "num",
      "number", "index",  "idx",  "id",   "row",     "line", "point", "points", "record",
      "count",  "sample", "scan", "step", "reading", "obs",  "zeile", "punkt",  "点"};
  return is_one_of(words, title);
}

bool names_a_remark(std::string_view title) {
  static constexpr std::array<std::string_view, 18> words{
      "comment",    "comments",    "remark",      "remarks",   "note",        "notes",
      "annotation", "bemerkung",   "bemerkungen", "kommentar", "commentaire", "remarque",
      "comentario", "observación", "commento",    "nota",      "備考",        "コメント"};
  return is_one_of(words, title);
}

// A label in front of a line of titles or units.
bool labels_titles(std::string_view cell) {
  static constexpr std::array<std::string_view, 17> words{
      "channel name", "channel names", "channel",   "channels", "channel title", "signal name",
      "signal",       "name",          "names",     "title",    "titles",        "column",
      "kanalname",    "kanal",         "messkanal", "voie",     "canal"};
  return is_one_of(words, cell);
}

bool labels_units(std::string_view cell) {
  static constexpr std::array<std::string_view, 12> words{"unit",      "units", "y_unit_label", "einheit",
                                                          "einheiten", "unité", "unités",       "unidad",
                                                          "unidades",  "unità", "birim",        "単位"};
  return is_one_of(words, cell);
}

// The cells of a line that may hold titles or units, without a comment mark.
struct HeaderWords {
  CellWords cells;
  std::string note{};  // if the first row follows the last cell without a line end
};

std::size_t without_empty_end(const CellWords& cells) {
  std::size_t count = cells.size();
  while (count > 0 && cells[count - 1].empty()) --count;
  return count;
}

std::size_t last_looked_at(const Sheet& sheet, std::size_t above) { return std::min(sheet.size(), above + looked_at); }

// The number of columns with a cell in any row below a line, or with such a column after them.
std::size_t filled_columns(const Sheet& sheet, std::size_t above, const UsualRow& usual) {
  std::size_t filled = usual.pattern.size();
  for (std::size_t line = above + 1; filled < usual.cells && line < last_looked_at(sheet, above); ++line) {
    if (!is_row(sheet, line, usual)) continue;
    for (std::size_t column = filled; column < usual.cells; ++column)
      if (!sheet.at(line, column).empty()) filled = column + 1;
  }
  return filled;
}

bool is_empty_column(const Sheet& sheet, std::size_t above, const UsualRow& usual, std::size_t column) {
  for (std::size_t line = above + 1; line < last_looked_at(sheet, above); ++line)
    if (is_row(sheet, line, usual) && !sheet.at(line, column).empty()) return false;
  return true;
}

// True if the first column below a line counts the rows (1, 2, 3, ..., restarting in each table) or
// names them.
bool begins_with_row_names(const Sheet& sheet, std::size_t above, const UsualRow& usual) {
  std::size_t last = 0, rows = 0;
  bool are_counted = true, are_named = true;
  for (std::size_t line = above + 1; (are_counted || are_named) && line < last_looked_at(sheet, above); ++line) {
    if (!is_row(sheet, line, usual) || sheet.cells(line).size() < usual.pattern.size()) continue;
    const std::string_view cell = sheet.at(line, 0);
    const std::string next = std::to_string(last + 1);
    are_named = are_named && !cell.empty() && !has_number(cell);
    are_counted = are_counted && (cell == next || cell == "1");
    last = cell == next ? last + 1 : 1;
    ++rows;
  }
  return rows > 1 && (are_counted || are_named);
}

// The position of a number at the end of a text without a blank before it; otherwise the size of
// the text.
std::size_t number_at_end(std::string_view text) {
  for (std::size_t at = 1; at < text.size(); ++at)
    if (is_digit(text.back()) && number_cell(text.substr(at)).number.size() == text.size() - at) return at;
  return text.size();
}

// Titles followed by the first row without a line end: "Force (N)0.0".
HeaderWords without_row(CellWords cells, std::size_t columns, std::size_t line) {
  const bool may_be = columns > 1 && without_empty_end(cells) == 2 * columns - 1;
  if (!may_be) return {std::move(cells)};
  const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(columns - 1);
  const std::size_t at = number_at_end(*middle);
  const bool is_one = at < middle->size() && std::none_of(cells.begin(), middle, has_number) &&
                      std::all_of(middle + 1, middle + static_cast<std::ptrdiff_t>(columns), has_number);
  if (!is_one) return {std::move(cells)};
  cells.resize(columns);
  cells.back() = trimmed(std::string_view(cells.back()).substr(0, at));
  return {
      std::move(cells),
      fmt::format("line {} has titles and the first row, with no end of line between: that row is left out", line + 1)};
}

HeaderWords header_words(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  const Cells cells = sheet.cells(line);
  CellWords words(cells.begin(), cells.end());
  if (sheet.is_comment(line)) {  // "# time force": the cells follow the mark
    words.front().erase(0, words.front().find_first_not_of("# \t"));
    if (words.front().empty()) words.erase(words.begin());
  }
  return words.size() > usual.cells ? without_row(std::move(words), filled_columns(sheet, line, usual), line)
                                    : HeaderWords{std::move(words)};
}

// The words of a line above the columns.
struct Placed {
  CellWords cells{};  // one for each column; empty if they match no columns
  int shift = 0;      // shift of the first word, in columns
  std::string note{};
};

// Titles of a line without the separator of the rows, or of a line cut at blanks within a title:
// "Time [s]  Load cell [N]".
Placed placed_words(const Sheet& sheet, std::size_t line, std::string_view text, const UsualRow& usual) {
  for (const char other : {'\t', ';', ','})
    if (text.find(other) != std::string_view::npos && other != sheet.separator()) {
      CellWords cells;
      for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(other, at), text.size());
        cells.emplace_back(trimmed(text.substr(at, end - at)));
        at = end + 1;
      }
      if (other != '\t' || cells.size() == usual.cells) return cells.size() == usual.cells ? Placed{cells} : Placed{};
    }
  if (CellWords titles = titles_by_units(text);
      titles.size() + 1 == usual.cells && begins_with_row_names(sheet, line, usual)) {
    titles.insert(titles.begin(), "");
    return {std::move(titles), 1};
  }
  return {split_titles(text, usual.cells)};
}

// True if titles are as many as columns but shifted: a title with a meaning has no cells at one end
// of the line, and numbers at the other end have a title without a meaning.
bool are_shifted(const Sheet& sheet, std::size_t line, const CellWords& titles, const UsualRow& usual,
                 std::size_t filled) {
  const std::size_t count = without_empty_end(titles);
  if (count == 0 || filled == 0) return false;
  if (count > filled && means_something(titles[count - 1]))
    return says_nothing(titles.front()) && usual.pattern.front() == '1' && !begins_with_row_names(sheet, line, usual);
  return filled == usual.pattern.size() && means_something(titles.front()) && says_nothing(titles[filled - 1]) &&
         is_empty_column(sheet, line, usual, 0);
}

// Titles or units on one line, matched to the columns.
Placed placed(const Sheet& sheet, std::size_t line, CellWords cells, const UsualRow& usual) {
  const std::size_t filled = filled_columns(sheet, line, usual);
  std::size_t count = without_empty_end(cells);
  Placed out;
  if (cells.size() != usual.cells && (count < filled || count > usual.cells)) {
    const bool is_whole = sheet.cells(line).size() == 1 || sheet.separator() == ' ';
    std::string_view text = trimmed(sheet.text(line));
    if (sheet.is_comment(line)) text = trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())));
    if (is_whole && text.find('"') == std::string_view::npos) out = placed_words(sheet, line, text, usual);
    if (!out.cells.empty()) return out;
    if (sheet.cells(line).size() == 1 && usual.cells > 1) return {};
    if (count + 1 == filled && begins_with_row_names(sheet, line, usual)) {
      cells.insert(cells.begin(), "");
      out.shift = 1;
    } else if (count == filled + 1 && (labels_titles(cells.front()) || labels_units(cells.front()))) {
      cells.erase(cells.begin());
      out.shift = -1;
    } else if (count == filled + 1 && !names_a_count(cells.front()) &&
               (names_a_remark(cells[count - 1]) || (!says_nothing(cells.front()) && says_nothing(cells[count - 1])))) {
      out.note = fmt::format("the last title of line {}, {}, has cells in few rows or none and is not read", line + 1,
                             in_quotes(cells[count - 1]));
      cells.resize(count - 1);
    } else {
      return {};
    }
  }
  cells.resize(usual.cells);
  if (are_shifted(sheet, line, cells, usual, filled)) return {};
  if (out.shift == 1) out.note = fmt::format("the first column, without a title on line {}, names the rows", line + 1);
  out.cells = std::move(cells);
  return out;
}

// True if a text may be meant as a unit of time, length or force: "KN", "MM".
bool may_be_meant_as_unit(std::string_view cell) {
  const std::array kinds{&kind::time, &kind::length, &kind::force};
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const Kind* kind) { return !meant_units(without_brackets(cell), *kind).empty(); });
}

// True for a line with more units than other words, or with units only, some of them invalid.
bool is_unit_line(const CellWords& cells) {
  std::size_t units = 0, meant = 0, others = 0;
  bool has_longer = false;
  for (const std::string& cell : cells) {
    const bool counts_nothing = cell.empty() || cell == "-" || cell == "1" || labels_units(cell);
    if (counts_nothing) continue;
    if (cell.size() > longest_unit) return false;
    if (names_a_unit(cell) && !has_number(cell))
      ++units;
    else
      ++(may_be_meant_as_unit(cell) ? meant : others);
    has_longer = has_longer || cell.size() > 1;
  }
  return units > meant + others || (others == 0 && units + meant > 1 && has_longer);
}

struct TitleLine {
  CellWords titles;    // one for each column; empty if they match no columns
  std::string name{};  // of the specimen
  int shift = 0;       // of the titles
  std::string note{};
  std::string unplaced{};  // note on titles that match no columns
};

// The titles on a line: as many words as columns and no numbers, or two words with a meaning. The
// number of the specimen may come first.
std::optional<TitleLine> titles_on(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  auto [cells, note] = header_words(sheet, line, usual);
  if (cells.empty()) return std::nullopt;
  TitleLine out{{}, {}, 0, std::move(note)};
  const bool is_numbered = !cells.front().empty() &&
                           std::all_of(cells.front().begin(), cells.front().end(), is_digit) &&
                           std::count_if(cells.begin() + 1, cells.end(), means_something) > 1;
  if (is_numbered) out.name = std::exchange(cells.front(), "");
  Placed above = placed(sheet, line, cells, usual);
  for (std::string& cell : above.cells)
    if (labels_titles(cell)) cell.clear();
  std::size_t words = 0;
  std::size_t units = 0;
  std::size_t meant = 0;
  const CellWords& titles = above.cells.empty() ? cells : above.cells;
  for (const std::string& title : titles) {
    if (has_number(title)) return std::nullopt;
    if (!says_missing(title)) ++words;
    if (names_a_unit(title)) ++units;
    if (means_something(title)) ++meant;
  }
  // A comment without a meaning is prose, unless it gives each column a unit, as in Gwyddion: "# x
  // [m]  y [m]".
  const bool have_units = std::all_of(titles.begin(), titles.end(),
                                      [](const std::string& title) { return names_a_unit(title_parts(title).unit); });
  const bool is_prose = sheet.is_comment(line) && meant == 0 && !have_units;
  const bool are_units = units > 1 && 2 * units > words;
  if (is_prose || are_units || (words < 2 && usual.cells > 1) || words == 0) return std::nullopt;
  if (2 * words < usual.numbers && meant < 2) return std::nullopt;
  if (above.cells.empty()) {
    if (meant == 0 || sheet.is_comment(line)) return std::nullopt;
    cells.resize(without_empty_end(cells));
    out.unplaced =
        fmt::format("line {} has {} titles, {}, above rows of {} cells: they match no columns and are not used",
                    line + 1, cells.size(), listed(cells), filled_columns(sheet, line, usual));
    return out;
  }
  out.titles = std::move(above.cells);
  out.shift = above.shift;
  if (!above.note.empty()) out.note = std::move(above.note);
  return out;
}

bool begins_table(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  const CellWords cells = header_words(sheet, line, usual).cells;
  if (is_unit_line(cells) && cells.size() <= usual.cells + 1 && 2 * cells.size() >= usual.cells) return true;
  const std::optional<TitleLine> titles = titles_on(sheet, line, usual);
  if (!titles || titles->titles.empty()) return false;
  return !sheet.is_comment(line) || std::any_of(titles->titles.begin(), titles->titles.end(), means_something);
}

bool has_unplaced_titles(const Sheet& sheet, std::size_t line, const UsualRow& usual) {
  const std::optional<TitleLine> titles = titles_on(sheet, line, usual);
  return titles && !titles->unplaced.empty();
}

// The titles on two lines with cells merged downwards: a word with a meaning above an empty cell is
// its title.
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

// Units above the columns, shifted as the titles are; empty if their number differs. Numbers are
// skipped.
CellWords units_above(CellWords cells, int shift, const UsualRow& usual) {
  if (shift > 0 && cells.size() < usual.cells) cells.insert(cells.begin(), "");
  if (shift < 0 && !cells.empty()) cells.erase(cells.begin());
  const std::size_t count = without_empty_end(cells);
  if (count > usual.cells || cells.size() < usual.pattern.size()) return {};
  cells.resize(usual.cells);
  for (std::string& cell : cells)
    cell = labels_units(cell) || has_number(cell) ? "" : std::string(without_brackets(cell));
  return cells;
}

// The titles that a preamble lists, a line each, as of TA Instruments: "Sig1  Time (min)", "Sig2
// Temperature (°C)". Empty without one for each column.
CellWords listed_titles(const Sheet& sheet, const std::vector<std::size_t>& lines, const UsualRow& usual) {
  CellWords titles;
  std::string_view prefix;
  for (const std::size_t line : lines) {
    const std::string_view label = sheet.at(line, 0), title = sheet.at(line, 1);
    const std::string number = std::to_string(titles.size() + 1);
    const bool goes_on = label.ends_with(number) && !title.empty() && !has_number(label) &&
                         (titles.empty() || label.substr(0, label.size() - number.size()) == prefix);
    if (!goes_on) titles.clear();
    if (!goes_on) continue;
    prefix = label.substr(0, label.size() - number.size());
    titles.emplace_back(title);
    if (titles.size() == usual.cells) return titles;
  }
  return {};
}

// The table that begins with a row. Its names and units are the last free lines above it.
TableBlock begun_at(const Sheet& sheet, std::size_t row, std::vector<std::size_t> above, const UsualRow& usual) {
  TableBlock block{.header_line = row};
  CellWords units;
  if (!above.empty()) {
    auto [cells, note] = header_words(sheet, above.back(), usual);
    if (is_unit_line(cells)) {
      block.header_line = above.back();
      units = std::move(cells);
      if (!note.empty()) block.notes.push_back(std::move(note));
      above.pop_back();
    }
  }
  int shift = 0;
  if (!above.empty()) {
    const std::size_t line = above.back();
    std::optional<TitleLine> titles = titles_on(sheet, line, usual);
    if (above.size() > 1 && above[above.size() - 2] + 1 == line)
      if (CellWords both = titles_on_two_lines(sheet, line, usual); !both.empty()) titles = TitleLine{std::move(both)};
    if (titles && !titles->titles.empty()) {
      block.header_line = line;
      block.titles = std::move(titles->titles);
      block.name = std::move(titles->name);
      if (!titles->note.empty()) block.notes.push_back(std::move(titles->note));
      shift = titles->shift;
      above.pop_back();
    } else if (titles) {
      block.unplaced = std::move(titles->unplaced);
    }
  }
  if (!units.empty()) {
    block.units = units_above(units, shift, usual);
    if (block.units.empty() && block.unplaced.empty())
      block.notes.push_back(fmt::format("line {} has {} units above rows of {} cells: they are not used", row,
                                        units.size(), usual.cells));
  }
  if (block.titles.empty()) block.titles = listed_titles(sheet, above, usual);
  block.remarks = std::move(above);
  return block;
}

// True if a line between rows repeats the words of a line above the table: "Axial Counts", before
// each block of readings.
bool repeats_remark(const Sheet& sheet, std::size_t line, const TableBlock& block) {
  const std::string_view begin = sheet.at(line, 0);
  if (says_missing(begin) || says_overload(begin) || has_number(begin)) return false;
  return std::any_of(block.remarks.begin(), block.remarks.end(),
                     [&](std::size_t remark) { return sheet.at(remark, 0) == begin; });
}

// Tables without titles and with few rows above one with titles belong to its preamble: lines of
// settings.
void without_preambles(std::vector<TableBlock>& blocks) {
  for (std::size_t i = blocks.size(); i-- > 1;) {
    TableBlock& before = blocks[i - 1];
    if ((blocks[i].titles.empty() && blocks[i].unplaced.empty()) || !before.titles.empty() ||
        before.rows.size() >= least_rows)
      continue;
    std::vector<std::size_t> lines = std::move(before.remarks);
    if (before.header_line < before.rows.front()) lines.push_back(before.header_line);
    lines.insert(lines.end(), before.rows.begin(), before.rows.end());
    lines.insert(lines.end(), before.misfits.begin(), before.misfits.end());
    std::sort(lines.begin(), lines.end());
    blocks[i].remarks.insert(blocks[i].remarks.begin(), lines.begin(), lines.end());
    blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(i - 1));
  }
}

// Units far above the titles, on a line that begins with a word for units.
void add_labelled_units(const Sheet& sheet, TableBlock& block, const UsualRow& usual) {
  if (!block.units.empty() || block.header_line > looked_at) return;
  for (std::size_t line = 0; line < block.header_line; ++line)
    if (labels_units(sheet.at(line, 0)))
      if (const CellWords cells = header_words(sheet, line, usual).cells; is_unit_line(cells))
        block.units = units_above(cells, 0, usual);
}

// A number before the marks are known. All numbers of a column are then wrong by one factor at
// most.
double roughly(const Sheet& sheet, std::size_t line, std::size_t column) {
  const std::string_view number = number_cell(sheet.at(line, column)).number;
  const bool has_comma = std::count(number.begin(), number.end(), ',') == 1;
  return sheet.number(line, column, {has_comma && number.find('.') == std::string_view::npos ? ',' : '.', '\0'});
}

// True if a line between the rows starts no table: it repeats titles or units, or its words mean no
// column.
bool says_nothing_new(const Sheet& sheet, std::size_t line, const TableBlock& block, const UsualRow& usual) {
  const CellWords cells = header_words(sheet, line, usual).cells;
  if (is_unit_line(cells)) return units_above(cells, 0, usual) == block.units;
  const std::optional<TitleLine> titles = titles_on(sheet, line, usual);
  return !titles || titles->titles.empty() || titles->titles == block.titles ||
         std::none_of(titles->titles.begin(), titles->titles.end(), means_something);
}

// True if the rows of a table continue after other lines, as after a pause of the test: a column
// that never fell continues to rise, and the others stay near their values at mid-range. A column
// that is back at its start may be another specimen.
bool goes_on(const Sheet& sheet, const TableBlock& block, std::size_t row, const UsualRow& usual) {
  if (block.rows.size() < least_rows) return false;
  const auto lines = std::span(block.rows).last(std::min(block.rows.size(), looked_at));
  constexpr double near = 0.1, midway = 0.3;  // [1] of the range
  const auto role = [&](std::size_t column) { return role_of(title_parts(block.titles[column]).name); };
  bool have_roles = false;
  for (std::size_t column = 0; column < block.titles.size(); ++column)
    have_roles = have_roles || role(column) != ColumnRole::other;
  bool rises_on = false, is_midway = false;
  for (std::size_t column = 0; column < usual.pattern.size(); ++column) {
    const double next = roughly(sheet, row, column);
    if (usual.pattern[column] != '1' || !std::isfinite(next)) continue;
    const bool is_count = !block.titles.empty() && names_a_count(block.titles[column]);
    if (have_roles && !is_count && role(column) == ColumnRole::other) continue;  // such as the number of a segment
    std::vector<double> numbers;
    for (const std::size_t line : lines)
      if (const double number = roughly(sheet, line, column); std::isfinite(number)) numbers.push_back(number);
    if (numbers.empty()) continue;
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    const double range = *most - *least;
    const bool is_time = is_count || (have_roles && role(column) == ColumnRole::time);
    const bool never_fell = std::is_sorted(numbers.begin(), numbers.end()) && next > numbers.back();
    rises_on = rises_on || never_fell;
    if (!(never_fell && is_time) && !(std::abs(next - numbers.back()) <= near * range)) return false;
    is_midway = is_midway || (!is_time && std::abs(numbers.back() - numbers.front()) > midway * range);
  }
  return rises_on && is_midway;
}

Layout without_statistics(const Sheet& sheet, Layout layout) {
  for (TableBlock& block : layout.blocks) {
    std::vector<std::vector<double>> columns;
    for (std::size_t column = 0; column < layout.numeric.size(); ++column) {
      if (!layout.numeric[column]) continue;
      std::vector<double>& numbers = columns.emplace_back();
      numbers.reserve(block.rows.size());
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
  std::vector<std::size_t> gap;  // lines since the last row that are not rows
  for (std::size_t line = 0; line < sheet.size(); ++line) {
    const Cells cells = sheet.cells(line);
    const bool is_one = is_row(sheet, line, usual);
    const bool is_preamble = !layout.blocks.empty() && layout.blocks.back().rows.size() < least_rows;
    const bool may_begin =
        layout.blocks.empty() || (is_one && std::any_of(gap.begin(), gap.end(), [&](std::size_t each) {
                                    return begins_table(sheet, each, usual) ||
                                           (is_preamble && has_unplaced_titles(sheet, each, usual));
                                  }));
    const bool is_pause =
        may_begin && !layout.blocks.empty() &&
        std::all_of(gap.begin(), gap.end(),
                    [&](std::size_t each) { return says_nothing_new(sheet, each, layout.blocks.back(), usual); }) &&
        goes_on(sheet, layout.blocks.back(), line, usual);
    const bool begins = may_begin && !is_pause;
    // A line of numbers among the remarks above a table has the pattern but is not its first row.
    if (!is_one || (begins && !fits(cells, usual))) {
      if (is_one || !sheet.is_blank(line)) gap.push_back(line);
      continue;
    }
    if (begins) {
      layout.blocks.push_back(begun_at(sheet, line, std::exchange(gap, {}), usual));
      if (layout.blocks.size() == 1)
        layout.blocks.front().rows.reserve(sheet.size() - line);  // most files have only one table
    } else {
      TableBlock& block = layout.blocks.back();
      for (const std::size_t each : std::exchange(gap, {}))
        if (!sheet.is_comment(each)) {
          const bool is_row_of_it = is_damaged_row(sheet.cells(each), usual) && !repeats_remark(sheet, each, block);
          (is_row_of_it ? block.rows : is_pause ? block.between : block.misfits).push_back(each);
        }
    }
    TableBlock& block = layout.blocks.back();
    (fits(cells, usual) ? block.rows : block.misfits).push_back(line);
  }
  if (layout.blocks.empty()) throw InputError({.problem = "No row has as many cells as the others"});
  without_preambles(layout.blocks);
  for (TableBlock& block : layout.blocks) add_labelled_units(sheet, block, usual);
  TableBlock& last = layout.blocks.back();
  // Trailing rows whose non-numeric cells report a missing value or an overload.
  std::size_t silent = 0;
  while (silent < gap.size() && is_silent_row(sheet.cells(gap[silent]), usual)) last.rows.push_back(gap[silent++]);
  gap.erase(gap.begin(), gap.begin() + static_cast<std::ptrdiff_t>(silent));
  // The end of a truncated file: words or a short row in its last line.
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
           .problem = fmt::format("{} lines do not have {} cells, as the other {} rows do", block.misfits.size(),
                                  layout.columns, block.rows.size()),
           .remedy = "name the separator with --separator, or delete the lines that do not belong to the table"});
  return without_statistics(sheet, std::move(layout));
}

}  // namespace flexslip
