#include "inference/population.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "numerics/elementary.h"
#include "numerics/minimum.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// The mean for one spread between specimens, and the likelihood of this spread.
struct AtSpread {
  double weight = 0;          // Σ w, w = 1/(standard_error² + spread²)
  double mean = 0;            // Σ w y/Σ w
  double squares = 0;         // Σ w (y - mean)²
  double log_likelihood = 0;  // restricted, up to a constant
};

AtSpread at_spread(std::span<const Measured> tests, double spread) {
  AtSpread at;
  const auto weight_of = [spread](const Measured& test) {
    return 1 / (test.standard_error * test.standard_error + spread * spread);
  };
  for (const Measured& test : tests) {
    const double w = weight_of(test);
    at.weight += w;
    at.mean += (test.value - at.mean) * w / at.weight;
    at.log_likelihood += 0.5 * elementary::log(w);
  }
  for (const Measured& test : tests) at.squares += weight_of(test) * (test.value - at.mean) * (test.value - at.mean);
  at.log_likelihood -= 0.5 * (elementary::log(at.weight) + at.squares);
  return at;
}

}  // namespace

std::optional<Measured> measured_by_record(const Marginal& marginal) {
  if (marginal.posterior.empty()) return std::nullopt;
  const double mean = mean_of(marginal.posterior), deviation = deviation_of(marginal.posterior);
  const double information = 1 / (deviation * deviation);
  const double prior = 1 / (marginal.prior_deviation * marginal.prior_deviation);
  const double own = information - prior;
  if (!(own >= prior && std::isfinite(information) && std::isfinite(mean))) return std::nullopt;
  return Measured{(mean * information - marginal.prior_mean * prior) / own, 1 / std::sqrt(own)};
}

Population population_of(std::span<const Measured> tests) {
  if (tests.size() < min_tests_of_population)
    throw std::invalid_argument("a population of " + std::to_string(tests.size()) + " tests");
  const auto by_value = [](const Measured& a, const Measured& b) { return a.value < b.value; };
  const auto [least, most] = std::minmax_element(tests.begin(), tests.end(), by_value);
  const double range = most->value - least->value;
  const auto log_likelihood = [&](double spread) { return at_spread(tests, spread).log_likelihood; };
  // With different errors the likelihood may have several maxima, all within the range of the
  // estimates.
  constexpr int steps = 64;
  int best = 0;
  for (int i = 1; i <= steps; ++i)
    if (log_likelihood(range * i / steps) > log_likelihood(range * best / steps)) best = i;
  Greatest greatest{range * best / steps, log_likelihood(range * best / steps)};
  if (range > 0) {
    const double low = range * std::max(best - 1, 0) / steps, high = range * std::min(best + 1, steps) / steps;
    const Greatest between = greatest_within(log_likelihood, low, high, 2.5e-7 * range);
    if (between.value > greatest.value) greatest = between;
  }
  constexpr double within_95 = 1.92;  // half of the 95 % quantile of chi squared with one degree of freedom
  const auto is_unlikely = [&](double spread) { return log_likelihood(spread) < greatest.value - within_95; };
  double beyond = std::max(range, tests.front().standard_error);
  while (!is_unlikely(beyond)) beyond *= 2;
  const AtSpread at = at_spread(tests, greatest.at);
  const auto freedom = static_cast<double>(tests.size() - 1);
  const double standard_error = std::sqrt(std::max(at.squares / freedom, 1.0) / at.weight);
  return {.tests = tests.size(),
          .typical = student_estimate(at.mean, standard_error, freedom),
          .spread = greatest.at,
          .min_spread = first_where(greatest.at, 0, is_unlikely),
          .max_spread = first_where(greatest.at, beyond, is_unlikely)};
}

}  // namespace flexslip
