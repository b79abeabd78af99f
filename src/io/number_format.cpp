#include "io/number_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "io/input_error.h"
#include "io/quantity.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double none = not_a_number;
constexpr std::size_t damaged_share = 100;  // cells per damaged cell, at least; empirical

// The digits and marks of a cell, without sign and exponent.
std::string_view mantissa_of(std::string_view cell) {
  if (cell.starts_with('+') || cell.starts_with('-')) cell.remove_prefix(1);
  return cell.substr(0, cell.find_first_of("eE"));
}

// True for digits in groups of three after a group of one to three, "1,234,567", all before `end`.
bool in_groups(std::string_view whole, char mark) {
  const std::size_t first = whole.find(mark);
  if (first == 0 || first > 3 || first == std::string_view::npos) return false;
  if (whole.front() == '0') return false;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const bool at_mark = i >= first && (i - first) % 4 == 0;
    if (at_mark ? whole[i] != mark : !is_digit(whole[i])) return false;
  }
  return (whole.size() - first) % 4 == 0;
}

// The length in bytes of a space within a number, including no-break and narrow spaces; otherwise
// 0.
std::size_t space_at(std::string_view text) {
  for (const std::string_view space : {" ", "\u00a0", "\u202f"})
    if (text.starts_with(space)) return space.size();
  return 0;
}

// Exactly three digits, as a space between digits separates them.
bool begins_group(std::string_view text) {
  return text.size() >= 3 && std::all_of(text.begin(), text.begin() + 3, is_digit) &&
         (text.size() == 3 || !is_digit(text[3]));
}

bool looks_usual(std::string_view cell) {
  if (cell.empty()) return false;
  if (cell.front() == '+' || cell.front() == '-') cell.remove_prefix(1);
  bool digit = false;
  while (!cell.empty() && cell.front() != 'e' && cell.front() != 'E') {
    const bool is_part = is_digit(cell.front()) || cell.front() == '.' || cell.front() == ',' || cell.front() == '\'';
    digit = digit || is_digit(cell.front());
    const std::size_t space = is_part ? 0 : space_at(cell);
    if (!is_part && space == 0) return false;
    cell.remove_prefix(is_part ? 1 : space);
    if (!is_part && !(digit && begins_group(cell))) return false;
  }
  if (!digit || cell.empty()) return digit;
  cell.remove_prefix(1);
  if (!cell.empty() && (cell.front() == '+' || cell.front() == '-')) cell.remove_prefix(1);
  return !cell.empty() && std::all_of(cell.begin(), cell.end(), is_digit);
}

// The length in bytes of a non-ASCII minus at the start of a text; otherwise 0.
std::size_t minus_at(std::string_view text) {
  for (const std::string_view minus : {"\u2212", "\u2013", "\u2010", "\u2011", "\uff0d"})
    if (text.starts_with(minus)) return minus.size();
  return 0;
}

// True if in_usual_form changes the cell.
bool is_odd(std::string_view cell) {
  if (cell.empty()) return false;
  const auto is_rare = [](char c) { return c == 'D' || c == 'd' || c == '\xe2' || c == '\xef'; };
  return cell.front() == '(' || cell.back() == '-' || std::any_of(cell.begin(), cell.end(), is_rare);
}

