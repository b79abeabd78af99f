#include "io/sheet.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 31;  // [bytes]
constexpr const char* remedy_for_large = "split the table, or leave out the columns that are not needed";
constexpr std::size_t sample = 1000;  // lines used to find the separator; more do not change the answer
constexpr double of_blanks = 0.9;     // prefers a tab to a space, because titles separated by tabs may contain spaces
constexpr double longest_days = 2958466;  // up to the end of 9999, the limit of spreadsheets

// Passes on where each cell of a line begins and ends, including blanks and quotes. Returns false
// at a quote without a partner. With a space as separator, any run of spaces and tabs separates.
template <class Take>
bool cut_line(std::string_view line, char separator, bool has_quotes, const Take& take) {
  const bool by_blanks = separator == ' ';
  const auto is_end = [&](std::size_t at) {
    return at == line.size() || line[at] == separator || (by_blanks && line[at] == '\t');
  };
  const auto behind_blanks = [&](std::size_t at) {
    while (at < line.size() && (line[at] == ' ' || (line[at] == '\t' && separator != '\t'))) ++at;
    return at;
  };
  for (std::size_t begin = by_blanks ? behind_blanks(0) : 0;;) {
    std::size_t end = begin;
    const std::size_t open = has_quotes ? behind_blanks(begin) : line.size();
    if (open < line.size() && line[open] == '"') {
      std::size_t close = line.find('"', open + 1);
      while (close < line.size() && line.substr(close + 1, 1) == "\"") close = line.find('"', close + 2);
      if (close >= line.size()) return false;
      end = by_blanks ? close + 1 : behind_blanks(close + 1);
      if (!is_end(end)) return false;
    }
    while (!is_end(end)) ++end;
    take(begin, end);
    begin = by_blanks ? behind_blanks(end) : end + 1;
    if (end == line.size() || (by_blanks && begin == line.size())) return true;
  }
}

// Replaces doubled quotes within a quoted cell by single ones, and pads the cell with blanks.
void make_single(char* cell, std::size_t size) {
  std::size_t to = 1;
  for (std::size_t from = 1; from + 1 < size; ++from) {
    cell[to++] = cell[from];
    if (cell[from] == '"') ++from;
  }
  cell[to++] = '"';
  std::fill(cell + to, cell + size, ' ');
}

// A cell without quotes. A formula that only holds words loses its signs too: ="1.23".
std::string_view unquoted(std::string_view cell) {
  if (!cell.starts_with('"')) return cell;
  const std::string_view words = trimmed(cell.substr(1, cell.size() - 2));
  const bool is_formula = words.size() > 2 && words.starts_with("=\"") && words.ends_with('"');
  return is_formula ? trimmed(words.substr(2, words.size() - 3)) : words;
}

// True for an error value of a spreadsheet, in any language: "#N/A", "#NV", "#WERT!", "#NAME?".
bool is_error_of_spreadsheet(std::string_view cell) {
  return cell == "#N/A" || cell == "#NV" ||
         (cell.size() > 2 && cell.front() == '#' && (cell.back() == '!' || cell.back() == '?') &&
          cell.find(' ') == std::string_view::npos);
}

bool is_comment_or_blank(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string_view::npos || line[first] == '#';
}

// Takes a line off the text. It may end with
// , \r
//  or \r.
std::string_view take_line(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && text[end] != '\n' && text[end] != '\r') ++end;
  const std::string_view line = text.substr(0, end);
  const bool is_pair = text.substr(end, 2) == "\r\n";
  text.remove_prefix(std::min(end + (is_pair ? 2 : 1), text.size()));
  return line;
}

double numbers_on(std::string_view line, char separator) {
  double numbers = 0;
  double cells = 0;
  const bool is_whole = cut_line(line, separator, true, [&](std::size_t begin, std::size_t end) {
    const std::string_view cell = unquoted(trimmed(line.substr(begin, end - begin)));
    if (cell.empty()) return;
    ++cells;
    if (!number_cell(cell).number.empty()) ++numbers;
  });
  const bool is_row = is_whole && 3 * numbers > cells;  // otherwise a line of names that contains a number
  return is_row ? numbers * numbers / cells : 0;
}

}  // namespace

bool is_dated(CellKind kind) {
  return kind == CellKind::date || kind == CellKind::clock || kind == CellKind::date_and_clock;
}

