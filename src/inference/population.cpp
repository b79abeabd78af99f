#include "inference/population.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>

#include "fibre/elementary.h"
#include "fibre/limits.h"
#include "inference/likelihood.h"
#include "inference/line_density.h"

namespace flexslip {
namespace {

constexpr double farthest = 6;     // of the scale of T, beyond which its prior leaves nothing
constexpr double negligible = 16;  // ln of how far below the greatest value
constexpr std::size_t looks = 24;  // at T, each two thirds of the one before: down to the scale over 2000
constexpr double closer = 2.0 / 3;
constexpr std::size_t spreads = 48;  // places of T where it matters

double sinh(double x) { return 0.5 * (elementary::exp(x) - elementary::exp(-x)); }
double cosh(double x) { return 0.5 * (elementary::exp(x) + elementary::exp(-x)); }
double asinh(double x) { return elementary::log(x + std::sqrt(x * x + 1)); }

// T = unit sinh(v): evenly spaced in v it is spaced evenly near 0, where its density is even, and by factors where it has a long tail.
struct SpreadAxis {
  double unit;
  double begin, step;  // of v

  double v(std::size_t i) const { return begin + step * static_cast<double>(i); }
  double spread(double v_) const { return unit * sinh(v_); }
};

// The population at one T.
struct Slice {
  double spread;
  LineDensity mean;    // of M
  double log_density;  // of T
};

class Specimens {
 public:
  Specimens(std::span<const Marginal> tests, const PriorKnowledge& typical) : typical_(typical) {
    for (const auto& test : tests) records_.push_back(likelihood_of(test));
  }

  Population population() const {
    std::vector<Slice> slices;
    const SpreadAxis axis = axis_of_spread();
    for (std::size_t i = 0; i < spreads; ++i) slices.push_back(slice(axis.spread(axis.v(i)), 0.25));
    double greatest = -infinity;
    for (const auto& at : slices) greatest = std::max(greatest, at.log_density);
    std::vector<double> weights;
    for (std::size_t i = 0; i < spreads; ++i)
      weights.push_back(elementary::exp(slices[i].log_density - greatest) * cosh(axis.v(i)));
    const LineDensity density(axis.begin, axis.step, weights);
    if (axis.begin == 0) weights.front() *= 0.5;  // the axis begins at T = 0, in the middle of its first cell
    // Where T = 0 is hardly less likely than the likeliest: 1.92 = 1.96²/2.
    const bool bound = axis.begin == 0 && slices.front().log_density > greatest - 1.92;
    return {mean_of(slices, weights), spread_of(axis, density, slices, weights, bound), bound,
            specimens(slices, weights)};
  }

 private:
  std::vector<Likelihood> factors_at(double spread) const {
    std::vector<Likelihood> factors;
    factors.reserve(records_.size() + 1);
    for (const auto& record : records_) factors.push_back(blurred(record, spread));
    factors.push_back(likelihood_of_normal(typical_.mean, typical_.deviation));
    return factors;
  }

  Slice slice(double spread, double step) const {
    auto product = density_of_product(factors_at(spread), step);
    const double prior = -0.5 * (spread / typical_.deviation) * (spread / typical_.deviation);
    return {spread, std::move(product.density), product.log_integral + prior};
  }

  // Where T matters, by its probability in a step of its logarithm.
  SpreadAxis axis_of_spread() const {
    constexpr double coarse = 0.7;
    std::vector<double> at, logs;
    for (double spread = farthest * typical_.deviation; at.size() < looks; spread *= closer) {
      at.push_back(spread);
      logs.push_back(slice(spread, coarse).log_density + elementary::log(spread));
    }
    const auto best = std::max_element(logs.begin(), logs.end());
    const auto matters = [&](double log) { return log > *best - negligible; };
    const auto first = std::find_if(logs.begin(), logs.end(), matters) - logs.begin();
    const auto last = logs.rend() - std::find_if(logs.rbegin(), logs.rend(), matters) - 1;
    const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - 1, 0));
    const auto after = static_cast<std::size_t>(last + 1);
    const double unit = at[static_cast<std::size_t>(best - logs.begin())];
    const double begin = after < at.size() ? asinh(at[after] / unit) : 0;
    return {unit, begin, (asinh(at[before] / unit) - begin) / (spreads - 1)};
  }

