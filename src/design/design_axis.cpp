#include "design/design_axis.h"

#include <algorithm>
#include <cmath>

namespace flexslip {
namespace {

double grid_value(const DesignAxis& axis, std::uint64_t point) {
  if (const auto* values = std::get_if<AxisValues>(&axis.values)) return (*values)[point];
  const auto& range = std::get<AxisRange>(axis.values);
  return value_at(range, static_cast<double>(point) / static_cast<double>(range.points - 1));
}

}  // namespace

double value_at(const AxisRange& range, double t) {
  constexpr int halvings = 26;  // of the logarithm of the ratio, to 1e-8 of it: what is left is linear to rounding
  double from = range.from;
  double to = range.to;
  if (range.spacing == Spacing::logarithmic && t > 0 && t < 1)
    for (int i = 0; i < halvings; ++i) {
      const double middle = std::sqrt(from) * std::sqrt(to);
      t *= 2;
      (t < 1 ? to : from) = middle;
      if (t >= 1) t -= 1;
    }
  const auto [least, most] = std::minmax(range.from, range.to);
  return std::clamp((1 - t) * from + t * to, least, most);  // rounding must not carry it beyond its end
}

std::uint64_t points_of(const DesignAxis& axis) {
  const auto* range = std::get_if<AxisRange>(&axis.values);
  return range ? range->points : std::get<AxisValues>(axis.values).size();
}

std::vector<double> values_of(const DesignAxis& axis) {
  std::vector<double> values(points_of(axis));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = grid_value(axis, i);
  return values;
}

std::vector<double> grid_inputs(const std::vector<DesignAxis>& axes, std::uint64_t row) {
  std::vector<double> inputs(axes.size());
  for (std::size_t i = inputs.size(); i-- > 0;) {
    const std::uint64_t points = points_of(axes[i]);
    inputs[i] = grid_value(axes[i], row % points);
    row /= points;
  }
  return inputs;
}

}  // namespace flexslip
