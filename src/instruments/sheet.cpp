#include "instruments/sheet.h"

#include <algorithm>
#include <array>
#include <optional>

#include "instruments/column_unit.h"
#include "instruments/column_words.h"
#include "io/cells.h"
#include "io/quantity.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr std::size_t sample = 1000;  // lines judged for the separator; more do not change the answer
constexpr double of_blanks = 0.9;     // tabs are blanks too, but where they separate names have spaces in them

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

// The bytes of a space within a number, no-break and narrow ones as well; 0 if there is none.
std::size_t space_at(std::string_view text) {
  for (const std::string_view space : {" ", "\u00a0", "\u202f"})
    if (text.starts_with(space)) return space.size();
  return 0;
}

// Three digits and no fourth: what a space between digits separates.
bool begins_group(std::string_view text) {
  return text.size() >= 3 && std::all_of(text.begin(), text.begin() + 3, is_digit) &&
         (text.size() == 3 || !is_digit(text[3]));
}

bool looks_numeric(std::string_view cell) {
  if (cell.empty()) return false;
  if (cell.front() == '+' || cell.front() == '-') cell.remove_prefix(1);
  bool digit = false;
  while (!cell.empty() && cell.front() != 'e' && cell.front() != 'E') {
    const std::size_t space = space_at(cell);
    if (is_digit(cell.front()))
      digit = true;
    else if (space == 0 && cell.front() != '.' && cell.front() != ',' && cell.front() != '\'')
      return false;
    cell.remove_prefix(std::max<std::size_t>(space, 1));
    if (space > 0 && !(digit && begins_group(cell))) return false;
  }
  if (!digit || cell.empty()) return digit;
  cell.remove_prefix(1);
  if (!cell.empty() && (cell.front() == '+' || cell.front() == '-')) cell.remove_prefix(1);
  return !cell.empty() && std::all_of(cell.begin(), cell.end(), is_digit);
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

NumberCell number_cell(std::string_view cell) {
  if (cell.empty()) return {};
  const char first = cell.front();
  if ((first < '0' || first > '9') && first != '+' && first != '-' && first != '.' && first != ',') return {};
  if (looks_numeric(cell)) return {cell, {}};
  const std::size_t space = cell.find_last_of(" \t");
  if (space == std::string_view::npos) return {};
  const std::string_view number = trimmed(cell.substr(0, space));
  const std::string_view unit = cell.substr(space + 1);
  if (!looks_numeric(number) || !(is_voltage(unit) || machine_unit(unit))) return {};
  return {number, unit};
}

bool says_missing(std::string_view cell) {
  static constexpr std::array<std::string_view, 8> words{"nan", "n/a", "#n/a", "na", "-", "--", "---", "null"};
  if (cell.empty()) return true;
  return cell.size() <= 4 && std::find(words.begin(), words.end(), folded(cell)) != words.end();
}

Sheet::Sheet(std::string_view text, char separator) {
  while (!text.empty()) split(take_line(text), separator);
}

void Sheet::split(std::string_view line, char separator) {
  const std::size_t first = cells_.size();
  CellReader reader(line, separator);
  const bool may_be_quoted = line.find('"') != std::string_view::npos;
  while (const std::optional<std::string_view> cell = reader.next()) {
    cells_.push_back(*cell);
    if (!may_be_quoted || cell->find("\"\"") == std::string_view::npos) continue;
    unescaped_.push_back(unescaped(*cell));
    cells_.back() = unescaped_.back();
  }
  if (reader.broken()) {  // the quotes mean nothing
    cells_.resize(first);
    std::string_view rest = line;
    while (true) {
      const std::size_t end = separator == ' ' ? rest.find_first_of(" \t") : rest.find(separator);
      const std::string_view cell = trimmed(rest.substr(0, end));
      if (separator != ' ' || !cell.empty()) cells_.push_back(cell);
      if (end == std::string_view::npos) break;
      rest.remove_prefix(end + 1);
    }
  } else {
    quoted_ = quoted_ || may_be_quoted;
  }
  lines_.push_back({line, first, cells_.size() - first});
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

}  // namespace flexslip