  static Estimate spread_of(const SpreadAxis& axis, const LineDensity& density, const std::vector<Slice>& slices,
                            const std::vector<double>& weights, bool bound) {
    const auto quantile = [&](double probability) { return axis.spread(density.quantile(probability)); };
    double total = 0, sum = 0, squares = 0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
      total += weights[i];
      sum += weights[i] * slices[i].spread;
      squares += weights[i] * slices[i].spread * slices[i].spread;
    }
    const double mean = sum / total;
    return {quantile(0.5), std::sqrt(squares / total - mean * mean), bound ? 0 : quantile(0.025), quantile(0.975)};
  }

  static Estimate mean_of(const std::vector<Slice>& slices, const std::vector<double>& weights) {
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    double mean = 0, squares = 0;
    double low = infinity, high = -low;
    for (std::size_t j = 0; j < slices.size(); ++j) {
      const auto& line = slices[j].mean;
      mean += weights[j] * line.mean() / total;
      squares += weights[j] * (line.mean() * line.mean() + line.deviation() * line.deviation()) / total;
      low = std::min(low, line.place(0));
      high = std::max(high, line.place(line.size() - 1));
    }
    const auto quantile = [&](double probability) {
      double from = low, to = high;
      for (int i = 0; i < 50; ++i) {
        const double middle = std::midpoint(from, to);
        double below = 0;
        for (std::size_t j = 0; j < slices.size(); ++j) below += weights[j] * slices[j].mean.probability_below(middle);
        (below < probability * total ? from : to) = middle;
      }
      return std::midpoint(from, to);
    };
    return {quantile(0.5), std::sqrt(std::max(squares - mean * mean, 0.0)), quantile(0.025), quantile(0.975)};
  }

  // At given M and T a specimen is its record's bells, each drawn towards M.
  std::vector<Estimate> specimens(const std::vector<Slice>& slices, const std::vector<double>& weights) const {
    std::vector<Estimate> drawn;
    for (const auto& record : records_) {
      double total = 0, sum = 0, squares = 0;
      for (std::size_t j = 0; j < slices.size(); ++j) {
        if (weights[j] < 1e-5) continue;  // of the greatest: a thousandth of the standard error at most
        const double variance = slices[j].spread * slices[j].spread;
        const auto seen = blurred(record, slices[j].spread);
        const auto& line = slices[j].mean;
        const double places = static_cast<double>(line.size()) - 1;
        const double every = (line.place(line.size() - 1) - line.place(0)) / places;
        for (std::size_t i = 0; i < line.size(); ++i) {
          const double M = line.place(i);
          const double whole = seen.size() > 1 ? log_of(seen, M) : 0;
          for (std::size_t c = 0; c < record.size(); ++c) {
            const Bell& bell = record[c];
            const double d = M - seen[c].at;
            const double share =
                seen.size() > 1
                    ? elementary::exp(
                          std::max(seen[c].height + d * (seen[c].slope - 0.5 * seen[c].curvature * d) - whole, -700.0))
                    : 1;
            const double weight = weights[j] * every * line.at(i) * share;
            const double wider = 1 + bell.curvature * variance;
            const double x = (variance * (bell.curvature * bell.at + bell.slope) + M) / wider;
            total += weight;
            sum += weight * x;
            squares += weight * (x * x + variance / wider);
          }
        }
      }
      const double mean = sum / total;
      drawn.push_back(normal_estimate(mean, std::sqrt(std::max(squares / total - mean * mean, 0.0))));
    }
    return drawn;
  }

  std::vector<Likelihood> records_;
  PriorKnowledge typical_;
};

}  // namespace

Population population_of(std::span<const Marginal> tests, const PriorKnowledge& typical) {
  if (tests.size() < 2 || !(typical.deviation > 0 && std::isfinite(typical.deviation)))
    throw std::invalid_argument("a population of " + std::to_string(tests.size()) + " tests, expected " +
                                std::to_string(typical.mean) + " ± " + std::to_string(typical.deviation));
  return Specimens(tests, typical).population();
}

}  // namespace flexslip
