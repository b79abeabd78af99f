#include "instruments/regrouped.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "instruments/number_format.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::size_t fewest_decimals = 3;  // those of a group
constexpr std::size_t most_decimals = 6;    // that a column's other cells may show
// Times nearer than the next best. A decimal is a factor of 10, so a step may be up to a thirtieth of the value: that of a
// test recorded at thirty points a millimetre is, from 1 mm on.
constexpr double decisive = 30;
constexpr NumberFormat decimal_comma{',', '\0'};
constexpr NumberFormat grouped{'.', ','};

// What a cell may stand for: one value, or one for each number of decimals from three on.
struct Readings {
  std::array<double, most_decimals - fewest_decimals + 1> values{};
  std::size_t count = 0;
};

bool may_be_regrouped(std::string_view cell) {
  return cell.find(',') != std::string_view::npos && !std::isnan(number_in(cell, grouped));
}

std::size_t decimals_of(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  return comma == std::string_view::npos ? 0 : cell.size() - comma - 1;
}

Readings readings_of(std::string_view cell, std::size_t decimals) {
  if (!may_be_regrouped(cell)) {
    const double value = number_in(cell, decimal_comma);
    return {{value}, std::isnan(value) ? std::size_t{0} : std::size_t{1}};
  }
  std::string digits;
  for (const char c : cell)
    if (c != ',') digits += c;
  Readings readings;
  for (std::size_t behind = fewest_decimals; behind <= decimals; ++behind) {
    std::string text = digits;
    text.insert(text.size() - std::min(behind, text.size()), ".");
    readings.values[readings.count++] = number_in(text, {});
  }
  return readings;
}

// Is each other reading of one of two neighbours much farther from the other one's than the chosen? Two that differ
// together are not compared: the cells further on decide between those, up to one that has a single reading.
bool decides(const Readings& a, std::size_t chosen_a, const Readings& b, std::size_t chosen_b) {
  const double step = std::abs(a.values[chosen_a] - b.values[chosen_b]);
  for (std::size_t i = 0; i < a.count; ++i)
    if (i != chosen_a && std::abs(a.values[i] - b.values[chosen_b]) < decisive * step) return false;
  for (std::size_t i = 0; i < b.count; ++i)
    if (i != chosen_b && std::abs(a.values[chosen_a] - b.values[i]) < decisive * step) return false;
  return true;
}

}  // namespace

Regrouped restored(std::span<const std::string_view> cells) {
  std::size_t decimals = fewest_decimals;
  bool anchored = false;
  bool regrouped = false;
  for (const std::string_view cell : cells) {
    const bool may_be = may_be_regrouped(cell);
    regrouped = regrouped || (may_be && std::count(cell.begin(), cell.end(), ',') > 1);
    if (may_be || std::isnan(number_in(cell, decimal_comma))) continue;
    anchored = true;
    decimals = std::max(decimals, std::min(decimals_of(cell), most_decimals));
  }

  Regrouped result;
  result.values.reserve(cells.size());
  if (!regrouped) {
    for (const std::string_view cell : cells) result.values.push_back(number_in(cell, decimal_comma));
    return result;
  }
  result.status = anchored ? Regrouped::Status::restored : Regrouped::Status::ambiguous;

  // Shortest path: the least sum of |steps| that ends in each reading of a row, and where it came from.
  std::vector<Readings> rows;
  std::vector<std::array<std::size_t, most_decimals>> from(cells.size());
  std::array<double, most_decimals> cost{};
  std::size_t last = cells.size();  // the row before with a number
  rows.reserve(cells.size());
  for (std::size_t row = 0; row < cells.size(); ++row) {
    rows.push_back(readings_of(cells[row], decimals));
    if (rows[row].count == 0) continue;
    std::array<double, most_decimals> next{};
    for (std::size_t i = 0; last < cells.size() && i < rows[row].count; ++i) {
      next[i] = infinity;
      for (std::size_t j = 0; j < rows[last].count; ++j) {
        const double sum = cost[j] + std::abs(rows[row].values[i] - rows[last].values[j]);
        if (sum < next[i]) from[row][i] = j;
        next[i] = std::min(next[i], sum);
      }
    }
    cost = next;
    last = row;
  }

  std::vector<std::size_t> chosen(cells.size(), 0);
  if (last < cells.size()) {
    const auto* const end = cost.data() + rows[last].count;
    chosen[last] =
        static_cast<std::size_t>(std::min_element(static_cast<const double*>(cost.data()), end) - cost.data());
  }
  std::size_t later = cells.size();
  for (std::size_t row = cells.size(); row-- > 0;) {
    if (rows[row].count == 0) continue;
    if (later < cells.size()) chosen[row] = from[later][chosen[later]];
    later = row;
  }

  std::size_t before = cells.size();
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const Readings& readings = rows[row];
    result.values.push_back(readings.count == 0 ? not_a_number : readings.values[chosen[row]]);
    if (readings.count == 0) continue;
    const double value = result.values[row];
    if (readings.count > 1 && readings.values[0] != value) ++result.moved;
    const bool has_before = before < cells.size();
    if (has_before && !decides(rows[before], chosen[before], readings, chosen[row])) {
      if (result.status != Regrouped::Status::ambiguous) result.row = row;
      result.status = Regrouped::Status::ambiguous;
    }
    before = row;
  }
  return result;
}

}  // namespace flexslip
