#include "io/cells.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/input_error.h"
#include "io/quantity.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t chunk = 1 << 20;  // [bytes] read at a time: large against a system call, small in memory
constexpr std::size_t longest_line =
    1 << 20;  // [bytes] no table has such lines; an endless one must not fill the memory
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

LineReader::LineReader(std::istream& in, const std::string& source) : in_(in), source_(source) {
  refill();
  if (unread().starts_with(byte_order_mark)) begin_ += byte_order_mark.size();
  if (unread().find('\n') == std::string_view::npos && unread().find('\r') != std::string_view::npos) ending_ = '\r';
}

std::optional<std::string_view> LineReader::next() {
  std::size_t length = unread().find(ending_);
  while (length == std::string_view::npos) {
    const std::size_t searched = unread().size();
    if (searched > longest_line) {
      ++number_;
      refuse("lines of a table", "a line longer than 1 MiB", "");
    }
    if (!refill()) break;
    length = unread().find(ending_, searched);
  }
  if (unread().empty()) return std::nullopt;
  ++number_;
  std::string_view line = unread().substr(0, length);
  begin_ += std::min(line.size() + 1, unread().size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

bool LineReader::refill() {
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + chunk);
  in_.read(buffer_.data() + kept, static_cast<std::streamsize>(chunk));
  const auto got = static_cast<std::size_t>(in_.gcount());
  buffer_.resize(kept + got);
  if (in_.bad()) refuse("a readable file", "an error while reading", "");
  if (const std::size_t nul = buffer_.find('\0', kept); nul != std::string::npos) refuse_binary(nul);
  return got > 0;
}

void LineReader::refuse_binary(std::size_t nul) {
  if (number_ == 0 && (buffer_.starts_with("\xFF\xFE") || buffer_.starts_with("\xFE\xFF")))
    refuse("UTF-8 text", "UTF-16 text", "save the file as UTF-8 or as plain CSV");
  number_ += 1 + static_cast<std::size_t>(std::count(buffer_.data(), buffer_.data() + nul, ending_));
  refuse("a table as text", "binary data (a NUL byte)", "export the measurement as CSV");
}

void LineReader::refuse(std::string expected, std::string found, std::string remedy) const {
  throw InputError({.file = source_,
                    .line = number_,
                    .expected = std::move(expected),
                    .found = std::move(found),
                    .remedy = std::move(remedy)});
}

CellReader::CellReader(std::string_view line, char delimiter) : rest_(line), delimiter_(delimiter) {
  if (delimiter_ == ' ') {
    rest_ = trimmed(rest_);
    more_ = !rest_.empty();
  }
}

std::optional<std::string_view> CellReader::next() {
  if (!more_) return std::nullopt;
  if (const std::size_t first = rest_.find_first_not_of(' '); first != std::string_view::npos && rest_[first] == '"')
    return next_quoted(first);
  const std::size_t end = delimiter_ == ' ' ? rest_.find_first_of(" \t") : rest_.find(delimiter_);
  const std::string_view cell = trimmed(rest_.substr(0, end));
  advance(end);
  return cell;
}

std::optional<std::string_view> CellReader::next_quoted(std::size_t open) {
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

void CellReader::advance(std::size_t end) {
  more_ = end != std::string_view::npos;
  if (!more_) return;
  rest_.remove_prefix(end + 1);
  if (delimiter_ == ' ') rest_ = trimmed(rest_);
}

char delimiter_of(std::string_view header) {
  constexpr std::array<char, 3> candidates{',', ';', '\t'};
  std::array<std::size_t, 3> count{};
  bool in_quotes = false;
  for (const char c : header) {
    if (c == '"') in_quotes = !in_quotes;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (!in_quotes && c == candidates[i]) ++count[i];
  }
  const auto most = std::max_element(count.begin(), count.end());
  return *most == 0 ? ' ' : candidates[static_cast<std::size_t>(most - count.begin())];
}

bool is_comment_or_blank(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string_view::npos || line[first] == '#';
}

std::string unescaped(std::string_view cell) {
  std::string text(cell);
  for (std::size_t at = text.find("\"\""); at != std::string::npos; at = text.find("\"\"", at + 1)) text.erase(at, 1);
  return text;
}

}  // namespace flexslip