// A number with the usual signs: "−1.5", "(1.5)" and "1.5-" as "-1.5", "1.5D+01" as "1.5E+01".
// "(1)" is not a number.
std::string in_usual_form(std::string_view cell) {
  bool is_negative = false;
  if (cell.size() > 3 && cell.front() == '(' && cell.back() == ')') {
    is_negative = true;
    cell = trimmed(cell.substr(1, cell.size() - 2));
  } else if (cell.size() > 1 && cell.back() == '-') {
    is_negative = true;
    cell.remove_suffix(1);
  }
  std::string usual;
  bool has_mark = false;
  for (std::size_t at = 0; at < cell.size();) {
    const std::size_t minus = minus_at(cell.substr(at));
    const std::string_view behind = cell.substr(std::min(at + 1, cell.size()));
    const bool is_exponent = (cell[at] == 'D' || cell[at] == 'd') && has_mark && behind.size() > 1 &&
                             (behind[0] == '+' || behind[0] == '-' || is_digit(behind[0])) && is_digit(behind[1]);
    has_mark = has_mark || cell[at] == '.' || cell[at] == ',';
    usual += minus > 0 ? '-' : is_exponent ? 'E' : cell[at];
    at += std::max<std::size_t>(minus, 1);
  }
  const bool is_signed = usual.starts_with('-') || usual.starts_with('+');
  return is_negative && !is_signed ? "-" + usual : usual;
}

// A number with ordinary spaces instead of other kinds.
std::string with_plain_spaces(std::string_view cell) {
  std::string plain;
  while (!cell.empty()) {
    const std::size_t space = space_at(cell);
    plain += space > 0 ? ' ' : cell.front();
    cell.remove_prefix(std::max<std::size_t>(space, 1));
  }
  return plain;
}

bool looks_numeric(std::string_view cell) {
  return looks_usual(cell) || (is_odd(cell) && looks_usual(in_usual_form(cell)));
}

// A number with a decimal point, otherwise NaN. Infinity is NaN too, because no instrument measures
// it.
double finite_number(std::string_view text) {
  const std::optional<double> value = plain_number(text);
  return value && std::isfinite(*value) ? *value : none;
}

}  // namespace

std::optional<double> plain_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = error == std::errc{} && end == text.data() + text.size();
  return is_whole ? std::optional(value) : std::nullopt;
}

double number_in(std::string_view cell, const NumberFormat& format) {
  if (format.decimal == '.' && format.thousands != '.')
    if (const double value = finite_number(cell); !std::isnan(value)) return value;
  const std::string spaced = with_plain_spaces(is_odd(cell) ? in_usual_form(cell) : std::string(cell));
  const std::string_view mantissa = mantissa_of(spaced);
  const std::string_view whole = mantissa.substr(0, mantissa.find(format.decimal));
  const bool grouped = format.thousands != '\0' && format.thousands != format.decimal &&
                       whole.find(format.thousands) != std::string_view::npos;
  if (grouped && !in_groups(whole, format.thousands)) return none;
  std::string plain;
  bool point_seen = false;
  for (const char c : spaced) {
    if (c == format.decimal) {
      if (std::exchange(point_seen, true)) return none;
      plain += '.';
    } else if (grouped && c == format.thousands && !point_seen) {
      continue;
    } else if (c == '.' || c == ',' || c == ' ' || c == '\'') {
      return none;
    } else {
      plain += c;
    }
  }
  return finite_number(plain);
}

void NumberEvidence::add(std::string_view text) {
  const std::string cell = is_odd(text) ? in_usual_form(text) : std::string(text);
  const bool has_exponent = cell.find_first_of("eE") != std::string_view::npos;
  const std::string_view mantissa = mantissa_of(cell);
  const std::size_t mark_at = mantissa.find_first_of(".,");
  const std::string_view whole = mantissa.substr(0, mark_at);
  if (std::count_if(whole.begin(), whole.end(), is_digit) > 3 && std::all_of(whole.begin(), whole.end(), is_digit))
    ++ungrouped_;
  if (whole.find('\'') != std::string_view::npos) ++apostrophes_;
  if (whole.find_first_of(" \xc2\xe2") != std::string_view::npos) ++spaces_;
  if (mark_at == std::string_view::npos) return;
  const std::size_t points = static_cast<std::size_t>(std::count(mantissa.begin(), mantissa.end(), '.'));
  const std::size_t commas = static_cast<std::size_t>(std::count(mantissa.begin(), mantissa.end(), ','));
  if (points > 0 && commas > 0) {
    const bool comma_last = mantissa.rfind(',') > mantissa.rfind('.');
    ++(comma_last ? comma_.as_decimal : point_.as_decimal);
    ++(comma_last ? point_.as_group : comma_.as_group);
    return;
  }
  Mark& mark = points > 0 ? point_ : comma_;
  const char sign = points > 0 ? '.' : ',';
  if (points + commas > 1)
    ++mark.as_group;
  else if (has_exponent || !in_groups(mantissa, sign))
    ++mark.as_decimal;
  else
    ++mark.either;
}

