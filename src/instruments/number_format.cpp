#include "instruments/number_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include <fast_float/fast_float.h>

#include "io/input_error.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double none = not_a_number;
constexpr std::size_t damaged_share = 100;  // one cell in so many may be damaged; empirical, far above what disks do

// The part of a cell that marks can stand in: without sign and exponent.
std::string_view mantissa_of(std::string_view cell) {
  if (cell.starts_with('+') || cell.starts_with('-')) cell.remove_prefix(1);
  return cell.substr(0, cell.find_first_of("eE"));
}

// Digits in groups of three behind one to three, "1,234,567", all before `end`.
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

// Spaces of any kind in a number as ordinary ones.
std::string with_plain_spaces(std::string_view cell) {
  std::string plain;
  while (!cell.empty()) {
    std::size_t length = 1;
    for (const std::string_view space : {"\u00a0", "\u202f"})
      if (cell.starts_with(space)) length = space.size();
    plain += length > 1 ? ' ' : cell.front();
    cell.remove_prefix(length);
  }
  return plain;
}

// A number with a decimal point, or NaN. Infinities are none: no instrument measures them.
double plain_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && std::isfinite(value) ? value : none;
}

}  // namespace

double number_in(std::string_view cell, const NumberFormat& format) {
  const bool has_marks = cell.find_first_not_of("+-0123456789.eE") != std::string_view::npos;
  if (!has_marks && format.decimal == '.' && format.thousands != '.') return plain_number(cell);
  const std::string spaced = with_plain_spaces(cell);
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
  return plain_number(plain);
}

void NumberEvidence::add(std::string_view cell) {
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
    throw InputError({.expected = "one decimal mark",
                      .found = std::to_string(points) + " numbers with a decimal point and " + std::to_string(commas) +
                               " with a decimal comma",
                      .remedy = "say which it is with --decimal"});
  return points > commas ? '.' : ',';
}

bool NumberEvidence::undecidable() const { return point_.either + comma_.either > 0; }

char NumberEvidence::thousands(char decimal) const {
  const Mark& other = decimal == '.' ? comma_ : point_;
  const Mark& same = decimal == '.' ? point_ : comma_;
  const std::size_t marked = same.as_decimal + same.either;
  if (same.as_group > marked / damaged_share) return decimal;
  // Someone who groups digits groups all of them. Where others are not grouped, or hardly any are, a group is a damaged
  // cell: a flipped bit turns "12.345" into "12,345".
  const std::size_t enough = std::max(ungrouped_, marked / damaged_share);
  if (other.as_group > ungrouped_ || other.either > enough) return decimal == '.' ? ',' : '.';
  if (spaces_ > ungrouped_) return ' ';
  return apostrophes_ > ungrouped_ ? '\'' : '\0';
}

}  // namespace flexslip
