#include "inference/population.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "numerics/elementary.h"
#include "numerics/polynomial.h"
#include "numerics/root.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr double bell_reach = 3;  // deviations of a part, beyond which its quotient does not rise
constexpr double nothing = -37;   // ln of what is lost in the rounding of a sum

double log_at(const Bell& bell, double x) {
  const double d = x - bell.at;
  return bell.height + d * (bell.slope - 0.5 * bell.curvature * d);
}

}  // namespace

Likelihood likelihood_of(const Marginal& marginal) {
  const double p = marginal.prior_mean;
  const double q = marginal.prior_deviation;
  if (marginal.posterior.empty() || !(q > 0))
    throw std::invalid_argument("a likelihood needs a posterior and a prior of some width");
  Likelihood bells;
  for (const auto& [weight, m, s] : marginal.posterior) {
    if (!(s > 0 && weight > 0 && std::isfinite(m)))
      throw std::invalid_argument("a posterior of " + std::to_string(m) + " ± " + std::to_string(s) +
                                  " is none of a number sought");
    const double height = elementary::log(weight) - elementary::log(s);
    if (std::isinf(q)) {
      bells.push_back({height, m, 0, 1 / (s * s)});
      continue;
    }
    const double slope = (m - p) / (q * q);
    const double own = 1 / (s * s) - 1 / (q * q);
    bells.push_back({height + 0.5 * (m - p) * slope, m, slope, std::max(own, std::abs(slope) / (bell_reach * s))});
  }
  return bells;
}

Likelihood likelihood_of_normal(double mean, double deviation) { return {{0, mean, 0, 1 / (deviation * deviation)}}; }

Likelihood blurred(const Likelihood& likelihood, double spread) {
  const double variance = spread * spread;
  Likelihood result = likelihood;
  for (auto& bell : result) {
    const double wider = 1 + bell.curvature * variance;
    bell.height += 0.5 * (bell.slope * bell.slope * variance / wider - elementary::log(wider));
    bell.slope /= wider;
    bell.curvature /= wider;
  }
  return result;
}

double log_of(const Likelihood& likelihood, double x) {
  if (likelihood.size() == 1) return log_at(likelihood.front(), x);
  double greatest = -infinity;
  for (const auto& bell : likelihood) greatest = std::max(greatest, log_at(bell, x));
  double sum = 0;
  for (const auto& bell : likelihood)
    if (const double below = log_at(bell, x) - greatest; below > nothing) sum += below < 0 ? elementary::exp(below) : 1;
  return sum > 1 ? greatest + elementary::log(sum) : greatest;
}

double log_of_product(std::span<const Likelihood> factors, double x) {
  double sum = 0;
  for (const auto& factor : factors) sum += log_of(factor, x);
  return sum;
}

double climbed(std::span<const Likelihood> factors, double x) {
  constexpr int steps = 200;
  constexpr double small = 1e-9;  // of the width: ln of the product is then known to its square
  for (int i = 0; i < steps; ++i) {
    // Each factor as its bells weigh at x, which is nowhere above it: the peak of their product is no lower.
    double pull = 0, curvature = 0;
    for (const auto& factor : factors) {
      const double whole = log_of(factor, x);
      for (const auto& bell : factor) {
        const double share = elementary::exp(log_at(bell, x) - whole);
        pull += share * (bell.slope - bell.curvature * (x - bell.at));
        curvature += share * bell.curvature;
      }
    }
    if (!(curvature > 0)) return x;
    const double step = pull / curvature;
    x += step;
    if (std::abs(step) * std::sqrt(curvature) < small) break;
  }
  return x;
}

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
  // The density is the slope.
  const Cubic cubic(below_[i], below_[i + 1], step_ * density_[i], step_ * density_[i + 1]);
  return std::clamp(cubic.at(places - static_cast<double>(i)).value, below_[i], below_[i + 1]);
}

