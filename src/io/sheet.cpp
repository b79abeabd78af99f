#include "io/sheet.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t chunk = 1 << 20;  // [bytes] read at a time: large against a system call, small in memory
constexpr std::size_t longest_line =
    1 << 20;  // [bytes] no table has such lines; an endless one must not fill the memory
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
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
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos) {
    text = {};
  } else {
    const bool pair = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (pair ? 2 : 1));
  }
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
  for (std::string_view rest = texts_.front(); !rest.empty();) cut(take_line(rest), separator);
}

void Sheet::cut(std::string_view line, char separator) {
  const std::size_t first = cells_.size();
  const bool may_be_quoted = line.find('"') != std::string_view::npos;
  CellReader reader(line, separator);
  while (const std::optional<std::string_view> cell = reader.next())
    cells_.push_back(may_be_quoted ? unescaped(*cell, texts_) : *cell);
  if (reader.broken()) {  // the quotes mean nothing
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

TableRows::TableRows(std::istream& in, std::string source) : in_(&in), source_(std::move(source)) {
  refill();
  if (buffer_.starts_with(byte_order_mark)) begin_ += byte_order_mark.size();
  if (buffer_.find('\n', begin_) == std::string::npos && buffer_.find('\r', begin_) != std::string::npos)
    ending_ = '\r';
}

TableRows::TableRows(const Sheet& sheet, std::string source) : sheet_(&sheet), source_(std::move(source)) {}

bool TableRows::next() {
  if (sheet_ != nullptr) {
    for (; number_ < sheet_->size(); ++number_) {
      const auto cells = sheet_->cells(number_);
      const bool is_blank = std::all_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty(); });
      if (!is_blank && !sheet_->is_comment(number_)) return ++number_, true;
    }
    return false;
  }
  for (auto line = next_line(); line; line = next_line()) {
    line_ = *line;
    if (!is_comment_or_blank(line_)) return true;
  }
  return false;
}

std::optional<std::string_view> TableRows::next_line() {
  std::size_t end = buffer_.find(ending_, begin_);
  while (end == std::string::npos) {
    const std::size_t unread = buffer_.size() - begin_;
    if (unread > longest_line) {
      ++number_;
      refuse("lines of a table", "a line longer than 1 MiB", "");
    }
    if (!refill()) break;
    end = buffer_.find(ending_, unread);
  }
  if (begin_ == buffer_.size()) return std::nullopt;
  ++number_;
  std::string_view line = std::string_view(buffer_).substr(begin_, end == std::string::npos ? end : end - begin_);
  begin_ = std::min(begin_ + line.size() + 1, buffer_.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

bool TableRows::refill() {
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + chunk);
  in_->read(buffer_.data() + kept, static_cast<std::streamsize>(chunk));
  const auto got = static_cast<std::size_t>(in_->gcount());
  buffer_.resize(kept + got);
  if (in_->bad()) refuse("a readable file", "an error while reading", "");
  if (const std::size_t nul = buffer_.find('\0', kept); nul != std::string::npos) refuse_binary(nul);
  return got > 0;
}

void TableRows::refuse_binary(std::size_t nul) {
  if (number_ == 0 && (buffer_.starts_with("\xFF\xFE") || buffer_.starts_with("\xFE\xFF")))
    refuse("UTF-8 text", "UTF-16 text", "save the file as UTF-8 or as plain CSV");
  number_ += 1 + static_cast<std::size_t>(std::count(buffer_.data(), buffer_.data() + nul, ending_));
  refuse("a table as text", "binary data (a NUL byte)", "export the measurement as CSV");
}

void TableRows::refuse(std::string expected, std::string found, std::string remedy) const {
  throw InputError({.file = source_,
                    .line = number_,
                    .expected = std::move(expected),
                    .found = std::move(found),
                    .remedy = std::move(remedy)});
}

char TableRows::delimiter() const {
  if (sheet_ != nullptr) return '\t';
  constexpr std::array<char, 3> candidates{',', ';', '\t'};
  std::array<std::size_t, 3> count{};
  bool in_quotes = false;
  for (const char c : line_) {
    if (c == '"') in_quotes = !in_quotes;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (!in_quotes && c == candidates[i]) ++count[i];
  }
  const auto most = std::max_element(count.begin(), count.end());
  return *most == 0 ? ' ' : candidates[static_cast<std::size_t>(most - count.begin())];
}

std::span<const std::string_view> TableRows::cells(char delimiter) {
  if (sheet_ != nullptr) return sheet_->cells(number_ - 1);
  cells_.clear();
  unescaped_.clear();
  CellReader reader(line_, delimiter);
  while (const std::optional<std::string_view> cell = reader.next()) cells_.push_back(unescaped(*cell, unescaped_));
  if (reader.broken())
    refuse("quotes in pairs around a whole cell", fmt::format("a stray quote in cell {}", cells_.size() + 1),
           "delete it");
  return cells_;
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