std::optional<char> NumberEvidence::decimal() const {
  const std::size_t points = point_.as_decimal;
  const std::size_t commas = comma_.as_decimal;
  if (points == 0 && commas == 0) {
    if (point_.as_group > 0 && comma_.as_group == 0) return ',';
    if (comma_.as_group > 0 && point_.as_group == 0) return '.';
    return std::nullopt;
  }
  if (std::min(points, commas) > std::max(points, commas) / damaged_share)
    throw InputError({.problem = fmt::format("The file has {} numbers with a decimal point and {} with a decimal comma",
                                             points, commas),
                      .remedy = "say which it is with --decimal"});
  return points > commas ? '.' : ',';
}

bool NumberEvidence::undecidable() const { return point_.either + comma_.either > 0; }

char NumberEvidence::thousands(char decimal) const {
  const Mark& other = decimal == '.' ? comma_ : point_;
  const Mark& same = decimal == '.' ? point_ : comma_;
  const std::size_t marked = same.as_decimal + same.either;
  if (same.as_group > marked / damaged_share) return decimal;
  // A file groups all numbers or none. If almost no number is grouped, a group is a damaged cell: a
  // flipped bit turns "12.345" into "12,345".
  const std::size_t enough = std::max(ungrouped_, marked / damaged_share);
  if (other.as_group > ungrouped_ || other.either > enough) return decimal == '.' ? ',' : '.';
  if (spaces_ > ungrouped_) return ' ';
  return apostrophes_ > ungrouped_ ? '\'' : '\0';
}

NumberCell number_cell(std::string_view cell) {
  if (cell.empty()) return {};
  const char first = cell.front();
  const bool may_begin = is_digit(first) || std::string_view("+-.,(\xe2\xef").find(first) != std::string_view::npos;
  if (!may_begin) return {};
  if (looks_numeric(cell)) return {cell, {}};
  const std::size_t space = cell.find_last_of(" \t");
  if (space == std::string_view::npos) return {};
  const std::string_view number = trimmed(cell.substr(0, space));
  const std::string_view unit = cell.substr(space + 1);
  if (!looks_numeric(number) || !(volts_in(unit) || machine_unit(unit))) return {};
  return {number, unit};
}

bool says_missing(std::string_view cell) {
  static constexpr std::array<std::string_view, 13> words{"nan", "n/a", "#n/a", "na",   "n.a.", "-",   "--",
                                                          "---", "–",   "—",    "null", "none", "----"};
  if (cell.empty()) return true;
  return cell.size() <= 4 && std::find(words.begin(), words.end(), folded(cell)) != words.end();
}

bool says_overload(std::string_view cell) {
  constexpr std::size_t longest = 24;  // [bytes] longer cells are prose
  static constexpr std::array<std::string_view, 12> words{"ol",  "o.l", "o.l.",  "ovl", "ovld", "ovfl",
                                                          "ovr", "oor", "satur", "inf", "∞",    "clip"};
  if (cell.empty() || cell.size() > longest) return false;
  const std::string all = folded(cell);
  std::string_view word = all;
  if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
  return word.starts_with('>') || word.starts_with('<') || word.starts_with("over") || word.starts_with("saturat") ||
         word.starts_with("out of range") || word.starts_with("überlauf") || word.starts_with("1.#inf") ||
         std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace flexslip
