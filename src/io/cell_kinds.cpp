#include "io/cell_kinds.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "io/xml_stream.h"

namespace flexslip {
namespace {

constexpr double longest = 2958466;  // [days] to the end of 9999, as far as spreadsheets go

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// A format built in, some of them as Chinese, Japanese and Korean spreadsheets have them (ECMA-376, 18.8.30).
CellKind built_in(std::size_t number) {
  const auto within = [&](std::size_t first, std::size_t last) { return number >= first && number <= last; };
  if (number == 22) return CellKind::date_and_clock;
  if (within(18, 21) || within(32, 35) || within(45, 47) || within(55, 56)) return CellKind::clock;
  if (within(14, 17) || within(27, 31) || number == 36 || within(50, 54) || within(57, 58)) return CellKind::date;
  return CellKind::number;
}

// The letters of a format for positive numbers, in lower case, without its words: "[h]:mm" is "h:mm". What stands for digits before
// any letter makes it a format of numbers, whatever unit follows.
std::string letters_of(std::string_view code) {
  std::string letters;
  for (std::size_t i = 0; i < code.size() && code[i] != ';'; ++i) {
    const char c = lower(code[i]);
    if (c == '"') {
      i = std::min(code.find('"', i + 1), code.size());
    } else if (c == '\\' || c == '_' || c == '*') {
      ++i;
    } else if (c == '[') {  // a colour, a condition, a language, or hours that are not cut at 24
      const std::size_t end = std::min(code.find(']', i), code.size());
      const std::string_view inside = code.substr(i + 1, end - i - 1);
      const bool is_elapsed = !inside.empty() && inside.find_first_not_of("hHmMsS") == std::string_view::npos;
      if (is_elapsed) letters += 'h';
      i = end;
    } else if (c == '#' || c == '?' || (c == '0' && letters.empty())) {
      return "";
    } else if (std::string_view("dmyhs").find(c) != std::string_view::npos) {
      letters += c;
    }
  }
  return letters;
}

}  // namespace

bool is_dated(CellKind kind) {
  return kind == CellKind::date || kind == CellKind::clock || kind == CellKind::date_and_clock;
}

void CellKinds::add(std::size_t row, std::size_t column, CellKind kind) {
  if (kind == CellKind::number) return;
  (kind == CellKind::word ? has_words_ : has_dates_) = true;
  if (runs_.size() < column) runs_.resize(column);
  std::vector<Run>& runs = runs_[column - 1];
  const auto at = static_cast<std::uint32_t>(row);
  if (!runs.empty() && runs.back().kind == kind && runs.back().last + 1 == at)
    runs.back().last = at;
  else
    runs.push_back({at, at, kind});
}

CellKind CellKinds::at(std::size_t row, std::size_t column) const {
  if (column == 0 || column > runs_.size()) return CellKind::number;
  const std::vector<Run>& runs = runs_[column - 1];
  const auto after =
      std::upper_bound(runs.begin(), runs.end(), row, [](std::size_t r, const Run& run) { return r < run.first; });
  if (after == runs.begin() || row > std::prev(after)->last) return CellKind::number;
  return std::prev(after)->kind;
}

CellKind kind_of_format(std::size_t number, std::string_view code) {
  if (code.empty()) return built_in(number);
  const std::string letters = letters_of(code);
  const auto has = [&](std::string_view some) { return letters.find_first_of(some) != std::string::npos; };
  const bool has_clock = has("hs"), has_date = has("yd");
  if (has_clock) return has_date ? CellKind::date_and_clock : CellKind::clock;
  return has_date || has("m") ? CellKind::date : CellKind::number;
}

std::vector<CellKind> read_cell_styles(const ZipArchive& archive, const std::string& part) {
  std::map<std::size_t, std::string> codes;
  std::vector<CellKind> kinds;
  bool in_cells = false;  // cellXfs are of cells; cellStyleXfs of styles that these begin from
  const auto number_of = [](const XmlAttributes& attributes, std::string_view name) {
    const std::string_view text = attributes.find(name).value_or("0");
    std::size_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  };
  const auto begin = [&](std::string_view name, const XmlAttributes& attributes) {
    if (name == "numFmt")
      codes.insert_or_assign(number_of(attributes, "numFmtId"),
                             std::string(attributes.find("formatCode").value_or("")));
    if (name == "cellXfs") in_cells = true;
    if (name != "xf" || !in_cells) return;
    const std::size_t number = number_of(attributes, "numFmtId");
    const auto code = codes.find(number);
    kinds.push_back(kind_of_format(number, code == codes.end() ? std::string_view{} : code->second));
  };
  const auto end = [&](std::string_view name) {
    if (name == "cellXfs") in_cells = false;
  };
  XmlStream xml({begin, end, [](std::string_view) {}});
  archive.read(part, [&](std::string_view piece) { xml.feed(piece); });
  xml.finish();
  return kinds;
}

std::string shown_days(double days, CellKind kind, bool from_1904) {
  if (!(days >= 0) || days >= longest) return fmt::format("{} days", days);
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
