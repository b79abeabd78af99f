#include "inference/line_density.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "fibre/elementary.h"
#include "fibre/limits.h"

namespace flexslip {
namespace {
constexpr double negligible = 18;  // ln of how far below the greatest value
constexpr std::size_t looks = 33;  // places of a coarse look

struct Range {
  double low, high;
};

// Beyond the middles of all bells every factor falls, one of them as fast as its widest bell.
Range range_of(std::span<const Likelihood> factors) {
  Range range{infinity, -infinity};
  double fastest = 0;
  for (const auto& factor : factors) {
    double flattest = infinity;
    for (const auto& bell : factor) {
      flattest = std::min(flattest, bell.curvature);
      if (!(bell.curvature > 0)) continue;
      const double middle = bell.at + bell.slope / bell.curvature;
      range = {std::min(range.low, middle), std::max(range.high, middle)};
    }
    fastest = std::max(fastest, flattest);
  }
  if (!(fastest > 0 && std::isfinite(fastest)))
    throw std::invalid_argument("no factor of the product bounds the number");
  const double reach = std::sqrt(2 * negligible / fastest);
  return {range.low - reach, range.high + reach};
}

double width_of_narrowest(std::span<const Likelihood> factors) {
  double curvature = 0;
  for (const auto& factor : factors)
    curvature += std::max_element(factor.begin(), factor.end(), [](const Bell& a, const Bell& b) {
                   return a.curvature < b.curvature;
                 })->curvature;
  return 1 / std::sqrt(curvature);
}

std::vector<double> logs_at(std::span<const Likelihood> factors, double begin, double step, std::size_t count) {
  std::vector<double> logs;
  logs.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    logs.push_back(log_of_product(factors, begin + step * static_cast<double>(i)));
  return logs;
}

// The part of a range outside of which the product is negligible.
Range cut(std::span<const Likelihood> factors, Range range, double width) {
  for (;;) {
    const double step = (range.high - range.low) / (looks - 1);
    const auto logs = logs_at(factors, range.low, step, looks);
    const double greatest = *std::max_element(logs.begin(), logs.end());
    // A peak is at most half a step from a look, and the product bends no more sharply than its narrowest bell.
    const double hidden = 0.125 * (step / width) * (step / width);
    const auto matters = [&](double log) { return log > greatest - negligible - hidden; };
    const auto first = std::find_if(logs.begin(), logs.end(), matters) - logs.begin();
    const auto last = logs.rend() - std::find_if(logs.rbegin(), logs.rend(), matters) - 1;
    const Range left{std::max(range.low, range.low + step * (static_cast<double>(first) - 1)),
                     std::min(range.high, range.low + step * (static_cast<double>(last) + 1))};
    const bool settled = left.high - left.low > 0.6 * (range.high - range.low);
    range = left;
    if (settled) return range;
  }
}

}  // namespace

LineDensity::LineDensity(double begin, double step, std::vector<double> values)
    : begin_(begin), step_(step), density_(std::move(values)), below_(density_.size(), 0) {
  const std::size_t n = density_.size();
  const auto whole = std::accumulate(density_.begin(), density_.end(), 0.0);
  if (n < 4 || !(step > 0) || !(whole > 0) || !std::isfinite(whole))
    throw std::invalid_argument("a density needs four values or more, not " + std::to_string(n) + " of sum " +
                                std::to_string(whole));
  // Between two places the integral of the cubic through the four about them.
  const auto& p = density_;
  double integral = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double part = i == 0       ? 9 * p[0] + 19 * p[1] - 5 * p[2] + p[3]
                        : i + 2 == n ? 9 * p[n - 1] + 19 * p[n - 2] - 5 * p[n - 3] + p[n - 4]
                                     : -p[i - 1] + 13 * (p[i] + p[i + 1]) - p[i + 2];
    integral += step * part / 24;
    below_[i + 1] = std::max(integral, below_[i]);  // where a coarse step overshoots
  }
  for (double& value : density_) value /= integral;
  for (double& value : below_) value /= integral;
}

double LineDensity::mean() const {
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    sum += density_[i] * place(i);
    weight += density_[i];
  }
  return sum / weight;
}

double LineDensity::deviation() const {
  const double middle = mean();
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    sum += density_[i] * (place(i) - middle) * (place(i) - middle);
    weight += density_[i];
  }
  return std::sqrt(sum / weight);
}

double LineDensity::probability_below(double x) const {
  const double places = (x - begin_) / step_;
  if (!(places > 0)) return 0;
  if (places >= static_cast<double>(size() - 1)) return 1;
  const auto i = static_cast<std::size_t>(places);
  // Hermite's cubic: the density is the slope.
  const double t = places - static_cast<double>(i);
  const double rise = below_[i + 1] - below_[i];
  const double start = step_ * density_[i], end = step_ * density_[i + 1];
  const double here = below_[i] + t * (start + t * ((3 * rise - 2 * start - end) + t * (start + end - 2 * rise)));
  return std::clamp(here, below_[i], below_[i + 1]);
}

double LineDensity::quantile(double probability) const {
  double low = begin_, high = place(size() - 1);
  for (int i = 0; i < 60; ++i) {
    const double middle = std::midpoint(low, high);
    (probability_below(middle) < probability ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

ProductDensity density_of_product(std::span<const Likelihood> factors, double step) {
  if (factors.empty() || !(step > 0 && step <= 0.7))
    throw std::invalid_argument("a product of " + std::to_string(factors.size()) + " likelihoods at steps of " +
                                std::to_string(step));
  const double width = width_of_narrowest(factors);
  const Range range = cut(factors, range_of(factors), width);
  constexpr double most = 20000;  // places, lest one odd part of a posterior take all memory
  const double intervals = std::clamp(std::ceil((range.high - range.low) / (step * width)), 4.0, most);
  const double spacing = (range.high - range.low) / intervals;
  auto values = logs_at(factors, range.low, spacing, static_cast<std::size_t>(intervals) + 1);
  const double greatest = *std::max_element(values.begin(), values.end());
  double sum = 0;  // the trapezoidal rule, which of sums of bells is exact
  for (double& value : values) sum += value = elementary::exp(value - greatest);
  return {LineDensity(range.low, spacing, std::move(values)), greatest + elementary::log(spacing * sum)};
}

}  // namespace flexslip