Sheet::Sheet(std::string text, char separator, std::size_t most) : text_(std::move(text)), separator_(separator) {
  if (text_.size() > most_bytes)
    throw InputError({.problem = "The text has more than 2 GiB", .remedy = remedy_for_large});
  if (!text_.empty() && text_.back() != '\n' && text_.back() != '\r') text_ += '\n';
  const bool may_be_quoted = text_.find('"') != std::string::npos;
  for (std::string_view rest = text_; !rest.empty();) {
    cut(take_line(rest), may_be_quoted, most);
    if (size() != sample) continue;  // the remaining lines are assumed to be similar
    const double share = 1.02 * static_cast<double>(text_.size()) / static_cast<double>(text_.size() - rest.size());
    for (std::vector<std::uint32_t>* each : {&begins_, &first_cells_})
      each->reserve(std::min(most, static_cast<std::size_t>(share * static_cast<double>(each->size()))));
  }
  if (may_be_quoted) make_quotes_single();
}

void Sheet::cut(std::string_view line, bool may_be_quoted, std::size_t most) {
  effort_spent += 1;
  const auto at = static_cast<std::uint32_t>(line.data() - text_.data());
  const std::size_t first = begins_.size();
  const auto add = [&](std::size_t begin, std::size_t /*end*/) {
    if (begins_.size() == most)
      throw InputError({.line = size(),
                        .problem = fmt::format("The table has more than {} cells", most),
                        .remedy = remedy_for_large});
    begins_.push_back(at + static_cast<std::uint32_t>(begin));
  };
  first_cells_.push_back(static_cast<std::uint32_t>(first));
  const bool has_quotes = may_be_quoted && line.find('"') != std::string_view::npos;
  if (!cut_line(line, separator_, has_quotes, add)) {  // quotes are ordinary characters
    stray_quotes_.push_back(static_cast<std::uint32_t>(size() - 1));
    begins_.resize(first);
    cut_line(line, separator_, false, add);
  }
  begins_[first] = at;  // including the blanks before it
}

void Sheet::make_quotes_single() {
  for (std::size_t line = 0; line < size(); ++line)
    for (std::size_t cell = first_cells_[line]; !has_stray_quote(line) && cell < end_of(line); ++cell) {
      const std::string_view quotes = raw(cell);
      if (!quotes.starts_with('"')) continue;
      quoted_ = true;
      make_single(text_.data() + (quotes.data() - text_.data()), quotes.size());
    }
}

bool Sheet::has_stray_quote(std::size_t line) const {
  return std::binary_search(stray_quotes_.begin(), stray_quotes_.end(), line);
}

void Sheet::append(std::size_t line, std::span<const SheetCell> cells) {
  first_cells_.resize(line, static_cast<std::uint32_t>(begins_.size()));
  first_cells_.push_back(static_cast<std::uint32_t>(begins_.size()));
  for (const SheetCell& cell : cells) {
    begins_.push_back(static_cast<std::uint32_t>(text_.size()));
    kinds_.push_back(cell.kind);
    text_.append(cell.text) += '\t';
  }
  if (!cells.empty()) text_.back() = '\n';
}

void Sheet::fill() {
  for (std::size_t line = 0; line < size(); ++line) width_ = std::max(width_, cells(line).size());
}

std::string_view Sheet::text(std::size_t line) const {
  const std::size_t begin = begin_of(first_cells_[line]);
  const std::string_view all = std::string_view(text_).substr(begin, begin_of(end_of(line)) - begin);
  return all.substr(0, all.find_last_not_of("\r\n") + 1);
}

bool Sheet::is_comment(std::size_t line) const {
  const std::size_t first = first_cells_[line];
  if (first >= end_of(line) || !raw(first).starts_with('#') || kind(line, 0) == CellKind::error) return false;
  return end_of(line) - first < 2 || !is_error_of_spreadsheet(raw(first));
}

bool Sheet::is_blank(std::size_t line) const {
  const Cells all = cells(line);
  return std::all_of(all.begin(), all.end(), [](std::string_view cell) { return cell.empty(); });
}

std::size_t Sheet::stray_quote(std::size_t line) const {
  std::size_t cell = 1;
  if (!has_stray_quote(line)) return 0;
  cut_line(text(line), separator_, true, [&](std::size_t, std::size_t) { ++cell; });
  return cell;
}

