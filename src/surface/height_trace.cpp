#include "surface/height_trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/elementary.h"
#include "numerics/fourier.h"

namespace flexslip {

Sampled sampled(std::span<const double> position, std::span<const double> height) {
  const std::size_t n = position.size();
  if (n < 2 || height.size() != n) throw std::invalid_argument("a height trace needs two positions with their heights");
  const bool turned = position.back() < position.front();
  const auto x = [&](std::size_t i) { return position[turned ? n - 1 - i : i]; };
  const auto z = [&](std::size_t i) { return height[turned ? n - 1 - i : i]; };
  const double step = (x(n - 1) - x(0)) / static_cast<double>(n - 1);
  Sampled out{{x(0), step, {}}, turned, 0, false};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (!(x(i + 1) > x(i)))
      throw std::invalid_argument("the positions of a height trace rise or fall, and " + std::to_string(i + 2) +
                                  " does not");
    out.unevenness = std::max(out.unevenness, std::abs((x(i + 1) - x(i)) / step - 1));
  }
  out.interpolated = out.unevenness > even_enough;
  std::size_t left = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!out.interpolated) {
      out.trace.height.push_back(z(i));
      continue;
    }
    const double at = out.trace.position(i);
    while (left + 2 < n && x(left + 1) <= at) ++left;
    const double share = std::clamp((at - x(left)) / (x(left + 1) - x(left)), 0.0, 1.0);
    out.trace.height.push_back(z(left) + share * (z(left + 1) - z(left)));
  }
  return out;
}

HeightTrace levelled(HeightTrace trace, std::size_t degree) {
  auto& z = trace.height;
  const std::size_t n = z.size();
  if (degree > max_degree || n <= degree)
    throw std::invalid_argument("a polynomial of degree " + std::to_string(degree) + " taken off " + std::to_string(n) +
                                " heights");
  // Orthonormal polynomials on the points themselves, one after the other, each made orthogonal twice.
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

double root_mean_square(std::span<const double> values) {
  double square = 0;
  for (const double each : values) square += each * each;
  return std::sqrt(square / static_cast<double>(values.size()));
}

double height_quantum(std::span<const double> height) {
  constexpr double equal = 1e-3, few = 3, often = 0.1;
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t i = 1; i < height.size(); ++i) greatest = std::max(greatest, std::abs(height[i] - height[i - 1]));
  for (std::size_t i = 1; i < height.size(); ++i) {
    const double distance = std::abs(height[i] - height[i - 1]);
    if (distance > 1e-9 * greatest) least = std::min(least, distance);
  }
  if (!(greatest > 0)) return 0;
  std::size_t close = 0;
  double fewest = std::numeric_limits<double>::infinity(), most = 0;  // quanta from one height to the next
  for (std::size_t i = 1; i < height.size(); ++i) {
    const double multiple = std::abs(height[i] - height[i - 1]) / least;
    if (std::abs(multiple - std::round(multiple)) > equal * std::max(multiple, 1.0)) return 0;
    if (multiple <= few + 0.5) ++close;
    fewest = std::min(fewest, std::round(multiple));
    most = std::max(most, std::round(multiple));
  }
  const bool is_often_close = static_cast<double>(close) >= often * static_cast<double>(height.size() - 1);
  return is_often_close && most > fewest ? least : 0;  // a straight line has no quantum
}

HeightTrace smoothed(HeightTrace trace, double cutoff) {
  if (!(cutoff > 0)) throw std::invalid_argument("a cutoff must be > 0, not " + std::to_string(cutoff));
  const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);  // ISO 16610-21
  const std::size_t n = trace.height.size();
  const double reach = 1.5 * cutoff / trace.step;  // where the weight is 2e-14 of that in the middle
  const auto most = static_cast<std::size_t>(std::min(std::floor(reach), static_cast<double>(n - 1)));
  const std::size_t padded = power_of_two_from(n + most + 1);
  // Heights, and a constant that counts the weights left at the ends, go through as the parts of complex numbers: as great, for the rounding of one
  // is found in the other.
  double greatest = 0;
  for (const double each : trace.height) greatest = std::max(greatest, std::abs(each));
  if (greatest == 0) return trace;
  Complexes weight(padded, 0), both(padded, 0);
  for (std::size_t k = 0; k <= most; ++k) {
    const double x = static_cast<double>(k) * trace.step / (alpha * cutoff);
    weight[k] = elementary::exp(-std::numbers::pi * x * x);
    if (k > 0) weight[padded - k] = weight[k];
  }
  for (std::size_t i = 0; i < n; ++i) both[i] = {trace.height[i], greatest};
  weight = fourier(std::move(weight));
  both = fourier(std::move(both));
  for (std::size_t j = 0; j < padded; ++j) both[j] *= weight[j].real();  // a symmetric column has a real transform
  both = inverse_fourier(std::move(both));
  for (std::size_t i = 0; i < n; ++i) trace.height[i] = greatest * (both[i].real() / both[i].imag());
  return trace;
}

}  // namespace flexslip
