#include "report/plot_units.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace flexslip {

std::string PlotUnit::column(std::string_view name) const {
  return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

Axis PlotUnit::axis(std::string label, double from, double to) const {
  return {std::move(label), unit, factor * from, factor * to};
}

PlotUnit plot_unit(double magnitude, const Kind& kind, bool reduced, std::string_view reduced_unit) {
  if (reduced) return {std::string(reduced_unit), 1};
  const std::string_view unit = best_unit(magnitude, kind);
  return {typeset(unit), from_si(1, parse_unit(unit))};
}

PlotUnit PlotUnits::unit(double magnitude, double scale, const Kind& kind, std::string_view reduced_unit) const {
  PlotUnit unit = plot_unit(scale * magnitude, in_inches ? flexslip::in_inches(kind) : kind, reduced, reduced_unit);
  unit.factor *= scale;
  return unit;
}

PlotUnits plot_units(const FittedTest& test) {
  return {test.analysis.scales, test.reduced, is_in_inches(test.measurement.test)};
}

double rounded_up(double value) {
  const double step = std::pow(10, std::floor(std::log10(value))) / 2;
  return step * std::ceil(value / step);
}

std::vector<std::vector<double>> thinned(const std::vector<std::vector<double>>& rows, double width, double height) {
  constexpr double finest = 0.003;  // of the figure: half a millimetre
  std::vector<std::vector<double>> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == rows.size() || rows[i].empty() || rows[i - 1].empty() || rows[i + 1].empty();
    if (is_end || std::hypot((rows[i][0] - kept.back()[0]) / width, (rows[i][1] - kept.back()[1]) / height) > finest)
      kept.push_back(rows[i]);
  }
  return kept;
}

}  // namespace flexslip
