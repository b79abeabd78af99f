#include "numerics/polynomial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/elementary.h"

namespace flexslip::chebyshev {
namespace {

// Cosines k (j + 1/2) π/terms, by which values at the nodes j become coefficients k.
const std::array<Nodes, terms>& node_cosines() {
  static const auto cosines = [] {
    std::array<Nodes, terms> table{};
    for (std::size_t k = 0; k < terms; ++k)
      for (std::size_t j = 0; j < terms; ++j)
        table[k][j] = elementary::sine_and_cosine(std::numbers::pi * static_cast<double>(k) *
                                                  (static_cast<double>(j) + 0.5) / static_cast<double>(terms))
                          .cosine;
    return table;
  }();
  return cosines;
}

}  // namespace

ValueAndSlope evaluate(const Series& series, double at) {
  const double inside = std::clamp(at, series.least, series.greatest);
  const double half_width = 0.5 * (series.greatest - series.least);
  const double x = (inside - 0.5 * (series.least + series.greatest)) / half_width;
  const auto [value, by_x] = series_slope_at(series.coefficients, x);
  const double slope = by_x / half_width;
  return {value + slope * (at - inside), slope};
}

Nodes nodes_between(double least, double greatest) {
  Nodes nodes{};
  for (std::size_t j = 0; j < terms; ++j)
    nodes[j] = 0.5 * (least + greatest) + 0.5 * (greatest - least) * node_cosines()[1][j];
  return nodes;
}

Series series_through(double least, double greatest, std::span<const double> at_nodes) {
  Series series{least, greatest, {}};
  for (std::size_t k = 0; k < terms; ++k) {
    for (std::size_t j = 0; j < terms; ++j) series.coefficients[k] += at_nodes[j] * node_cosines()[k][j];
    series.coefficients[k] *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(terms);
  }
  return series;
}

double inverse(const Series& series, double value) {
  double at = 0.5 * (series.least + series.greatest);
  for (int i = 0; i < 20; ++i) {
    const auto here = evaluate(series, at);
    const double step = std::clamp((value - here.value) / here.slope, -0.6, 0.6);
    at = std::clamp(at + step, series.least, series.greatest);
    if (std::abs(step) < 1e-8) break;
  }
  return at;
}

}  // namespace flexslip::chebyshev
