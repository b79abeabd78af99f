#include "inference/shared_parameter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "fibre/chi_squared.h"
#include "fibre/elementary.h"
#include "fibre/limits.h"
#include "inference/likelihood.h"
#include "inference/line_density.h"

namespace flexslip {
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
  constexpr double least_weight = 0.1;
  const bool sought = std::all_of(test.posterior.begin(), test.posterior.end(), [](const NormalPart& part) {
    return part.deviation > 0 && std::isfinite(part.mean);
  });
  if (test.posterior.empty() || !sought) return false;
  const double deviation = deviation_of(test.posterior);
  return (1 + least_weight) * deviation * deviation < test.prior_deviation * test.prior_deviation;
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
  constexpr double width = 2 * 1.959964;  // standard deviations of a 95 % interval
  const double deviation = (elementary::log(estimate.high) - elementary::log(estimate.low)) / width;
  return {{{1, elementary::log(estimate.value), deviation}}, 0, infinity};
}

}  // namespace flexslip