double LineDensity::quantile(double probability) const {
  const auto is_beyond = [&](double x) { return !(probability_below(x) < probability); };
  return halved(60, {begin_, place(size() - 1)}, is_beyond).middle();
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

namespace {

// ln of a likelihood where it is greatest.
double greatest_log(const Likelihood& likelihood) {
  const auto middle = [](const Bell& bell) {
    return bell.curvature > 0 ? bell.at + bell.slope / bell.curvature : bell.at;
  };
  const auto best = std::max_element(likelihood.begin(), likelihood.end(), [&](const Bell& a, const Bell& b) {
    return log_of(likelihood, middle(a)) < log_of(likelihood, middle(b));
  });
  return log_of(likelihood, climbed({&likelihood, 1}, middle(*best)));
}

// Twice ln of how much less likely the records are at one value than each at its own.
double chi_squared_of(const std::vector<Likelihood>& records) {
  constexpr double step = 0.25;
  const auto product = density_of_product(records, step).density;
  std::size_t best = 0;
  for (std::size_t i = 0; i < product.size(); ++i)
    if (product.at(i) > product.at(best)) best = i;
  double apart = -log_of_product(records, climbed(records, product.place(best)));
  for (const auto& record : records) apart += greatest_log(record);
  return std::max(2 * apart, 0.0);
}

}  // namespace

PriorKnowledge prior_told_to(std::span<const Marginal> tests) {
  PriorKnowledge prior{0, 0};
  for (const auto& test : tests) {
    prior.mean += test.prior_mean;
    prior.deviation += test.prior_deviation;
  }
  const auto n = static_cast<double>(tests.size());
  return {prior.mean / n, prior.deviation / n};
}

bool tells(const Marginal& test) {
  constexpr double min_weight = 0.1;
  const bool sought = std::all_of(test.posterior.begin(), test.posterior.end(), [](const NormalPart& part) {
    return part.deviation > 0 && std::isfinite(part.mean);
  });
  if (test.posterior.empty() || !sought) return false;
  const double deviation = deviation_of(test.posterior);
  return (1 + min_weight) * deviation * deviation < test.prior_deviation * test.prior_deviation;
}

SharedValue share(std::span<const Marginal> tests, const PriorKnowledge& prior) {
  constexpr double step = 0.25;
  SharedValue shared{{}, 0, 0, 1};
  std::vector<Likelihood> factors, telling;
  for (const auto& test : tests) {
    factors.push_back(likelihood_of(test));
    if (tells(test)) telling.push_back(factors.back());
  }
  if (std::isfinite(prior.deviation)) factors.push_back(likelihood_of_normal(prior.mean, prior.deviation));
  const auto density = density_of_product(factors, step).density;
  shared.estimate = {density.quantile(0.5), density.deviation(), density.quantile(0.025), density.quantile(0.975)};
  shared.telling = telling.size();
  if (telling.size() > 1) {
    shared.chi_squared = chi_squared_of(telling);
    shared.agreement = chi_squared_beyond(shared.chi_squared, static_cast<double>(telling.size() - 1));
  }
  return shared;
}

Marginal shifted(Marginal marginal, double by) {
  for (auto& part : marginal.posterior) part.mean += by;
  marginal.prior_mean += by;
  return marginal;
}

Marginal of_logarithm(const Estimate& estimate) {
  if (!(0 < estimate.low && estimate.low < estimate.value && estimate.value < estimate.high))
    throw std::invalid_argument("no logarithm of " + std::to_string(estimate.value) + " within " +
                                std::to_string(estimate.low) + " to " + std::to_string(estimate.high));
  constexpr double width = 2 * two_sided_95;  // standard deviations of a 95 % interval
  const double deviation = (elementary::log(estimate.high) - elementary::log(estimate.low)) / width;
  return {{{1, elementary::log(estimate.value), deviation}}, 0, infinity};
}

namespace {

constexpr double farthest = 6;              // of the scale of T, beyond which its prior leaves nothing
constexpr double negligible_spread = 16;    // ln of how far below the greatest value
constexpr std::size_t coarse_spreads = 24;  // at T, each two thirds of the one before: down to the scale over 2000
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
    for (double spread = farthest * typical_.deviation; at.size() < coarse_spreads; spread *= closer) {
      at.push_back(spread);
      logs.push_back(slice(spread, coarse).log_density + elementary::log(spread));
    }
    const auto best = std::max_element(logs.begin(), logs.end());
    const auto matters = [&](double log) { return log > *best - negligible_spread; };
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
      const auto is_beyond = [&](double x) {
        double below = 0;
        for (std::size_t j = 0; j < slices.size(); ++j) below += weights[j] * slices[j].mean.probability_below(x);
        return !(below < probability * total);
      };
      return halved(50, {low, high}, is_beyond).middle();
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
