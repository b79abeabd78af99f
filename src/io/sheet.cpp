#include "io/sheet.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t block = 1 << 16;    // [bytes] of the rows of a workbook that are kept together
constexpr std::size_t sample = 1000;      // lines judged for the separator; more do not change the answer
constexpr double of_blanks = 0.9;         // tabs are blanks too, but where they separate names have spaces in them
constexpr double longest_days = 2958466;  // to the end of 9999, as far as spreadsheets go

// Takes the cells off a line, one by one, without spaces and quotes around them. With a space as delimiter, any run of spaces and tabs separates.
class CellReader {
 public:
  CellReader(std::string_view line, char delimiter) : rest_(line), delimiter_(delimiter) {
    if (delimiter_ == ' ') {
      rest_ = trimmed(rest_);
      more_ = !rest_.empty();
    }
  }

  // The next cell; nothing at the end of the line, or where a quote is not closed.
  std::optional<std::string_view> next() {
    if (!more_) return std::nullopt;
    if (const std::size_t first = rest_.find_first_not_of(' '); first != std::string_view::npos && rest_[first] == '"')
      return next_quoted(first);
    return next_plain();
  }

  // The next cell, whatever quotes are in it.
  std::optional<std::string_view> next_plain() {
    if (!more_) return std::nullopt;
    const std::size_t end = delimiter_ == ' ' ? rest_.find_first_of(" \t") : rest_.find(delimiter_);
    const std::string_view cell = trimmed(rest_.substr(0, end));
    advance(end);
    return cell;
  }

  bool broken() const { return broken_; }  // a quote is not closed

 private:
  std::optional<std::string_view> next_quoted(std::size_t open) {
    std::size_t close = rest_.find('"', open + 1);
    while (close != std::string_view::npos && close + 1 < rest_.size() && rest_[close + 1] == '"')
      close = rest_.find('"', close + 2);
    const bool closed = close != std::string_view::npos;
    const std::size_t end = closed ? rest_.find_first_not_of(delimiter_ == ' ' ? "" : " ", close + 1) : 0;
    const bool at_delimiter =
        end == std::string_view::npos || rest_[end] == delimiter_ || (delimiter_ == ' ' && rest_[end] == '\t');
    if (!closed || !at_delimiter) {
      broken_ = true;
      more_ = false;
      return std::nullopt;
    }
    const std::string_view cell = trimmed(rest_.substr(open + 1, close - open - 1));
    advance(end);
    return cell;
  }

  void advance(std::size_t end) {
    more_ = end != std::string_view::npos;
    if (!more_) return;
    rest_.remove_prefix(end + 1);
    if (delimiter_ == ' ') rest_ = trimmed(rest_);
  }

  std::string_view rest_;
  char delimiter_;
  bool more_ = true, broken_ = false;
};

// A cell with its doubled quotes made single, which it is then kept as.
std::string_view unescaped(std::string_view cell, std::deque<std::string>& kept) {
  if (cell.find("\"\"") == std::string_view::npos) return cell;
  std::string& text = kept.emplace_back(cell);
  for (std::size_t at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1)) text.erase(at, 1);
  return text;
}

bool is_comment_or_blank(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string_view::npos || line[first] == '#';
}

// Takes a line off the text, whatever ends it: \n, \r\n or \r.
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
  CellReader reader(line, separator);
  while (const std::optional<std::string_view> cell = reader.next()) {
    if (cell->empty()) continue;
    ++cells;
    if (!number_cell(*cell).number.empty()) ++numbers;
  }
  const bool is_row = !reader.broken() && 3 * numbers > cells;  // or else a line of names with a number in them
  return is_row ? numbers * numbers / cells : 0;
}

}  // namespace

bool is_dated(CellKind kind) {
  return kind == CellKind::date || kind == CellKind::clock || kind == CellKind::date_and_clock;
}

Sheet::Sheet(std::string text, char separator) {
  texts_.push_back(std::move(text));
  const std::string_view all = texts_.front();
  const auto count = [&](char c) { return static_cast<std::size_t>(std::count(all.begin(), all.end(), c)); };
  const std::size_t lines = 1 + count('\n');
  lines_.reserve(lines);
  cells_.reserve(lines + count(separator));
  for (std::string_view rest = all; !rest.empty();) cut(take_line(rest), separator);
}

