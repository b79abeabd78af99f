#include "inference/likelihood.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fibre/elementary.h"
#include "fibre/limits.h"

namespace flexslip {
namespace {

constexpr double reach = 3;      // deviations of a part, beyond which its quotient does not rise
constexpr double nothing = -37;  // ln of what is lost in the rounding of a sum

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
    bells.push_back({height + 0.5 * (m - p) * slope, m, slope, std::max(own, std::abs(slope) / (reach * s))});
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

}  // namespace flexslip
