#include "instruments/voltage.h"

#include <cmath>

#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double follows = 0.9;  // |correlation|: two cells in one load train; empirical, a real pair gave 0.999
constexpr double noise = 1;      // of the ratio below: white noise has 2, a curve sampled finely almost 0

double correlation(std::span<const double> x, std::span<const double> y) {
  double n = 0, mean_x = 0, mean_y = 0, sxx = 0, syy = 0, sxy = 0;  // Welford's sums: no cancellation
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isnan(x[i]) || std::isnan(y[i])) continue;
    ++n;
    const double dx = x[i] - mean_x;
    const double dy = y[i] - mean_y;
    mean_x += dx / n;
    mean_y += dy / n;
    sxx += dx * (x[i] - mean_x);
    syy += dy * (y[i] - mean_y);
    sxy += dx * (y[i] - mean_y);
  }
  return sxx > 0 && syy > 0 ? sxy / std::sqrt(sxx * syy) : 0;
}

// Von Neumann's ratio: mean square of the steps over the variance.
double step_ratio(std::span<const double> values) {
  double n = 0, mean = 0, sum = 0, steps = 0;
  double last = not_a_number;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    ++n;
    const double d = value - mean;
    mean += d / n;
    sum += d * (value - mean);
    if (!std::isnan(last)) steps += (value - last) * (value - last);
    last = value;
  }
  return sum > 0 ? steps / sum : 2;
}

}  // namespace

std::optional<VoltageFinding> voltage_for_force(std::span<const MeasuredColumn> columns) {
  std::optional<std::size_t> force;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].is_force && !columns[i].is_voltage) force = i;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].is_voltage) continue;
    if (!force) return VoltageFinding{i, not_a_number, false};
    const double r = correlation(columns[*force].values, columns[i].values);
    const bool is_noise = step_ratio(columns[*force].values) > noise && step_ratio(columns[i].values) < noise;
    if (std::abs(r) >= follows || is_noise) return VoltageFinding{i, r, is_noise};
  }
  return std::nullopt;
}

}  // namespace flexslip
