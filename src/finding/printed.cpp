#include "finding/printed.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace flexslip {
namespace {

class PrintedColumn {
 public:
  explicit PrintedColumn(const NumberColumn& column) {
    double largest = 0;
    for (const double value : column.values)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    const std::string_view unit = best_unit(largest, column.kind);
    if (!unit.empty()) scale_ = parse_unit(unit);
    title_ = unit.empty()           ? column.title
             : column.title.empty() ? typeset(unit)
                                    : fmt::format("{} ({})", column.title, typeset(unit));
    const double shown = from_si(largest, scale_);
    decimals_ = shown > 0 ? std::clamp(column.digits - 1 - static_cast<int>(std::floor(std::log10(shown))), 0, 9) : 1;
  }
  const std::string& title() const { return title_; }
  std::string cell(double value) const {
    if (!std::isfinite(value)) return "";
    const double shown = from_si(value, scale_);
    const bool is_zero = std::abs(shown) < 0.5 * std::pow(10, -decimals_);
    return fmt::format("{:.{}f}", is_zero ? 0 : shown, decimals_);
  }

 private:
  std::string title_;
  Unit scale_{};
  int decimals_ = 1;
};

}  // namespace

std::string Print::own(double value, const Kind& kind) const {
  return std::isfinite(value) ? readable(value, as(kind)) : "not known";
}

PrintedTable printed(const std::vector<NumberColumn>& columns) {
  PrintedTable table;
  for (const auto& column : columns) {
    const PrintedColumn print(column);
    table.head.push_back(print.title());
    table.rows.resize(column.values.size());
    for (std::size_t i = 0; i < column.values.size(); ++i) table.rows[i].push_back(print.cell(column.values[i]));
  }
  return table;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string percent_of(double part, double whole) {
  if (!(whole > 0)) return "";
  const double share = 100 * part / whole;
  return share != 0 && std::abs(share) < 0.05 ? "less than 0.1 %" : fmt::format("{:.1f} %", share);
}

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.0f} %", 100 * share) : "an unknown share";
}

std::string roughly(double value, const Kind& kind) {
  if (!std::isfinite(value) || value == 0) return readable(value, kind);
  const std::string_view unit = best_unit(value, kind);
  const Unit scale = unit.empty() ? Unit{} : parse_unit(unit);
  const double shown = from_si(value, scale);
  const double step = std::pow(10, std::floor(std::log10(std::abs(shown))) - 1);
  return readable(to_si(step * std::round(shown / step), scale), kind);
}

}  // namespace flexslip
