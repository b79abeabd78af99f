#include "numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/elementary.h"
#include "numerics/root.h"

namespace flexslip {

Estimate student_estimate(double value, double standard_error, double freedom) {
  const double reach = student_quantile(two_sided_95, freedom) * standard_error;
  return {value, standard_error, value - reach, value + reach};
}

Estimate scaled(const Estimate& estimate, double factor) {
  return {estimate.value * factor, estimate.standard_error * factor, estimate.low * factor, estimate.high * factor};
}

Estimate exponential(const Estimate& logarithm) {
  const double value = elementary::exp(logarithm.value);
  return {value, value * logarithm.standard_error, elementary::exp(logarithm.low), elementary::exp(logarithm.high)};
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile_in_order(std::span<const double> values, double probability) {
  if (values.empty()) return not_a_number;
  const double place = probability * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<double> second_differences(std::span<const double> readings) {
  std::vector<double> bends;
  for (std::size_t i = 2; i < readings.size(); ++i)
    bends.push_back(std::abs(readings[i] - 2 * readings[i - 1] + readings[i - 2]));
  return bends;
}

double noise_of_second_differences(std::vector<double> bends) {
  return bends.empty() ? 0 : deviation_by_median * median_of(std::move(bends)) / std::sqrt(6.0);
}

double median_of(std::vector<double> values) {
  if (values.empty()) return not_a_number;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::vector<double> non_falling(std::span<const double> values) {
  struct Block {
    double mean;
    std::size_t size;
  };
  std::vector<Block> blocks;
  for (const double value : values) {
    blocks.push_back({value, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean > blocks.back().mean) {
      const Block last = blocks.back();
      blocks.pop_back();
      Block& before = blocks.back();
      const auto a = static_cast<double>(before.size), b = static_cast<double>(last.size);
      before = {(before.mean * a + last.mean * b) / (a + b), before.size + last.size};
    }
  }
  std::vector<double> result;
  result.reserve(values.size());
  for (const auto& block : blocks) result.insert(result.end(), block.size, block.mean);
  return result;
}

std::vector<double> advancing(std::span<const double> values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(std::max(value, result.empty() ? 0.0 : result.back()));
  return result;
}

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
  return line_through(
      x.size(), [&](std::size_t i) { return x[i]; }, [&](std::size_t i) { return y[i]; });
}

CommonLine common_line(std::span<const double> x, std::span<const double> y, std::span<const double> z) {
  CommonLine common{line_through(x, y), line_through(x, z), not_a_number, {}};
  if (!(common.y.slope > 0 && common.z.slope > 0)) return common;
  common.slope = common.y.slope / common.z.slope;
  common.residuals.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    common.residuals.push_back(y[i] - common.y.mean_y - common.slope * (z[i] - common.z.mean_y));
  return common;
}

double slope_error(const CommonLine& line, double bias, double most) {
  return effective_deviation(line.residuals, 2, bias, most) / (line.z.slope * std::sqrt(line.y.sum_xx));
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

namespace {

// ln Γ(a) by Stirling's series for a >= 12, where the next term is below 1e-13.
double log_gamma(double a) {
  double shift = 0;
  for (; a < 12; a += 1) shift += elementary::log(a);
  const double b = 1 / (a * a);
  const double series = (1.0 / 12 - b * (1.0 / 360 - b * (1.0 / 1260 - b * (1.0 / 1680 - b / 1188)))) / a;
  return (a - 0.5) * elementary::log(a) - a + 0.5 * elementary::log(2 * std::numbers::pi) + series - shift;
}

// The incomplete gamma function Q(a, x): for x < a + 1 by the series of 1 - Q, otherwise by the
// continued fraction of Q (Lentz).
double gamma_beyond(double a, double x) {
  if (!(x > 0)) return 1;
  const double front = elementary::exp(a * elementary::log(x) - x - log_gamma(a));
  constexpr double enough = 1e-15;
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > enough * sum; n += 1) sum += term *= x / n;
    return 1 - front * sum;
  }
  constexpr double tiny = 1e-300;
  double b = x + 1 - a, c = 1 / tiny, d = 1 / b, h = d;
  for (double i = 1; i < 1e7; i += 1) {
    const double an = -i * (i - a);
    b += 2;
    d = 1 / (std::abs(an * d + b) < tiny ? tiny : an * d + b);
    c = std::abs(b + an / c) < tiny ? tiny : b + an / c;
    h *= d * c;
    if (std::abs(d * c - 1) < enough) break;
  }
  return front * h;
}

}  // namespace

double chi_squared_beyond(double x, double freedoms) { return gamma_beyond(0.5 * freedoms, 0.5 * x); }

double mean_of(const NormalMixture& mixture) {
  double weight = 0, sum = 0;
  for (const auto& part : mixture) {
    weight += part.weight;
    sum += part.weight * part.mean;
  }
  return sum / weight;
}

NormalMixture widened(NormalMixture mixture, double by) {
  for (NormalPart& part : mixture) part.deviation = elementary::length(part.deviation, by);
  return mixture;
}

double deviation_of(const NormalMixture& mixture) {
  const double mean = mean_of(mixture);
  double weight = 0, sum = 0;
  for (const auto& part : mixture) {
    weight += part.weight;
    sum += part.weight * (part.deviation * part.deviation + (part.mean - mean) * (part.mean - mean));
  }
  return std::sqrt(sum / weight);
}

double probability_below(const NormalMixture& mixture, double x) {
  double weight = 0, sum = 0;
  for (const auto& part : mixture) {
    weight += part.weight;
    const double away = x - part.mean;
    const double below = part.deviation > 0
                             ? elementary::exp(elementary::gaussian_below(away / part.deviation).log_probability)
                             : (away > 0 ? 1.0 : 0.0);
    sum += part.weight * below;
  }
  return sum / weight;
}

double quantile_of(const NormalMixture& mixture, double probability) {
  constexpr double reach = 12;  // deviations; the probability beyond is negligible
  double low = infinity, high = -low;
  for (const auto& part : mixture) {
    low = std::min(low, part.mean - reach * part.deviation);
    high = std::max(high, part.mean + reach * part.deviation);
  }
  return halved(50, {low, high}, [&](double x) { return !(probability_below(mixture, x) < probability); }).middle();
}

}  // namespace flexslip
