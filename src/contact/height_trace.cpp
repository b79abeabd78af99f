#include "contact/height_trace.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/effort.h"
#include "numerics/elementary.h"

namespace flexslip {

HeightTrace sampled(std::span<const double> position, std::span<const double> height) {
  const std::size_t n = position.size();
  if (n < 2 || height.size() != n) throw std::invalid_argument("a height trace needs two positions with their heights");
  const bool turned = position.back() < position.front();
  const auto x = [&](std::size_t i) { return position[turned ? n - 1 - i : i]; };
  const auto z = [&](std::size_t i) { return height[turned ? n - 1 - i : i]; };
  const double step = (x(n - 1) - x(0)) / static_cast<double>(n - 1);
  double unevenness = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (!(x(i + 1) > x(i)))
      throw std::invalid_argument("the positions of a height trace rise or fall, and " + std::to_string(i + 2) +
                                  " does not");
    unevenness = std::max(unevenness, std::abs((x(i + 1) - x(i)) / step - 1));
  }
  HeightTrace trace{x(0), step, {}};
  std::size_t left = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (unevenness <= even_enough) {
      trace.height.push_back(z(i));
      continue;
    }
    const double at = trace.position(i);
    while (left + 2 < n && x(left + 1) <= at) ++left;
    const double share = std::clamp((at - x(left)) / (x(left + 1) - x(left)), 0.0, 1.0);
    trace.height.push_back(z(left) + share * (z(left + 1) - z(left)));
  }
  return trace;
}

HeightTrace levelled(HeightTrace trace, std::size_t degree) {
  auto& z = trace.height;
  const std::size_t n = z.size();
  if (degree > max_degree || n <= degree)
    throw std::invalid_argument("a polynomial of degree " + std::to_string(degree) + " taken off " + std::to_string(n) +
                                " heights");
  // Orthonormal polynomials on the points, each orthogonalised twice.
  std::vector<std::vector<double>> basis;
  for (std::size_t power = 0; power <= degree; ++power) {
    std::vector<double> next(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double t = n == 1 ? 0 : 2 * static_cast<double>(i) / static_cast<double>(n - 1) - 1;
      next[i] = power == 0 ? 1 : t * basis.back()[i];
    }
    for (int again = 0; again < 2; ++again)
      for (const auto& known : basis) {
        double along = 0;
        for (std::size_t i = 0; i < n; ++i) along += next[i] * known[i];
        for (std::size_t i = 0; i < n; ++i) next[i] -= along * known[i];
      }
    double square = 0;
    for (const double each : next) square += each * each;
    for (double& each : next) each /= std::sqrt(square);
    basis.push_back(std::move(next));
  }
  for (int again = 0; again < 2; ++again)
    for (const auto& known : basis) {
      double along = 0;
      for (std::size_t i = 0; i < n; ++i) along += z[i] * known[i];
      for (std::size_t i = 0; i < n; ++i) z[i] -= along * known[i];
    }
  return trace;
}

HeightTrace smoothed(HeightTrace trace, double cutoff) {
  if (!(cutoff > 0)) throw std::invalid_argument("a cutoff must be > 0, not " + std::to_string(cutoff));
  const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);  // ISO 16610-21
  const std::vector<double> height = trace.height;
  const std::size_t n = height.size();
  const double reach = 1.5 * cutoff / trace.step;  // where the weight is 2e-14 of its maximum
  const auto max_k = static_cast<std::size_t>(std::min(std::floor(reach), static_cast<double>(n - 1)));
  std::vector<double> weight;
  for (std::size_t k = 0; k <= max_k; ++k) {
    const double x = static_cast<double>(k) * trace.step / (alpha * cutoff);
    weight.push_back(elementary::exp(-std::numbers::pi * x * x));
  }
  effort_spent += n * weight.size();
  for (std::size_t i = 0; i < n; ++i) {
    double sum = weight[0] * height[i], weights = weight[0];
    for (std::size_t k = 1; k <= max_k; ++k) {
      if (k <= i) sum += weight[k] * height[i - k];
      if (k <= i) weights += weight[k];
      if (i + k < n) sum += weight[k] * height[i + k];
      if (i + k < n) weights += weight[k];
    }
    trace.height[i] = sum / weights;
  }
  return trace;
}

}  // namespace flexslip
