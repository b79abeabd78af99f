#include "data/line.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flexslip {
namespace {

struct Sums {
  double squares, lagged;
};

Sums sums_of(std::span<const double> residuals) {
  Sums sums{0, 0};
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    sums.squares += residuals[i] * residuals[i];
    if (i > 0) sums.lagged += residuals[i] * residuals[i - 1];
  }
  return sums;
}

}  // namespace

Line line_through(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  Line line{.mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n,
            .mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n,
            .slope = 0,
            .sum_xx = 0};
  double sum_xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    line.sum_xx += (x[i] - line.mean_x) * (x[i] - line.mean_x);
    sum_xy += (x[i] - line.mean_x) * (y[i] - line.mean_y);
  }
  line.slope = line.sum_xx > 0 ? sum_xy / line.sum_xx : 0;
  return line;
}

double effective_deviation(std::span<const double> residuals, std::size_t parameters, double bias, double most) {
  const Sums sums = sums_of(residuals);
  if (sums.squares == 0) return 0;
  const double rho = std::clamp(sums.lagged / sums.squares + bias, 0.0, most);
  return std::sqrt(sums.squares / static_cast<double>(residuals.size() - parameters) * (1 + rho) / (1 - rho));
}

double correlation_lost_to_line(std::span<const double> residuals) {
  const Sums sums = sums_of(residuals);
  const double shown = sums.squares > 0 ? sums.lagged / sums.squares : 0;
  return (2 + 4 * shown) / static_cast<double>(residuals.size());
}

}  // namespace flexslip