void Sheet::cut(std::string_view line, char separator) {
  const std::size_t first = cells_.size();
  const bool may_be_quoted = line.find('"') != std::string_view::npos;
  CellReader reader(line, separator);
  while (const std::optional<std::string_view> cell = reader.next())
    cells_.push_back(may_be_quoted ? unescaped(*cell, texts_) : *cell);
  if (reader.broken()) {  // the quotes mean nothing
    stray_quotes_.emplace(lines_.size(), cells_.size() - first + 1);
    cells_.resize(first);
    CellReader plain(line, separator);
    while (const std::optional<std::string_view> cell = plain.next_plain()) cells_.push_back(*cell);
  } else {
    quoted_ = quoted_ || may_be_quoted;
  }
  lines_.push_back({line, first, static_cast<std::uint32_t>(cells_.size() - first), trimmed(line).starts_with('#')});
}

void Sheet::append(std::size_t line, std::span<const SheetCell> cells) {
  lines_.resize(line, {{}, cells_.size(), 0, false});
  std::size_t size = cells.size();
  for (const SheetCell& cell : cells) size += cell.text.size();
  if (texts_.empty() || texts_.back().capacity() - texts_.back().size() < size)
    texts_.emplace_back().reserve(std::max(size, block));
  std::string& text = texts_.back();
  const std::size_t begin = text.size(), first = cells_.size();
  for (const SheetCell& cell : cells) {
    if (&cell != cells.data()) text += '\t';
    cells_.push_back(std::string_view(text).substr(text.size(), 0));
    text += cell.text;
    cells_.back() = std::string_view(text).substr(text.size() - cell.text.size());
    kinds_.push_back(cell.kind);
  }
  const bool is_comment =
      !cells.empty() && cells.front().text.starts_with('#') && cells.front().kind != CellKind::error;
  lines_.push_back({std::string_view(text).substr(begin), first, static_cast<std::uint32_t>(cells.size()), is_comment});
}

void Sheet::fill() {
  std::uint32_t widest = 0;
  for (const Line& line : lines_) widest = std::max(widest, line.cells);
  Sheet filled(dates_from_1904_);
  for (Line& line : lines_) {
    if (line.cells == 0) continue;
    const auto first = static_cast<std::ptrdiff_t>(line.first_cell);
    const auto end = first + static_cast<std::ptrdiff_t>(line.cells);
    line.first_cell = filled.cells_.size();
    filled.cells_.insert(filled.cells_.end(), cells_.begin() + first, cells_.begin() + end);
    filled.kinds_.insert(filled.kinds_.end(), kinds_.begin() + first, kinds_.begin() + end);
    line.cells = widest;
    filled.cells_.resize(line.first_cell + widest);
    filled.kinds_.resize(line.first_cell + widest, CellKind::word);
  }
  cells_ = std::move(filled.cells_);
  kinds_ = std::move(filled.kinds_);
}

bool Sheet::is_blank(std::size_t line) const {
  const auto all = cells(line);
  return std::all_of(all.begin(), all.end(), [](std::string_view cell) { return cell.empty(); });
}

std::size_t Sheet::stray_quote(std::size_t line) const {
  const auto found = stray_quotes_.find(line);
  return found == stray_quotes_.end() ? 0 : found->second;
}

std::string_view Sheet::at(std::size_t line, std::size_t column) const {
  return column < lines_[line].cells ? cells_[lines_[line].first_cell + column] : std::string_view{};
}

CellKind Sheet::kind(std::size_t line, std::size_t column) const {
  return !kinds_.empty() && column < lines_[line].cells ? kinds_[lines_[line].first_cell + column] : CellKind::word;
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
  constexpr std::array candidates{';', '\t', ',', ' '};  // of equals the first
  std::array<double, candidates.size()> score{};
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  const std::size_t stride = 1 + lines / sample;
  for (std::size_t number = 0; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (number % stride != 0 || is_comment_or_blank(line)) continue;
    for (std::size_t i = 0; i < candidates.size(); ++i) score[i] += numbers_on(line, candidates[i]);
  }
  score.back() *= of_blanks;
  // A single column leaves all equal: then it is a comma, as in the files that the program writes.
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
  // In milliseconds, so that 59.9996 s is a minute, and 24 h a day.
  const auto milliseconds = static_cast<std::int64_t>(std::llround(days * 86400e3));
  const std::int64_t whole = milliseconds / 86400000;
  // The calendar of spreadsheets has a 29 February 1900: before it, days count from a day later.
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