std::string_view Sheet::raw(std::size_t cell) const {
  effort_spent += 1;
  const char* begin = text_.data() + begins_[cell];
  const char* end = text_.data() + begin_of(cell + 1) - 1;
  while (begin < end && (*begin == ' ' || *begin == '\t')) ++begin;
  while (begin < end && (end[-1] == ' ' || end[-1] == '\t' || end[-1] == '\r')) --end;
  return {begin, static_cast<std::size_t>(end - begin)};
}

std::string_view Sheet::at(std::size_t line, std::size_t column) const {
  const std::size_t cell = first_cells_[line] + column;
  if (cell >= end_of(line)) return {};
  const std::string_view text = raw(cell);
  return quoted_ && !has_stray_quote(line) ? unquoted(text) : text;
}

CellKind Sheet::kind(std::size_t line, std::size_t column) const {
  const std::size_t cell = first_cells_[line] + column;
  return !kinds_.empty() && cell < end_of(line) ? kinds_[cell] : CellKind::word;
}

double Sheet::number(std::size_t line, std::size_t column, const NumberFormat& format) const {
  const CellKind held = kind(line, column);
  if (is_dated(held)) return not_a_number;
  return number_in(number_cell(at(line, column)).number, held == CellKind::word ? format : NumberFormat{});
}

double Sheet::days(std::size_t line, std::size_t column) const {
  return is_dated(kind(line, column)) ? number_in(at(line, column), {}) : not_a_number;
}

std::string Sheet::shown(std::size_t line, std::size_t column) const {
  const CellKind held = kind(line, column);
  return is_dated(held) ? shown_days(days(line, column), held, dates_from_1904_) : std::string(at(line, column));
}

char separator_of(std::string_view text) {
  constexpr std::array candidates{';', '\t', ',', ' '};  // the first wins if several are equal
  std::array<double, candidates.size()> score{};
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  const std::size_t stride = 1 + lines / sample;
  for (std::size_t number = 0; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (number % stride != 0 || is_comment_or_blank(line)) continue;
    for (std::size_t i = 0; i < candidates.size(); ++i) score[i] += numbers_on(line, candidates[i]);
  }
  score.back() *= of_blanks;
  // A single column makes all equal: then it is a comma, as in files of this program.
  const auto best = std::max_element(score.begin(), score.end());
  if (*best == *std::min_element(score.begin(), score.end() - 1)) return ',';
  return candidates[static_cast<std::size_t>(best - score.begin())];
}

char separator_of_titles(std::string_view text) {
  std::string_view titles;
  while (!text.empty() && is_comment_or_blank(titles)) titles = take_line(text);
  constexpr std::array candidates{',', ';', '\t'};
  std::array<std::size_t, candidates.size()> count{};
  bool in_quotes = false;
  for (const char c : titles) {
    if (c == '"') in_quotes = !in_quotes;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (!in_quotes && c == candidates[i]) ++count[i];
  }
  const auto most = std::max_element(count.begin(), count.end());
  return *most == 0 ? ' ' : candidates[static_cast<std::size_t>(most - count.begin())];
}

std::string shown_days(double days, CellKind kind, bool from_1904) {
  if (!(days >= 0) || days >= longest_days) return fmt::format("{} days", days);
  using namespace std::chrono;
  // In milliseconds, so that 59.9996 s becomes a minute and 24 h a day.
  const auto milliseconds = static_cast<std::int64_t>(std::llround(days * 86400e3));
  const std::int64_t whole = milliseconds / 86400000;
  // Spreadsheets have a 29 February 1900: before it, days count from one day later.
  const sys_days zero = from_1904    ? sys_days{year{1904} / January / 1}
                        : whole < 60 ? sys_days{year{1899} / December / 31}
                                     : sys_days{year{1899} / December / 30};
  const year_month_day date{zero + std::chrono::days{whole}};
  const std::string day = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                                      static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  if (kind == CellKind::date) return day;
  const std::int64_t in_day = kind == CellKind::clock ? milliseconds : milliseconds % 86400000;
  std::string clock = fmt::format("{:02}:{:02}:{:02}", in_day / 3600000, in_day / 60000 % 60, in_day / 1000 % 60);
  if (in_day % 1000 != 0) {
    clock += fmt::format(".{:03}", in_day % 1000);
    clock.erase(clock.find_last_not_of('0') + 1);
  }
  return kind == CellKind::clock ? clock : day + ' ' + clock;
}

std::string cell_name(std::size_t row, std::size_t column) {
  std::string letters;
  for (; column > 0; column = (column - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (column - 1) % 26));
  return letters + std::to_string(row);
}

}  // namespace flexslip
