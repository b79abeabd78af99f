#include "instruments/dated_column.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "instruments/column_unit.h"
#include "io/input_error.h"
#include "numerics/elementary.h"

namespace flexslip {

std::string take_dated(const ExportCells& cells, std::span<const std::size_t> lines, std::size_t column,
                       std::size_t numbers, ExportColumn& out) {
  const auto count = [&](const auto& is) {
    return static_cast<std::size_t>(
        std::count_if(lines.begin(), lines.end(), [&](std::size_t line) { return is(cells.kind(line, column)); }));
  };
  const bool is_clock = count([](CellKind kind) { return kind == CellKind::clock; }) == numbers;
  const bool has_date = count([](CellKind kind) { return kind == CellKind::date_and_clock; }) == numbers;
  const std::optional<Unit> unit = machine_unit(out.unit.empty() ? "s" : out.unit);
  if (out.role == ColumnRole::time && (is_clock || has_date) && unit && unit->dimension == kind::time.dimension) {
    double from = not_a_number;  // [days] the midnight before the first, of dates
    for (const std::size_t line : lines) {
      const double days = cells.days(line, column);
      if (std::isnan(from) && !std::isnan(days)) from = has_date ? std::floor(days) : 0;
      out.values.push_back(from_si((days - from) * 86400, *unit));
    }
    if (out.unit.empty()) out.unit = "s";
    return fmt::format("column {} holds clock times, read in {}{}", in_quotes(out.name), out.unit,
                       has_date ? ", from the midnight before the first" : "");
  }
  if (out.role != ColumnRole::other || count(is_dated) != numbers) return "";
  out.values.assign(lines.size(), not_a_number);
  for (const std::size_t line : lines) out.words.push_back(cells.shown(line, column));
  return fmt::format("column {} holds dates or clock times and is kept as text", in_quotes(out.name));
}

}  // namespace flexslip
